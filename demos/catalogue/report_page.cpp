// What is validated, and where it fails: two files of tests/, as pages.
#include "demos/tools/errors.h"
#include "markdown.h"
#include "site.h"

#include <algorithm>

namespace plait {

SitePage reportPage(Site& site, const ReportFile& report) {
    const std::string file = report.file;
    const auto sceneOf = [](const std::string& code) {
        const bool named = std::ranges::any_of(
            scenes(), [&](const SceneEntry& entry) { return entry.name == code; });
        return named ? "scenes/" + code + ".html" : std::string();
    };
    MarkdownText text;
    try {
        text = readMarkdown(site.sources.lines(file), sceneOf);
    } catch (const std::invalid_argument& error) {
        throw FileError((site.sources.root() / file).string() + ": " + error.what());
    }
    SitePage page{.path = report.room + std::string(".html"),
                  .title = text.title,
                  .room = report.room,
                  .body = "<div class=\"intro\"><h1>" + escaped(text.title) + "</h1>\n" +
                          text.lead + "<p class=\"note\">From " + site.sourceLink("", file, 0) +
                          ".</p>\n</div>\n"};
    std::string contents;
    for (const MarkdownSection& section : text.sections)
        contents += "<li>" + linkTo("#" + slugOf(section.heading), section.heading) + "</li>";
    page.body += "<ul class=\"tags\">" + contents + "</ul>\n";
    for (const MarkdownSection& section : text.sections)
        page.body += sectionOf(slugOf(section.heading), section.heading, section.html);
    return page;
}

}  // namespace plait
