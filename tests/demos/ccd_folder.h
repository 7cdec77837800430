// Where the tests find the published query sets.
#pragma once

#include "demos/bench/ccd_data.h"
#include "tests/catch.h"

#include <cstdlib>
#include <filesystem>

namespace plait::test {

// PLAIT_CCD_DATA, or shared/ccd beside the project.
inline std::filesystem::path ccdData() {
    return ccdFolder(std::filesystem::path(PLAIT_ROOT) / "../shared/ccd");
}

// False, and the test is skipped, where nobody has the sets. Who names a folder means it, and one
// that is there is to be whole.
inline bool haveCcdData() {
    const char* const named = std::getenv("PLAIT_CCD_DATA");
    const bool meant = (named && *named) || std::filesystem::exists(ccdData());
    const bool whole = ccdTables(ccdData()).size() == 4;
    INFO("in " << ccdData());
    REQUIRE((whole || !meant));
    if (!whole) WARN("skipped: no query sets in " << ccdData());
    return whole;
}

}  // namespace plait::test
