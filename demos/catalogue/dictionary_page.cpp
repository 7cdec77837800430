// The dictionary: words of the seeds, then their 330 rows with the tests that hold each.
#include "site.h"
#include "words.h"

namespace plait {
namespace {

std::string stateOf(const Seeds& seeds, const std::string& id) {
    const std::size_t tests = seeds.holding(id).size();
    if (tests == 0) return "<span class=\"state open\">open</span>";
    return "<span class=\"state held\">held by " + std::to_string(tests) +
           (tests == 1 ? " test</span>" : " tests</span>");
}

std::string wordTable(const Site& site, const std::string& seed) {
    std::string html =
        R"(<div class="wide" tabindex="0" role="region" aria-label="Table of the words of )" +
        seed + R"("><table class="words"><caption>Words of )" + seed +
        "</caption><thead><tr><th scope=\"col\">word</th><th scope=\"col\">what it is here</th>"
        "<th scope=\"col\">rows of the seeds</th></tr></thead><tbody>\n";
    for (const SeedWord& word : seedWords()) {
        if (word.seed != seed) continue;
        std::string rows;
        for (const std::string& id : word.rows)
            rows += "<li>" + linkTo("#" + id, id) + " " + escaped(site.seeds.row(id)->words) +
                    ", " + stateOf(site.seeds, id) + "</li>";
        html += "<tr id=\"" + anchorOf(word) + "\" data-words=\"" +
                escaped(word.word + " " + word.here) + R"("><th scope="row">)" +
                escaped(word.word) + "</th><td>" + escaped(word.here) + "</td><td><ul>" + rows +
                "</ul></td></tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string sectionTable(Site& site, const SeedSection& section) {
    std::string html = "<h3 id=\"" + section.id + "\">" + section.id + " " +
                       escaped(section.words) + "</h3><p>" +
                       linkTo("index.html#seeds=" + slugOf(section.id), "Scenes of this section") +
                       "</p>\n<dl class=\"rows\">\n";
    for (const SeedRow& row : section.rows) {
        html += "<div id=\"" + row.id + "\"><dt>" + row.id + "</dt><dd>" + escaped(row.words) +
                ", " + stateOf(site.seeds, row.id);
        std::string tests;
        for (const SeedTest* test : site.seeds.holding(row.id))
            tests += "<li>" + site.sourceLink("", test->file, test->line, test->name) + "</li>";
        if (!tests.empty()) html += "<ul>" + tests + "</ul>";
        html += "</dd></div>\n";
    }
    return html + "</dl>\n";
}

}  // namespace

SitePage dictionaryPage(Site& site) {
    SitePage page{
        .path = "dictionary.html", .title = "Dictionary", .room = "dictionary", .body = {}};
    page.body =
        "<h1>Dictionary</h1>\n<p class=\"lesson\">What you know from Nucleus in Maya or from "
        "Vellum in "
        "Houdini, and what it is here. A row of the seeds is one thing that those two programs do "
        "and "
        "this one is to do; it is open until a test holds it.</p>\n<form class=\"filter words\" "
        "role=\"search\" hidden><label>Search <input type=\"search\" name=\"search\" "
        "autocomplete=\"off\" aria-describedby=\"found\"></label><p id=\"found\" "
        "role=\"status\"></p></form>\n" +
        sectionOf("nucleus", "Words of Nucleus",
                  "<p>From Stam, “Nucleus” (2009), and from “Nucleus in Autodesk Maya”.</p>" +
                      wordTable(site, "Nucleus")) +
        sectionOf("vellum", "Words of Vellum",
                  "<p>From notes on Houdini’s Vellum Solver.</p>" + wordTable(site, "Vellum"));
    std::string rows;
    for (const SeedSection& section : site.seeds.sections) rows += sectionTable(site, section);
    page.body += sectionOf("rows", "All rows of the seeds", rows);
    return page;
}

}  // namespace plait
