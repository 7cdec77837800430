#include "tests.h"

#include <algorithm>
#include <cctype>

namespace plait {
namespace {

namespace fs = std::filesystem;

bool isRowId(const std::string& tag) {
    return tag.size() > 2 && std::isupper(static_cast<unsigned char>(tag[0])) &&
           std::isupper(static_cast<unsigned char>(tag[1])) &&
           std::isdigit(static_cast<unsigned char>(tag[2]));
}

std::vector<SeedSection> readSections(const Sources& sources) {
    std::vector<SeedSection> sections;
    for (const std::string& line : sources.lines("tests/catalogue.txt")) {
        const std::size_t space = line.find(' ');
        if (space == std::string::npos) continue;
        const std::string id = line.substr(0, space), words = line.substr(space + 1);
        if (isRowId(id))
            sections.back().rows.push_back({id, words});
        else
            sections.push_back({id, words, {}});
    }
    return sections;
}

// The quoted words of a macro's first two arguments: name and tags.
void readMacro(const std::string& text, SeedTest& test) {
    std::string parts[2];
    int part = 0;
    bool quoted = false;
    for (std::size_t i = text.find('(') + 1; i < text.size() && part < 2; ++i) {
        const char c = text[i];
        if (c == '"')
            quoted = !quoted;
        else if (quoted)
            parts[part] += c == '\\' ? text[++i] : c;
        else if (c == ',')
            ++part;
        else if (c == ')')
            break;
    }
    test.name = parts[0];
    for (std::size_t at = 0; (at = parts[1].find('[', at)) != std::string::npos; ++at)
        test.tags.push_back(parts[1].substr(at + 1, parts[1].find(']', at) - at - 1));
}

// TEST_CASE(, TEMPLATE_TEST_CASE(, ...
bool beginsTest(const std::string& line) {
    const std::size_t from = line.find_first_not_of(" \t"), end = line.find('(');
    if (from == std::string::npos || end == std::string::npos || end <= from) return false;
    const std::string word = line.substr(from, end - from);
    return word.find("TEST_CASE") != std::string::npos &&
           std::ranges::all_of(word, [](char c) { return c == '_' || (c >= 'A' && c <= 'Z'); });
}

void readTests(const Sources& sources, const std::string& file, std::vector<SeedTest>& tests) {
    const std::vector<std::string>& lines = sources.lines(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!beginsTest(lines[i])) continue;
        SeedTest test;
        test.file = file, test.line = static_cast<int>(i) + 1;
        std::string body = lines[i];
        std::size_t next = i + 1;
        for (; next < lines.size() && !beginsTest(lines[next]); ++next) body += "\n" + lines[next];
        readMacro(body, test);
        test.body = body;
        tests.push_back(std::move(test));
    }
}

}  // namespace

bool SeedTest::hidden() const {
    return std::ranges::any_of(tags, [](const std::string& tag) { return tag.starts_with("."); });
}

bool SeedTest::isLong() const { return std::ranges::count(tags, "long") > 0; }

std::vector<std::string> SeedTest::rows() const {
    std::vector<std::string> ids;
    std::ranges::copy_if(tags, std::back_inserter(ids), isRowId);
    return ids;
}

const SeedRow* Seeds::row(const std::string& id) const {
    for (const SeedSection& section : sections)
        for (const SeedRow& row : section.rows)
            if (row.id == id) return &row;
    return nullptr;
}

const SeedSection* Seeds::section(const std::string& id) const {
    for (const SeedSection& section : sections)
        if (section.id == id.substr(0, 2)) return &section;
    return nullptr;
}

std::vector<const SeedTest*> Seeds::holding(const std::string& id) const {
    std::vector<const SeedTest*> found;
    for (const SeedTest& test : tests)
        if (!test.hidden() && std::ranges::count(test.tags, id) > 0) found.push_back(&test);
    return found;
}

std::vector<const SeedTest*> Seeds::running(const std::string& scene) const {
    const std::string name = "\"" + scene + "\"";
    std::vector<const SeedTest*> found;
    for (const SeedTest& test : tests) {
        bool runs = std::ranges::count(test.tags, scene) > 0;
        for (const char* before : {"findScene(", "sceneNamed(", "draftOf(", "sceneOf(",
                                   "sceneWith(", "\"scene\", ", "studyNamed(", "smallScene("})
            runs = runs || test.body.find(before + name) != std::string::npos;
        // What refuses a bad command line is no test of the scene.
        if (runs && !test.hidden() && std::ranges::count(test.tags, "program") == 0)
            found.push_back(&test);
    }
    return found;
}

Seeds readSeeds(const Sources& sources) {
    Seeds seeds{.sections = readSections(sources), .tests = {}};
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(sources.root() / "tests"))
        if (entry.path().extension() == ".cpp")
            files.push_back(fs::relative(entry.path(), sources.root()).generic_string());
    std::ranges::sort(files);
    for (const std::string& file : files) readTests(sources, file, seeds.tests);
    return seeds;
}

}  // namespace plait
