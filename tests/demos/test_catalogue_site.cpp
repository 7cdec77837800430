// The effects catalogue as files: whole, well-formed, linked both ways, and made from what is
// there.
#include "demos/catalogue/facts.h"
#include "demos/catalogue/films.h"
#include "demos/catalogue/formula.h"
#include "demos/catalogue/words.h"
#include "scenes/scene.h"
#include "site_reader.h"
#include "tests/catch.h"

#include <plait/constraints/kinds.h>

#include <set>

using namespace plait;
using namespace plait::test;

namespace {

namespace fs = std::filesystem;

Outcome makeCatalogue(const TemporaryFolder& folder, std::vector<std::string> more = {}) {
    std::vector<std::string> words{"catalogue", "--quiet",
                                   "--sources", PLAIT_ROOT,
                                   "--out",     (folder / "site").string(),
                                   "--runs",    (folder / "runs").string()};
    words.insert(words.end(), more.begin(), more.end());
    return plait::test::plait(folder, words);
}

template <class... Kind>
std::vector<std::string> namesOfKinds(KindList<Kind...>) {
    std::vector<std::string> names;
    (names.push_back(typeid(Kind).name()), ...);
    return names;
}

bool linksTo(const ReadPage& page, const std::string& to) {
    const auto links = page.named("a");
    return std::ranges::any_of(links, [&](const Element* a) {
        return a->attributes.contains("href") && a->attributes.at("href") == to;
    });
}

}  // namespace

TEST_CASE("catalogue: formulas are set as mathematics, and what is none is refused",
          "[effects-catalogue]") {
    CHECK(mathMl("a_1") ==
          "<math display=\"block\"><mrow><msub><mi>a</mi><mn>1</mn></msub></mrow>"
          "</math>");
    CHECK(contains(mathMl("\\frac{1}{h^2}", false),
                   "<mfrac><mrow><mn>1</mn></mrow><mrow><msup><mi>h</mi><mn>2</mn></msup></mrow>"));
    CHECK(contains(mathMl("a, \\quad b"), "</math><math"));
    CHECK(contains(mathMl("(\\frac{a}{b})"), "<mo>(</mo>"));
    CHECK(contains(mathMl("(a)"), "<mo stretchy=\"false\">(</mo>"));
    CHECK(withFormulas("a < $b$") == "a &lt; <math><mrow><mi>b</mi></mrow></math>");
    for (const char* bad :
         {"\\fraction{1}{2}", "{a", "a}", "a_", "a_1_2", "\\frac{1}", "a)", "\\b{xy}"})
        CHECK_THROWS_AS(mathMl(bad), std::invalid_argument);
    CHECK_THROWS_AS(withFormulas("one $ alone"), std::invalid_argument);
}

TEST_CASE("catalogue: every kind of constraint and every word of --method has its equations",
          "[effects-catalogue]") {
    std::set<std::string> pages;
    for (const Topic& topic : topics()) {
        INFO(topic.name);
        CHECK(pages.insert(folderOf(topic.sort) + "/" + topic.name).second);
        CHECK_FALSE(topic.equations.empty());
        CHECK(fs::exists(fs::path(PLAIT_ROOT) / topic.header));
        for (const Equation& equation : topic.equations) {
            CHECK_NOTHROW(mathMl(equation.tex));
            CHECK_NOTHROW(withFormulas(equation.words));
            CHECK(equation.words.ends_with("."));
        }
    }
    for (const std::string& name : namesOfKinds(Kinds{})) {
        // "N5plait2v37StretchE": the name that the mark has, with its length before it.
        INFO(name);
        CHECK(std::ranges::any_of(topics(), [&](const Topic& topic) {
            return std::ranges::any_of(topic.marks, [&](const std::string& mark) {
                const std::string kind = mark.substr(0, mark.find(','));
                return contains(name, std::to_string(kind.size()) + kind + "E");
            });
        }));
    }
    for (const SettingOption& option : settingOptions()) {
        if (option.name != "method") continue;
        std::istringstream words(option.argument);
        for (std::string word; std::getline(words, word, '|');) {
            INFO(word);
            CHECK(topicOf(TopicSort::method, word));
        }
    }
}

TEST_CASE("catalogue: the schedule of a scene is the one that its solver has",
          "[effects-catalogue]") {
    const SceneFacts band = factsOf(findScene("band"), "draft");
    const SceneFacts flag = factsOf(findScene("flag"), "draft");
    for (const SceneFacts& facts : {band, flag}) {
        const Scene scene = build(*facts.entry, Quality::draft);
        REQUIRE(facts.sets.size() == scene.world.sets.size());
        CHECK(facts.substeps == scene.options.schedule.substeps);
        CHECK(std::ranges::is_partitioned(facts.sets,
                                          [](const SetFacts& set) { return !set.contact; }));
        for (std::size_t s = 0; s < facts.sets.size(); ++s) {
            INFO(facts.sets[s].name);
            CHECK_FALSE(facts.sets[s].topics.empty());
            const auto runs = std::ranges::count_if(facts.columns, [&](const ColumnFacts& column) {
                return column.substep == 0 && column.runs[s];
            });
            CHECK(runs == facts.sets[s].evaluations);
        }
    }
    CHECK(std::ranges::count(flag.effects, "cloth") == 1);
    CHECK(std::ranges::count(flag.effects, "liquid") == 0);
}

TEST_CASE("catalogue: pages that are not well-formed, and links that lead nowhere, are found",
          "[effects-catalogue]") {
    const std::string head = "<!DOCTYPE html>";
    CHECK(readPage(head + "<p id=\"a\">b<br>&amp;<a href=\"#a\">c</a></p>").faults.empty());
    for (const char* bad :
         {"<p>", "</p>", "<p><b></p></b>", "<p id=a></p>", "<p id=\"a\" id=\"b\"></p>",
          "<p id=\"a\"></p><p id=\"a\"></p>", "<p>a & b</p>", "<p class=\"a></p>"})
        CHECK_FALSE(readPage(head + bad).faults.empty());
    CHECK_FALSE(readPage("<p></p>").faults.empty());

    const TemporaryFolder folder;
    const auto broken = [&](const std::string& link) {
        fs::create_directories(folder / "site/a");
        std::ofstream(folder / "site/b.html") << head << "<p id=\"c\"></p>";
        std::ofstream(folder / "site/a/a.html") << head << "<a href=\"" << link << "\"></a>";
        return brokenLinks(folder / "site", readSite(folder / "site")).size();
    };
    for (const char* good : {"../b.html", "../b.html#c", "a.html", "../b.html#search=d"})
        CHECK(broken(good) == 0);
    for (const char* bad : {"b.html", "../b.html#d", "#e", "https://a.b", "../../stdout", "../a"})
        CHECK(broken(bad) == 1);
}

TEST_CASE("catalogue: every page is well-formed, and every link on it leads somewhere",
          "[effects-catalogue]") {
    static const TemporaryFolder folder;  // made once, for all sections
    static const Outcome made = makeCatalogue(folder);
    INFO(made.err);
    REQUIRE(made.status == 0);
    CHECK(made.out == (folder / "site/index.html").string() + "\n");
    const std::map<std::string, ReadPage> pages = readSite(folder / "site");
    for (const auto& [path, page] : pages)
        for (const std::string& fault : page.faults) FAIL_CHECK(path << ": " << fault);
    for (const std::string& line : brokenLinks(folder / "site", pages)) FAIL_CHECK(line);

    SECTION("scenes and what they are made of are linked both ways") {
        for (const SceneEntry& entry : scenes()) {
            INFO(entry.name);
            REQUIRE(pages.contains("scenes/" + entry.name + ".html"));
            CHECK(linksTo(pages.at("index.html"), "scenes/" + entry.name + ".html"));
            const ReadPage& page = pages.at("scenes/" + entry.name + ".html");
            CHECK_FALSE(page.named("svg").empty());
            int topicsOfScene = 0;
            for (const Topic& topic : topics()) {
                const std::string path = folderOf(topic.sort) + "/" + topic.name + ".html";
                const bool there = linksTo(page, "../" + path);
                CHECK(there == linksTo(pages.at(path), "../scenes/" + entry.name + ".html"));
                topicsOfScene += there;
            }
            CHECK(topicsOfScene > 0);
            // Its function, not only the table of scenes.
            CHECK(std::ranges::any_of(page.named("a"), [](const Element* a) {
                const auto href = a->attributes.find("href");
                return href != a->attributes.end() && contains(href->second, "source/scenes/") &&
                       contains(href->second, ".html#L");
            }));
        }
    }
    SECTION("the dictionary has all rows of the seeds, and every word its row") {
        const ReadPage& dictionary = pages.at("dictionary.html");
        int rows = 0;
        std::ifstream list(fs::path(PLAIT_ROOT) / "tests/catalogue.txt");
        for (std::string line; std::getline(list, line); ++rows)
            CHECK(dictionary.ids.contains(line.substr(0, line.find(' '))));
        CHECK(rows > 330);
        for (const SeedWord& word : seedWords()) {
            INFO(word.word);
            CHECK(dictionary.ids.contains(anchorOf(word)));
            CHECK_FALSE(word.rows.empty());
            CHECK(word.here.ends_with("."));
        }
    }
    SECTION("what is not there is said, with the command that makes it") {
        const std::string flag = contents(folder / "site/scenes/flag.html");
        CHECK(contains(flag, "There is no clip of this scene here yet."));
        CHECK(contains(flag, "build/plait run flag -q draft"));
        CHECK_FALSE(contains(flag, "<video"));
        CHECK(contains(flag, "<img"));  // the golden picture
    }
    SECTION("pictures have words, and every page a language, a title and one first heading") {
        for (const auto& [path, page] : pages) {
            INFO(path);
            for (const Element* image : page.named("img")) CHECK(image->attributes.contains("alt"));
            CHECK(page.named("html")[0]->attributes.at("lang") == "en");
            CHECK(page.named("title").size() == 1);
            CHECK(page.named("h1").size() == 1);
            CHECK(page.named("main").size() == 1);
        }
    }
}

TEST_CASE("catalogue: a clip, its measures and its settings come from the run that left them",
          "[effects-catalogue]") {
    const TemporaryFolder folder;
    const fs::path run = folder / "runs/pendulum";
    REQUIRE(plait::test::plait(folder, {"run", "pendulum", "-q", "draft", "--seconds", "0.25",
                                        "--size", "160x90", "--quiet", "--out", run.string()})
                .status == 0);
    const Outcome made = makeCatalogue(folder, {"--only", "pendulum"});
    INFO(made.err);
    REQUIRE(made.status == 0);
    CHECK(made.out == (folder / "site/scenes/pendulum.html").string() + "\n");
    const std::string page = contents(folder / "site/scenes/pendulum.html");
    CHECK(contains(page,
                   "<video class=\"clip\" src=\"../media/pendulum.mp4\" "
                   "poster=\"../media/pendulum.png\""));
    CHECK(contents(folder / "site/media/pendulum.mp4") == contents(run / "clip.mp4"));
    CHECK(contains(page, "Simulated at draft quality"));
    CHECK(contains(page, "<td>holds</td>"));
    CHECK_FALSE(fs::exists(folder / "site/scenes/flag.html"));
}

TEST_CASE("catalogue: a knob is shown at its own value and to either side, within its range",
          "[effects-catalogue]") {
    const Knob speed{.name = "speed", .meaning = "", .value = 10, .low = 5, .high = 12};
    CHECK(shownValues(speed) == std::vector<std::string>{"8", "10", "11"});
    CHECK(shownValues({.name = "", .meaning = "", .value = 0, .low = 0, .high = 8}) ==
          std::vector<std::string>{"0", "4", "8"});
    CHECK(shownValues({.name = "", .meaning = "", .value = 32, .low = 4, .high = 512}) ==
          std::vector<std::string>{"18", "32", "64"});  // not the 272 of half way
    for (const SceneEntry& entry : scenes())
        for (const Knob& knob : entry.knobs) {
            INFO(entry.name << ", " << knob.name);
            const std::vector<std::string> values = shownValues(knob);
            CHECK(values.size() == std::set(values.begin(), values.end()).size());
            CHECK(values.size() <= 3);
            if (knob.isFile()) CHECK(values.empty());
            if (!knob.isNumber()) continue;
            CHECK(values.size() >= 2);
            CHECK(std::ranges::any_of(
                values, [&](const std::string& v) { return std::stod(v) == knob.value; }));
            for (const std::string& value : values) {
                CHECK(std::stod(value) >= knob.low);
                CHECK(std::stod(value) <= knob.high);
            }
        }
}

TEST_CASE("catalogue: it films what nobody has filmed, once", "[effects-catalogue][long]") {
    const TemporaryFolder folder;
    const std::vector<std::string> film{"--film", "--only", "pendulum", "--threads", "1"};
    const Outcome made = makeCatalogue(folder, film);
    INFO(made.err);
    REQUIRE(made.status == 0);
    const std::string page = contents(folder / "site/scenes/pendulum.html");
    for (const char* value : {"0.55", "1", "2"})
        CHECK(contains(page, "pendulum-length-" + std::string(value) + ".mp4"));
    CHECK_FALSE(contains(page, "Nobody has filmed"));
    const fs::path clip = folder / "runs/knobs/pendulum/length=2/clip.mp4";
    const auto before = fs::last_write_time(clip);
    fs::remove(folder / "runs/pendulum/clip.mp4");  // as of a run that was stopped
    REQUIRE(makeCatalogue(folder, film).status == 0);
    CHECK(fs::last_write_time(clip) == before);
    CHECK(fs::exists(folder / "runs/pendulum/clip.mp4"));
}

TEST_CASE("catalogue: what it cannot be made from is told in a line", "[effects-catalogue]") {
    const TemporaryFolder folder;
    const Outcome scene = makeCatalogue(folder, {"--only", "flga"});
    CHECK(scene.status == 2);
    CHECK(contains(scene.err, "nearest: flag"));
    const Outcome sources = plait::test::plait(
        folder,
        {"catalogue", "--sources", (folder / "none").string(), "--out", (folder / "s").string()});
    CHECK(sources.status == 5);
    CHECK(contains(sources.err, "core: not there; --sources says where the sources are"));
}
