// The package: what `cmake --install` leaves is enough to build and run a program of one's own.
#include "program.h"
#include "tests/catch.h"
#include "tests/report.h"

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

TEST_CASE("a program of its own simulates a cloth with the installed package",
          "[program][install]") {
    const TemporaryFolder folder;
    const std::string package = (folder / "moved here").string();
    const std::string built = (folder / "built").string();
    shell(folder, "cmake --install " PLAIT_BUILD " --prefix " + (folder / "there").string());
    std::filesystem::rename(folder / "there", package);
    shell(folder, "cmake -G Ninja -S " PLAIT_ROOT "/tests/consumer -B " + built +
                      " -DCMAKE_CXX_COMPILER=" PLAIT_CXX
                      " -DCMAKE_EXPORT_COMPILE_COMMANDS=ON '-DCMAKE_PREFIX_PATH=" +
                      package + "'");
    shell(folder, "cmake --build " + built);
    const std::string commands = contents(folder / "built/compile_commands.json");
    CHECK(contains(commands, "-ffp-contract=off"));
    CHECK_FALSE(contains(commands, PLAIT_ROOT "/core"));

    shell(folder, built + "/cloth");
    const double lowest = std::stod(contents(folder / "log"));
    note("lowest point of a cloth of 1 m, m", lowest);
    // It hangs straight below its pins, whose links hardly stretch.
    CHECK(lowest < -0.99);
    CHECK(lowest > -1.01);
}
