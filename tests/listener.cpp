// A listener that prints each test's name above its figures and, in the file named by
// PLAIT_TEST_LOG, a line as it starts and as it ends: a crash leaves the start alone. Where a
// machine lacks something, a test says WARN("skipped: why") (Catch2 3: SKIP).
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include "catch.h"

#ifdef CATCH_VERSION_MAJOR
#define PLAIT_CATCH2 2
#else
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#define PLAIT_CATCH2 3
#endif

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {

using Clock = std::chrono::steady_clock;

#if PLAIT_CATCH2 == 2
using ListenerBase = Catch::TestEventListenerBase;
#else
using ListenerBase = Catch::EventListenerBase;
#endif

class Listener : public ListenerBase {
public:
    using ListenerBase::ListenerBase;

    void testCaseStarting(const Catch::TestCaseInfo& test) override {
        name_ = test.name;
        skipped_ = false;
        start_ = Clock::now();
        std::printf("%s\n", name_.c_str());
        log("started");
    }

    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        const std::chrono::duration<double> seconds = Clock::now() - start_;
        if (seconds.count() >= 1) std::printf("    %.1f s\n", seconds.count());
#if PLAIT_CATCH2 == 3
        skipped_ = stats.totals.testCases.skipped > 0;
#endif
        log(stats.totals.testCases.failed > 0 ? "failed" : skipped_ ? "skipped" : "passed");
    }

#if PLAIT_CATCH2 == 2
    bool assertionEnded(const Catch::AssertionStats& stats) override {
        const auto& result = stats.assertionResult;
        skipped_ |= result.getResultType() == Catch::ResultWas::Warning &&
                    result.getMessage().starts_with("skipped");
        return true;
    }
#endif

private:
    void log(const char* event) {
        std::fflush(stdout);
        const char* path = std::getenv("PLAIT_TEST_LOG");
        std::FILE* file = path ? std::fopen(path, "a") : nullptr;
        if (!file) return;
        std::fprintf(file, "%s %s\n", event, name_.c_str());
        std::fclose(file);
    }

    std::string name_;
    Clock::time_point start_;
    bool skipped_ = false;
};

CATCH_REGISTER_LISTENER(Listener)

}  // namespace
