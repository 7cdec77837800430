// The page of a constraint, a method or a force, and the list of those of a sort.
#include "formula.h"
#include "site.h"

#include <algorithm>
#include <map>

namespace plait {
namespace {

std::string openingOf(const Sources& sources, const std::string& header) {
    std::string html;
    for (const std::string& paragraph : sources.opening(header))
        html += paragraph[0] == ' ' ? "<pre tabindex=\"0\">" + escapedLines(paragraph) + "</pre>\n"
                                    : "<p>" + escaped(paragraph) + "</p>\n";
    return html;
}

std::string cardsOf(const Site& site, const std::vector<const SceneFacts*>& scenes) {
    std::string html = "<ul class=\"cards\">\n";
    for (const SceneFacts* scene : scenes) {
        const std::string picture = site.left.picture(scene->entry->name);
        html += "<li><a href=\"../scenes/" + scene->entry->name + ".html\">" +
                (picture.empty() ? std::string("<span class=\"clip none\"></span>")
                                 : R"(<img class="clip" src="../)" + picture +
                                       R"(" alt="" width="480" height="270" loading="lazy">)") +
                "<b>" + escaped(scene->entry->title) + "</b></a><p>" +
                escaped(scene->entry->lesson) + ".</p></li>\n";
    }
    return html + "</ul>\n";
}

std::string sortWord(TopicSort sort) {
    return sort == TopicSort::constraint ? "Constraint"
           : sort == TopicSort::method   ? "Method"
                                         : "Force";
}

std::string heldRows(Site& site, const Topic& topic) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& id : topic.rows) {
        const SeedRow* row = site.seeds.row(id);
        std::string tests;
        for (const SeedTest* test : site.seeds.holding(id))
            tests += "<br>" + site.sourceLink("../", test->file, test->line, test->name);
        rows.push_back({linkTo("../dictionary.html#" + id, id), escaped(row->words),
                        tests.empty() ? "open" : tests.substr(4)});
    }
    return rows.empty() ? ""
                        : sectionOf("seeds", "What the seeds ask, and which tests hold it",
                                    tableOf("Rows of the seeds", {"row", "what", "held by"}, rows));
}

std::string mapsOfTopic(const Site& site, const Topic& topic) {
    std::string html;
    for (const std::string& name : topic.maps) html += mapFigure(site, stabilityMapNamed(name));
    return html.empty() ? "" : sectionOf("failures", "Where it fails", html);
}

// Studies that try a method, each with the scene that it is of.
std::string studiesOfMethod(const Topic& topic) {
    std::vector<std::string> items;
    for (const Study& study : studies()) {
        const bool tries = std::ranges::any_of(study.curves, [&](const StudyCurve& curve) {
            return std::ranges::any_of(curve.tasks, [&](const Settings& task) {
                return valueOf(task, "method") == topic.marks[0];
            });
        });
        if (const std::string scene = valueOf(study.model, "scene"); tries)
            items.push_back(linkTo("../scenes/" + scene + ".html#accuracy", study.title));
    }
    return items.empty()
               ? ""
               : sectionOf("studies", "Measured beside the others",
                           "<p>Studies that try this method on a scene:</p>" + listOf(items));
}

}  // namespace

SitePage topicPage(Site& site, const Topic& topic) {
    SitePage page{.path = folderOf(topic.sort) + "/" + topic.name + ".html",
                  .title = topic.title,
                  .room = folderOf(topic.sort),
                  .body = {}};
    std::string formulas;
    for (const Equation& equation : topic.equations)
        formulas += "<figure class=\"formula\">" + mathMl(equation.tex) + "<figcaption>" +
                    withFormulas(equation.words) + "</figcaption></figure>\n";
    page.body = R"(<section class="slide" id="lesson" aria-labelledby="title"><p class="sort">)" +
                sortWord(topic.sort) + "</p>\n<h1 id=\"title\">" + escaped(topic.title) +
                "</h1>\n<p class=\"lesson\">" + escaped(topic.lesson) + "</p>\n" + formulas +
                "</section>\n";
    const std::vector<const SceneFacts*> with = site.scenesWith(topic);
    page.body += sectionOf(
        "scenes", with.empty() ? "Scenes" : "Scenes that it has a part in",
        with.empty()
            ? topic.sort == TopicSort::method
                  ? "<p>No scene takes it by itself; any may be told to:</p>" +
                        commandLine("build/plait run pendulum -q draft --method " + topic.marks[0])
                  : std::string("<p>No scene has it by itself: tests and programs "
                                "of one's own do.</p>")
            : cardsOf(site, with));
    if (topic.sort == TopicSort::method) page.body += studiesOfMethod(topic);
    page.body += mapsOfTopic(site, topic) + heldRows(site, topic);
    page.body +=
        sectionOf("source", "In the words of its source",
                  "<blockquote>" + openingOf(site.sources, topic.header) + "</blockquote>\n<p>" +
                      site.sourceLink("../", topic.header, 0) + "</p>\n");
    return page;
}

SitePage topicsPage(Site& site, TopicSort sort) {
    const std::string word = sortWord(sort);
    SitePage page{.path = folderOf(sort) + "/index.html",
                  .title = word + "s",
                  .room = folderOf(sort),
                  .body = {}};
    std::string html;
    for (const Topic& topic : topics()) {
        if (topic.sort != sort) continue;
        const std::size_t count = site.scenesWith(topic).size();
        html += "<article><h2>" + linkTo(topic.name + ".html", topic.title) + "</h2><p>" +
                escaped(topic.lesson) + "</p>" + mathMl(topic.equations.front().tex) +
                "<p class=\"note\">" +
                (count == 0 ? "in no scene by itself"
                            : "in " + std::to_string(count) + (count == 1 ? " scene" : " scenes")) +
                "</p></article>\n";
    }
    const std::string lead =
        sort == TopicSort::constraint ? "A constraint says of a few points what must hold, as that "
                                        "two keep their distance. Every "
                                        "effect here is a sum of such constraints."
        : sort == TopicSort::method
            ? "A method makes all constraints hold together, as well as it can in the time it has. "
              "All "
              "methods here solve the same equations, so that they can be compared."
            : "A force acts from outside, before constraints are asked.";
    page.body = "<h1>" + word + "s</h1>\n<p class=\"lesson\">" + lead +
                "</p>\n<div class=\"equations\">\n" + html + "</div>\n";
    return page;
}

SitePage sourcePage(const Site& site, const std::string& file) {
    return {.path = "source/" + file + ".html",
            .title = file,
            .room = "source",
            .body = "<h1 class=\"file\">" + escaped(file) + "</h1>\n" + site.sources.listing(file)};
}

}  // namespace plait
