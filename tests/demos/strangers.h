// What the tests of strange input and strange machines share.
#pragma once

#include "program.h"
#include "tests/catch.h"

#include <algorithm>
#include <string>
#include <vector>

namespace plait::test {

inline int lines(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

inline std::vector<std::string> with(std::vector<std::string> words,
                                     const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// Two frames of a pendulum, filmed.
inline std::vector<std::string> pendulumRun(const TemporaryFolder& folder,
                                            const std::vector<std::string>& more) {
    return with({"run", "pendulum", "--quiet", "-q", "draft", "--seconds", "0.1", "--out",
                 (folder / "run").string()},
                more);
}

// Refused in one line that has this part.
inline void refuses(const Outcome& outcome, int status, const std::string& part) {
    INFO(outcome.err);
    CHECK(outcome.status == status);
    CHECK(lines(outcome.err) == 1);
    CHECK(contains(outcome.err, part));
}

}  // namespace plait::test
