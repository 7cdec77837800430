#include "site.h"

#include "demos/tools/errors.h"
#include "demos/tools/files.h"
#include "demos/tools/interrupt.h"
#include "demos/tools/progress.h"
#include "films.h"

#include <algorithm>
#include <set>

namespace plait {
namespace {

namespace fs = std::filesystem;

void writePage(const Site& site, const SitePage& page) {
    const fs::path to = site.options.out / page.path;
    makeFolder(to.parent_path());
    writeWhole(to, htmlOf(page));
}

void writeSources(Site& site) {
    for (const std::string& file : site.sources.linked()) writePage(site, sourcePage(site, file));
}

// Scenes come one after the other in a lecture.
void joinScenes(SitePage& page, const Site& site, std::size_t i) {
    const auto pathOf = [&](std::size_t s) {
        return "scenes/" + site.scenes[s].entry->name + ".html";
    };
    if (i > 0) page.previous = pathOf(i - 1);
    page.next = i + 1 < site.scenes.size() ? pathOf(i + 1) : "index.html";
}

// Clips of scenes first: they are what one misses most.
std::vector<Film> filmsAsked(const SiteOptions& options) {
    std::vector<Film> clips, knobs;
    for (const SceneEntry& entry : scenes())
        if (options.only.empty() || options.only == entry.name)
            for (Film& film : filmsOf(entry, options.quality))
                (film.knob.empty() ? clips : knobs).push_back(std::move(film));
    for (Film& film : knobs) clips.push_back(std::move(film));
    return clips;
}

void writeTopics(Site& site) {
    for (const Topic& topic : topics()) writePage(site, topicPage(site, topic));
    for (const TopicSort sort : {TopicSort::constraint, TopicSort::method, TopicSort::force})
        writePage(site, topicsPage(site, sort));
}

}  // namespace

Site::Site(const SiteOptions& asked)
    : options(asked),
      sources(asked.sources),
      seeds(readSeeds(sources)),
      left(asked.runs, asked.sources / "golden", asked.out) {}

std::vector<const SceneFacts*> Site::scenesWith(const Topic& topic) const {
    std::vector<const SceneFacts*> found;
    for (const SceneFacts& scene : scenes)
        if (const auto all = scene.topics(); std::ranges::count(all, &topic) > 0)
            found.push_back(&scene);
    return found;
}

std::vector<std::string> Site::sectionsOf(const SceneFacts& scene) const {
    std::set<std::string> ids;
    for (const SeedTest* test : seeds.running(scene.entry->name))
        for (const std::string& id : test->rows()) ids.insert(id.substr(0, 2));
    for (const Topic* topic : scene.topics())
        for (const std::string& id : topic->rows) ids.insert(id.substr(0, 2));
    std::vector<std::string> ordered;
    for (const SeedSection& section : seeds.sections)
        if (ids.contains(section.id)) ordered.push_back(section.id);
    return ordered;
}

std::vector<std::string> Site::rowLinks(const std::vector<std::string>& ids,
                                        const std::string& root) const {
    std::vector<std::string> links;
    for (const std::string& id : ids)
        if (const SeedRow* row = seeds.row(id))
            links.push_back(linkTo(root + "dictionary.html#" + id, id + " " + row->words));
    return links;
}

std::string Site::sourceLink(const std::string& root, const std::string& file, int line,
                             const std::string& words) {
    return linkTo(
        root + sources.link(file, line),
        !words.empty() ? words : file + (line > 0 ? ":" + std::to_string(line) : std::string()));
}

fs::path makeSite(const SiteOptions& options) {
    if (!options.only.empty()) sceneNamed(options.only);
    makeFolder(options.out);
    const FolderLock lock(options.out);
    if (options.film) makeFilms(filmsAsked(options), options.runs, options.threads, options.quiet);
    Site site(options);
    const int count = static_cast<int>(scenes().size());
    Progress progress("catalogue", 0, 2 * count + 1, options.quiet, "pages");
    int done = 0;
    for (const SceneEntry& entry : scenes()) {
        stopIfInterrupted();
        site.scenes.push_back(factsOf(entry, options.quality));
        progress.show(++done);
    }
    for (std::size_t i = 0; i < site.scenes.size(); ++i, progress.show(++done)) {
        stopIfInterrupted();
        const SceneFacts& scene = site.scenes[i];
        if (!options.only.empty() && scene.entry->name != options.only) continue;
        SitePage page = scenePage(site, scene);
        joinScenes(page, site, i);
        writePage(site, page);
    }
    writePage(site, frontPage(site));
    writePage(site, dictionaryPage(site));
    for (const ReportFile& report : reportFiles) writePage(site, reportPage(site, report));
    writeTopics(site);
    writeSources(site);
    writeWhole(options.out / "style.css", catalogueStyle);
    writeWhole(options.out / "script.js", catalogueScript);
    progress.show(++done);
    return options.only.empty() ? options.out / "index.html"
                                : options.out / "scenes" / (options.only + ".html");
}

}  // namespace plait
