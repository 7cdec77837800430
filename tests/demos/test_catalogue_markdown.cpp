// What is validated and where it fails, as pages: the Markdown that they are written in.
#include "demos/catalogue/markdown.h"
#include "demos/catalogue/site.h"
#include "program.h"
#include "scenes/scene.h"
#include "site_reader.h"
#include "tests/catch.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

using namespace plait;
using namespace plait::test;

namespace {

MarkdownText readText(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return readMarkdown(lines,
                        [](const std::string& code) { return code == "flag" ? "f.html" : ""; });
}

std::string refusal(const std::string& text) {
    try {
        readText(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "read";
}

}  // namespace

TEST_CASE("catalogue: Markdown becomes a title, a lead and sections", "[effects-catalogue]") {
    const MarkdownText text = readText(
        "# A title\n\nA lead of\ntwo lines.\n\n## First & last\n\n- one\n  goes on\n- **two**, *a* "
        "`b*c`\n\nAfter `flag`.\n\n    a < b\n      c\n\n| x | y |\n|---|---|\n| 1 |  |\n\n"
        "| z |\n|---|\n| 2 |\n");
    CHECK(text.title == "A title");
    CHECK(text.lead == "<p>A lead of two lines.</p>\n");
    REQUIRE(text.sections.size() == 1);
    CHECK(text.sections[0].heading == "First & last");
    const std::string& html = text.sections[0].html;
    CHECK(contains(html,
                   "<ul>\n<li>one goes on</li>\n<li><strong>two</strong>, <em>a</em> "
                   "<code>b*c</code></li>\n</ul>\n"));
    CHECK(contains(html, "<p>After <a href=\"f.html\"><code>flag</code></a>.</p>"));
    CHECK(contains(html, "<code>a &lt; b\n  c</code></pre>"));
    CHECK(contains(html, "<th scope=\"row\">1</th><td></td>"));
    CHECK(contains(html, "First &amp; last, table 2"));
}

TEST_CASE("catalogue: Markdown that is not known is refused in a line", "[effects-catalogue]") {
    CHECK(refusal("# A\n\nb\n") == "read");
    CHECK(refusal("A\n") == "line 1: no \"# title\"");
    CHECK(refusal("") == "line 1: no \"# title\"");
    for (const char* bad :
         {"### b", "> b", "1. b", "* b", "```", "![b](c)", "[b](c)", "`b", "*b", "**b", " b",
          "- b\n  - c", "| b |", "| b |\n| c |", "| b |\n|---|\n| c | d |", "| b | |\n|---|---|",
          "| b |\n|---|\n| c", "b\n---", "b\n# c"}) {
        INFO(bad);
        CHECK(contains(refusal("# A\n\n" + std::string(bad) + "\n"), "line "));
        CHECK_FALSE(contains(refusal("# A\n\n" + std::string(bad) + "\n"), "\n"));
    }
    CHECK(refusal("# A\n\nb\n\nc [d](e)\n") == "line 5: links are not known here");
}

TEST_CASE("catalogue: what is validated and where it fails have a section a matter",
          "[effects-catalogue]") {
    for (const ReportFile& report : reportFiles) {
        INFO(report.file);
        std::istringstream in(contents(std::string(PLAIT_ROOT "/") + report.file));
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        int links = 0;
        const MarkdownText text = readMarkdown(lines, [&](const std::string& code) {
            links += static_cast<int>(std::ranges::count_if(
                scenes(), [&](const SceneEntry& entry) { return entry.name == code; }));
            return "";
        });
        CHECK(text.title == report.title);
        for (const char* matter : {"Cloth", "Contact", "Rods", "Gas", "Pieces and glass", "Liquid",
                                   "Methods", "Determinism"})
            CHECK(std::ranges::count(text.sections, matter, &MarkdownSection::heading) == 1);
        CHECK(links > 3);
    }
}
