// The front page: a card a scene, search and filters, and the words of everything else.
#include "site.h"
#include "words.h"

#include <algorithm>

namespace plait {
namespace {

std::string optionOf(const std::string& value, const std::string& words) {
    return "<option value=\"" + escaped(value) + "\">" + escaped(words) + "</option>";
}

std::string selectOf(const std::string& facet, const std::string& label,
                     const std::string& options) {
    return "<label>" + label + " <select name=\"" + facet + "\" data-facet=\"" + facet + "\">" +
           optionOf("", "any") + options + "</select></label>\n";
}

// Effects, constraints, methods and sections that any scene has.
std::string filterForm(const Site& site) {
    std::string effects, constraints, methods, seeds;
    for (const std::string& effect : allEffects()) effects += optionOf(slugOf(effect), effect);
    for (const Topic& topic : topics()) {
        if (topic.sort == TopicSort::force) continue;
        std::string& options = topic.sort == TopicSort::method ? methods : constraints;
        options += optionOf(topic.name, topic.title);
    }
    for (const SeedSection& section : site.seeds.sections)
        seeds += optionOf(slugOf(section.id), section.id + " " + section.words);
    return "<form class=\"filter\" role=\"search\" hidden>\n<label>Search <input type=\"search\" "
           "name=\"search\" autocomplete=\"off\" aria-describedby=\"found\"></label>\n" +
           selectOf("effect", "Effect", effects) +
           selectOf("constraint", "Constraint", constraints) +
           selectOf("method", "Method", methods) + selectOf("seeds", "Seeds", seeds) +
           "<button type=\"reset\">Show all</button>\n<p id=\"found\" "
           "role=\"status\"></p>\n</form>\n";
}

std::string joinedSlugs(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : " ") + slugOf(word);
    return all;
}

// Methods that a scene is solved by: its own, and those of its studies.
std::vector<std::string> methodsOf(const SceneFacts& scene) {
    std::vector<std::string> methods{scene.method()};
    for (const Study& study : studies()) {
        if (valueOf(study.model, "scene") != scene.entry->name) continue;
        for (const StudyCurve& curve : study.curves)
            for (const Settings& task : curve.tasks)
                if (const std::string method = valueOf(task, "method");
                    !method.empty() && std::ranges::count(methods, method) == 0)
                    methods.push_back(method);
    }
    return methods;
}

std::string cardOf(const Site& site, const SceneFacts& scene) {
    const SceneEntry& entry = *scene.entry;
    std::vector<std::string> constraints;
    std::string words = entry.name + " " + entry.lesson;
    for (const Topic* topic : scene.topics()) {
        constraints.push_back(topic->name);
        words += " " + topic->title;
    }
    for (const std::string& word : entry.ingredients) words += " " + word;
    for (const std::string& word : scene.effects) words += " " + word;
    const std::string clip = site.left.clip(entry.name), picture = site.left.picture(entry.name);
    return R"(<li class="card slide" data-words=")" + escaped(words) + "\" data-effect=\"" +
           joinedSlugs(scene.effects) + "\" data-constraint=\"" + joinedSlugs(constraints) +
           "\" data-method=\"" + joinedSlugs(methodsOf(scene)) + "\" data-seeds=\"" +
           joinedSlugs(site.sectionsOf(scene)) + "\">\n" + clipOf(clip, picture, entry.title) +
           "<h2><a href=\"scenes/" + entry.name + ".html\">" + escaped(entry.title) +
           "</a></h2>\n<p>" + escaped(entry.lesson) + ".</p>\n" +
           (clip.empty() ? "<p class=\"note\">No clip yet: <code>build/plait run " + entry.name +
                               " -q " + scene.quality + "</code></p>\n"
                         : std::string()) +
           "</li>\n";
}

// Demos first: they are what one comes for.
std::string cards(const Site& site) {
    std::string html = "<ul class=\"cards scenes\">\n";
    for (const bool demo : {true, false})
        for (const SceneFacts& scene : site.scenes)
            if (scene.entry->demo == demo) html += cardOf(site, scene);
    return html + "</ul>\n";
}

std::string reportLinks() {
    std::string html;
    for (const ReportFile& report : reportFiles)
        html +=
            (html.empty() ? "" : ", ") + linkTo(report.room + std::string(".html"), report.title);
    return html;
}

// Found by the search only.
std::string otherPages() {
    std::string html;
    const auto add = [&](const std::string& href, const std::string& title,
                         const std::string& words) {
        html += "<li hidden data-words=\"" + escaped(title + " " + words) + "\">" +
                linkTo(href, title) + " <span>" + escaped(words) + "</span></li>\n";
    };
    for (const Topic& topic : topics())
        add(folderOf(topic.sort) + "/" + topic.name + ".html", topic.title, topic.lesson);
    for (const SeedWord& word : seedWords())
        add("dictionary.html#" + anchorOf(word), word.word, word.here);
    return "<section class=\"other\" hidden aria-labelledby=\"other-heading\"><h2 "
           "id=\"other-heading\">"
           "Beside scenes</h2><ul>\n" +
           html + "</ul></section>\n";
}

}  // namespace

SitePage frontPage(Site& site) {
    return {
        .path = "index.html",
        .title = "Effects catalogue",
        .room = "scenes",
        .body =
            "<div class=\"intro\"><h1>Effects catalogue</h1>\n<p class=\"lesson\">Cloth, wires, "
            "rubber, glass and water are one kind of matter here: points, edges, triangles and "
            "tetrahedra, and constraints that say what must hold between them. Each scene "
            "teaches one thing.</p>\n<p>All of it in figures: " +
            reportLinks() + ".</p>\n</div>\n" + filterForm(site) + cards(site) + otherPages(),
        .next = "scenes/" + site.scenes.front().entry->name + ".html"};
}

}  // namespace plait
