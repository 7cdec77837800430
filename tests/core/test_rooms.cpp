// The rooms of the house: arrows between them run one way. Their order is the table's in
// core/README.md.
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path root = PLAIT_ROOT;

std::vector<std::string> linesOf(const fs::path& path) {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

std::vector<fs::path> sourcesIn(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

// What the first cells of the table name, from its head down: "numbers/", or "world.h".
std::vector<std::string> roomsInOrder() {
    std::vector<std::string> rooms;
    bool inTable = false;
    const std::regex name("`([^`]+)`");
    for (const std::string& line : linesOf(root / "core/README.md")) {
        inTable = line.starts_with("| room |") || (inTable && line.starts_with("|"));
        if (!inTable) continue;
        const std::string cell = line.substr(1, line.find('|', 1) - 1);
        for (std::sregex_iterator i(cell.begin(), cell.end(), name), end; i != end; ++i)
            rooms.push_back((*i)[1]);
    }
    return rooms;
}

// The room of a file of core; of one at its root the header that its name begins with.
std::string roomOf(const fs::path& file, const std::vector<std::string>& rooms) {
    const fs::path inCore = fs::relative(file, root / "core");
    if (inCore.has_parent_path()) return inCore.parent_path().string() + "/";
    const std::string name = inCore.filename().string(), stem = inCore.stem().string();
    if (std::ranges::find(rooms, name) != rooms.end()) return name;
    std::string longest;
    for (const std::string& room : rooms) {
        const std::string header = fs::path(room).stem().string();
        if (room.ends_with(".h") && stem.starts_with(header) && header.size() > longest.size())
            longest = room;
    }
    return longest;
}

struct Arrow {
    fs::path from, to;
};

// Quoted includes of the files of a folder, and of core <plait/...>.
std::vector<Arrow> arrowsFrom(const fs::path& folder) {
    std::vector<Arrow> arrows;
    const std::regex include("^#include [\"<]([^\">]+)[\">].*");
    for (const fs::path& file : sourcesIn(folder))
        for (const std::string& line : linesOf(file)) {
            std::smatch match;
            if (!std::regex_match(line, match, include)) continue;
            const std::string name = match[1];
            if (name.starts_with("plait/"))
                arrows.push_back({file, root / "core" / name.substr(6)});
            else if (line.find('"') != std::string::npos)
                arrows.push_back({file, fs::exists(file.parent_path() / name)
                                            ? (file.parent_path() / name).lexically_normal()
                                            : root / name});
        }
    return arrows;
}

}  // namespace

TEST_CASE("arrows between the rooms of core run up the table, and never down", "[rooms]") {
    const std::vector<std::string> rooms = roomsInOrder();
    REQUIRE(rooms.size() > 20);
    const auto place = [&](const fs::path& file) {
        const std::string room = roomOf(file, rooms);
        const auto at = std::ranges::find(rooms, room);
        INFO(file << " is in no room of core/README.md: " << room);
        REQUIRE(at != rooms.end());
        return at - rooms.begin();
    };
    const std::vector<Arrow> arrows = arrowsFrom(root / "core");
    REQUIRE(arrows.size() > 400);
    for (const auto& [from, to] : arrows) {
        INFO(from << " includes " << to);
        REQUIRE(fs::exists(to));
        CHECK(place(to) <= place(from));
    }
}

TEST_CASE("rooms that the table names exist, each with a word on what belongs there", "[rooms]") {
    for (const std::string& room : roomsInOrder()) {
        INFO(room);
        REQUIRE(fs::exists(root / "core" / room));
        if (!room.ends_with("/")) continue;
        // Its own, or that of the room that it is in.
        const fs::path own = root / "core" / room / "README.md";
        const fs::path outer = root / "core" / room / ".." / "README.md";
        const fs::path readme = fs::exists(own) ? own : outer;
        CHECK(fs::canonical(readme) != fs::canonical(root / "core/README.md"));
        CHECK(linesOf(readme).size() <= 60);
    }
}

TEST_CASE("core, scenes, render, demos, tests: each knows those before it only", "[rooms]") {
    const std::vector<std::string> houses{"core", "scenes", "render", "demos", "tests"};
    const auto place = [&](const fs::path& file) {
        return std::ranges::find(houses, fs::relative(file, root).begin()->string()) -
               houses.begin();
    };
    for (const std::string& house : houses)
        for (const auto& [from, to] : arrowsFrom(root / house)) {
            INFO(from << " includes " << to);
            CHECK(fs::exists(to));
            CHECK(place(to) <= place(from));
        }
}

// Effects are sums of what core has: none brings a constraint or a force of its own.
TEST_CASE("scenes are made of core's building blocks alone", "[rooms][AR3]") {
    const std::regex own("public +(plait::)?(Constraint|ContactConstraint|Force|WholeStep)<");
    int files = 0;
    for (const fs::path& file : sourcesIn(root / "scenes")) {
        ++files;
        for (const std::string& line : linesOf(file)) {
            INFO(file << ": " << line);
            CHECK_FALSE(std::regex_search(line, own));
        }
    }
    CHECK(files > 30);
}

// Simple code has fewer bugs. What needs more says so here.
TEST_CASE("core keeps to its size", "[rooms][AR6]") {
    std::size_t all = 0, longest = 0;
    for (const fs::path& file : sourcesIn(root / "core")) {
        const std::size_t lines = linesOf(file).size();
        INFO(file);
        CHECK(lines <= 350);
        all += lines;
        longest = std::max(longest, lines);
    }
    plait::test::note("lines of core", static_cast<double>(all));
    plait::test::note("of its longest file", static_cast<double>(longest));
    CHECK(all > 10'000);
    CHECK(all < 40'000);
}
