// The package: what `cmake --install` leaves is enough to build and run a program of one's own.
#include "program.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <utility>

using namespace plait::test;

namespace {

// A shell's, its words going to a file that is shown if it fails.
void shell(const TemporaryFolder& folder, const std::string& line) {
    const std::string log = (folder / "log").string();
    const int status = std::system((line + " >" + log + " 2>&1").c_str());
    INFO(line << "\n" << contents(log));
    REQUIRE(status == 0);
}

}  // namespace

TEST_CASE("programs of their own simulate with the installed package", "[program][install][AR2]") {
    const TemporaryFolder folder;
    const std::string package = (folder / "moved here").string();
    const std::string built = (folder / "built").string();
    shell(folder, "cmake --install " PLAIT_BUILD " --prefix " + (folder / "there").string());
    std::filesystem::rename(folder / "there", package);
    shell(folder, "cmake -G Ninja -S " PLAIT_ROOT "/demos/examples -B " + built +
                      " -DCMAKE_CXX_COMPILER=" PLAIT_CXX
                      " -DCMAKE_EXPORT_COMPILE_COMMANDS=ON '-DCMAKE_PREFIX_PATH=" +
                      package + "'");
    shell(folder, "cmake --build " + built);
    const std::string commands = contents(folder / "built/compile_commands.json");
    CHECK(contains(commands, "-ffp-contract=off"));
    CHECK_FALSE(contains(commands, PLAIT_ROOT "/core"));

    // No include folder of ours comes between a program and a header of its own.
    CHECK_FALSE(contains(commands, "-iquote"));

    const auto lowestOf = [&](const std::string& example) {
        shell(folder, built + "/" + example);
        return std::stod(contents(folder / "log"));
    };
    // The core wants nothing but the language's own libraries; sanitizers want libresolv.
    shell(folder, "ldd " + built + "/cloth");
    std::istringstream needed(contents(folder / "log"));
    for (std::string line; std::getline(needed, line);) {
        const std::string name = line.substr(line.find_first_not_of("\t "));
        CAPTURE(name);
        CHECK(std::ranges::any_of(
            std::array{"linux-vdso", "libc.", "libm.", "libstdc++.", "libgcc_s.", "libpthread.",
                       "libc++", "libresolv.", "/lib"},
            [&](const char* own) { return name.starts_with(own); }));
    }

    // It hangs straight below its pins, whose links hardly stretch.
    const double cloth = lowestOf("cloth");
    note("lowest point of a cloth of 1 m, m", cloth);
    CHECK(cloth < -0.99);
    CHECK(cloth > -1.01);
    // A catenary of length 1 over 0.6: a sinh(0.3 / a) = 0.5 for a = 0.1632.
    CHECK(report("sag of a rope between two hands, m", std::fabs(lowestOf("rope") + 0.3627), 2e-3));
}

TEST_CASE("every example is printed as it is, one of them in the README", "[program][install]") {
    for (const auto& [example, where] :
         {std::pair{"rope", "/README.md"}, {"cloth", "/demos/README.md"}}) {
        const std::string text =
            contents(PLAIT_ROOT "/demos/examples/" + std::string(example) + ".cpp");
        INFO(example);
        CHECK(contains(contents(PLAIT_ROOT + std::string(where)), "```cpp\n" + text + "```\n"));
        CHECK(std::ranges::count(text, '\n') <= 50);
    }
}

TEST_CASE("the README is read in five minutes, and its pictures are there", "[program][install]") {
    const std::string readme = contents(PLAIT_ROOT "/README.md");
    CHECK(std::ranges::count(readme, '\n') <= 150);
    const std::regex picture(R"(!\[[^\]]+\]\(([^)]+)\))");
    int pictures = 0;
    for (std::sregex_iterator i(readme.begin(), readme.end(), picture), end; i != end; ++i) {
        INFO((*i)[1]);
        CHECK(std::filesystem::exists(PLAIT_ROOT "/" + std::string((*i)[1])));
        ++pictures;
    }
    CHECK(pictures >= 8);
}
