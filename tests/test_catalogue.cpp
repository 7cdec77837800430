// The catalogue: its rows, and which of them tests hold (tests/catalogue).
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include "scratch_folder.h"
#include "tests/catch.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
using namespace plait::test;

namespace {

struct Said {
    std::vector<std::string> lines;
    int status;
};

Said run(const fs::path& program) {
    FILE* pipe = popen((program.string() + " 2>&1").c_str(), "r");
    REQUIRE(pipe);
    Said said;
    std::string line;
    for (int c; (c = std::fgetc(pipe)) != EOF;)
        if (c != '\n')
            line += static_cast<char>(c);
        else
            said.lines.push_back(std::exchange(line, {}));
    said.status = pclose(pipe);
    return said;
}

struct Row {
    bool open = false;
    std::vector<std::string> tests;  // each with what is said of it
};

const std::regex rowLine("([A-Z]{2})([0-9]+) +.*");

// A row printed twice is told by the test.
std::map<std::string, Row> rowsOf(const Said& said) {
    std::map<std::string, Row> rows;
    Row* row = nullptr;
    std::smatch match;
    for (const std::string& line : said.lines)
        if (std::regex_match(line, match, rowLine)) {
            const std::string id = match.str(1) + match.str(2);
            CHECK(!rows.contains(id));
            row = &rows[id];
            row->open = line.ends_with(": open");
        } else if (line.starts_with("        ") && row) {
            row->tests.push_back(line.substr(8));
        }
    return rows;
}

}  // namespace

TEST_CASE("catalogue: 330 rows, each once, and as many held and open as it says", "[ledger]") {
    const Said said = run(fs::path(PLAIT_ROOT) / "tests/catalogue");
    for (const std::string& line : said.lines)
        if (line.starts_with("tests/")) FAIL_CHECK(line);
    REQUIRE(said.status == 0);
    const std::map<std::string, Row> rows = rowsOf(said);
    CHECK(rows.size() == 330);
    std::map<std::string, std::pair<int, int>> last;  // of a section: rows, the last of them
    int open = 0;
    for (const auto& [id, row] : rows) {
        auto& [count, greatest] = last[id.substr(0, 2)];
        ++count, greatest = std::max(greatest, std::stoi(id.substr(2)));
        open += row.open;
        bool held = false;
        for (const std::string& test : row.tests)
            held = held || test.find(" (hidden)  ") == std::string::npos;
        INFO(id);
        CHECK(held != row.open);
    }
    for (const auto& [section, numbers] : last) CHECK(numbers.first == numbers.second);
    CHECK(said.lines.back().starts_with(std::to_string(330 - open) + " held, " +
                                        std::to_string(open) + " open of 330 "));
}

#ifdef CATCH_VERSION_MAJOR  // Catch2 2
// What Catch has read is what tests/catalogue has.
TEST_CASE("catalogue: the tags of these tests are under their rows", "[ledger]") {
    const std::map<std::string, Row> rows = rowsOf(run(fs::path(PLAIT_ROOT) / "tests/catalogue"));
    int tags = 0;
    for (const Catch::TestCase& test : Catch::getRegistryHub().getTestCaseRegistry().getAllTests())
        for (const std::string& tag : test.tags) {
            if (!std::regex_match(tag, std::regex("[A-Z]{2}[0-9]+"))) continue;
            INFO(tag << ": " << test.name);
            REQUIRE(rows.contains(tag));
            const auto& tests = rows.at(tag).tests;
            // A template's name goes on with its type.
            CHECK(std::any_of(tests.begin(), tests.end(), [&](const std::string& line) {
                return line.starts_with(test.name.substr(0, test.name.find(" - ")));
            }));
            ++tags;
        }
    CHECK(tags > 100);
}
#endif

TEST_CASE("catalogue: what is no row, or stands elsewhere, is refused; what is hidden holds none",
          "[ledger]") {
    const ScratchFolder folder;
    fs::create_directory(folder / "tests");
    for (const char* name : {"catalogue", "catalogue.txt"})
        fs::copy(fs::path(PLAIT_ROOT) / "tests" / name, folder / "tests" / name);
    const auto say = [&](const std::string& tests) {
        std::ofstream(folder / "tests/test_one.cpp") << tests;
        return run(folder / "tests/catalogue");
    };
    const std::string test =
        "TEST"
        "_CASE";
    const Said good =
        say(test + "(\"a \\\"b\\\", \"\n    \"c\",\n    \"[d][CC2]\"\n    \"[CC3]\") {}\n  " +
            test + "(\"e\", \"[.][CC4]\") {}\n" + test + "(\"f\") {}\n" + test +
            "(\"g\", \"[long][CC3][CC5]\") {}\n");
    CHECK(good.status == 0);
    const std::map<std::string, Row> rows = rowsOf(good);
    CHECK(rows.at("CC2").tests == std::vector<std::string>{"a \"b\", c  tests/test_one.cpp"});
    CHECK(rows.at("CC3").tests.size() == 2);
    CHECK(!rows.at("CC3").open);
    CHECK(rows.at("CC4").tests == std::vector<std::string>{"e (hidden)  tests/test_one.cpp"});
    CHECK(rows.at("CC4").open);
    CHECK(rows.at("CC5").tests == std::vector<std::string>{"g (long)  tests/test_one.cpp"});
    CHECK(good.lines.back() == "3 held, 327 open of 330 (1 of those held by long tests alone)");
    for (const auto& [tags, why] : {std::pair{"(\"a\", \"[CC28]\") {}", "[CC28] is no row"},
                                    {"(\"a\", \"[CC2, CC3]\") {}", "[CC2, CC3] is no row"},
                                    {"(\"a\", \"[CC2][x][CC2]\") {}", "[CC2] twice"},
                                    {"(\"a [CC2]\", \"[x]\") {}", "an id belongs into the tags"}}) {
        const Said bad = say(test + tags);
        CHECK(bad.status != 0);
        CHECK(std::count_if(bad.lines.begin(), bad.lines.end(), [&](const std::string& line) {
                  return line.starts_with("tests/test_one.cpp: ") && line.ends_with(why);
              }) == 1);
    }
}

TEST_CASE("catalogue: tests/limits.md says which numbers have no unit in the world",
          "[ledger][UN9]") {
    std::ifstream file(fs::path(PLAIT_ROOT) / "tests/limits.md");
    std::string text;
    for (std::string word; file >> word;) text += word + ' ';
    for (const char* words :
         {"the `nucleus` method knows no stiffness, only importance",
          "Friction and restitution are numbers of a pair", "`stickiness` is newtons a contact"})
        CHECK(text.find(words) != std::string::npos);
}
