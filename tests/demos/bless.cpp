// plait_bless SCENE...: makes golden pictures again. Prints how each differs from the one that it
// replaces, and ends with the page on which both stand: look at it before you commit. Exit
// statuses are those of plait.
#include "demos/tools/errors.h"
#include "golden_pictures.h"

#include <cstdio>
#include <stdexcept>

namespace {

using namespace plait;

int complain(Exit status, const char* message) {
    std::fprintf(stderr, "plait_bless: %s\n", message);
    return status;
}

void blessAll(const std::vector<std::string>& scenes) {
    std::vector<ComparisonEntry> all;
    for (const std::string& scene : scenes)
        for (ComparisonEntry& entry : test::bless(PLAIT_ROOT, scene)) {
            const std::string change =
                entry.golden.rgb.empty() ? "new" : describe(compare(entry.actual, entry.golden));
            std::printf("%-24s %s\n", entry.name.c_str(), change.c_str());
            all.push_back(std::move(entry));
        }
    std::printf("%s\n", writeComparisonPage(PLAIT_PAGES "/blessed", all).c_str());
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 2) throw UsageError("usage: plait_bless SCENE...");
        blessAll({argv + 1, argv + argc});
    } catch (const UsageError& error) {
        return complain(exitUsage, error.what());
    } catch (const std::domain_error& error) {
        return complain(exitDiverged, error.what());
    } catch (const std::exception& error) {
        return complain(exitFiles, error.what());
    }
}
