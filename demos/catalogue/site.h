// The site as a whole.
#pragma once

#include "facts.h"
#include "leftovers.h"
#include "page.h"
#include "sources.h"
#include "tests.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plait {

struct SiteOptions {
    std::filesystem::path out = "out/catalogue", runs = "out", sources = ".";
    std::string quality = "draft";  // of schedules, bands and sizes
    std::string only = "";          // a scene: the rest of the site stays as it is
    bool film = false;              // what nobody has filmed yet, at that quality
    int threads = 1;
    bool quiet = false;
};

// What pages are made from.
struct Site {
    SiteOptions options;
    Sources sources;
    Seeds seeds;
    Leftovers left;
    std::vector<SceneFacts> scenes;

    explicit Site(const SiteOptions& asked);

    // Scenes that a topic has a part in.
    std::vector<const SceneFacts*> scenesWith(const Topic& topic) const;
    // Sections of the seeds that a scene's tests and ingredients hold rows of: "DC", ...
    std::vector<std::string> sectionsOf(const SceneFacts& scene) const;
    // Rows of the seeds as links to the dictionary's table of rows, "DC3 fold and twist".
    std::vector<std::string> rowLinks(const std::vector<std::string>& ids,
                                      const std::string& root) const;
    // A link to a line of a source, with the file's name as its words.
    std::string sourceLink(const std::string& root, const std::string& file, int line,
                           const std::string& words = "");
};

// Makes all pages, or those of one scene. Throws UsageError for a scene that is not there,
// FileError and Interrupted. Returns the path of the page to open.
std::filesystem::path makeSite(const SiteOptions& options);

// A file each.
SitePage frontPage(Site& site);
SitePage scenePage(Site& site, const SceneFacts& scene);
SitePage topicPage(Site& site, const Topic& topic);
SitePage topicsPage(Site& site, TopicSort sort);
SitePage dictionaryPage(Site& site);
SitePage sourcePage(const Site& site, const std::string& file);

// A file in Markdown that is a page of its own; `code` that names a scene leads to it.
struct ReportFile {
    const char *room, *file, *title;
};
constexpr ReportFile reportFiles[] = {{"validated", "tests/validated.md", "What is validated"},
                                      {"limits", "tests/limits.md", "Where it fails"}};
// Throws FileError for what readMarkdown refuses.
SitePage reportPage(Site& site, const ReportFile& report);

// Parts of the page of a scene, each a section.
std::string scheduleSection(const SceneFacts& scene);
std::string equationSection(const SceneFacts& scene);
std::string knobSection(const Site& site, const SceneFacts& scene);
std::string metricSection(const Site& site, const SceneFacts& scene);
std::string ledgerSection(const Site& site, const SceneFacts& scene);
std::string studySection(const Site& site, const SceneFacts& scene);
std::string failureSection(const Site& site, const SceneFacts& scene);
std::string testSection(Site& site, const SceneFacts& scene);
std::string sourceSection(Site& site, const SceneFacts& scene);
std::string commandSection(const SceneFacts& scene);

// A clip that loops without sound, or its picture; what it shows in words. Paths from the page.
std::string clipOf(const std::string& clip, const std::string& picture, const std::string& words);

// A map with its words and its command, for pages in a folder.
std::string mapFigure(const Site& site, const StabilityMap& map);

// The style and the script of the site (assets/).
extern const char* const catalogueStyle;
extern const char* const catalogueScript;

}  // namespace plait
