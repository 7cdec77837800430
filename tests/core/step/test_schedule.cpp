#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/catch.h"

#include <plait/schedule.h>

using namespace plait;

namespace {

__extension__ using Wide = __int128;

// The sets of S figure 9.
std::vector<ScheduledSet> figureSets() {
    return {{.name = "Bend", .order = 0, .importance = 9},
            {.name = "Shear", .order = 1, .importance = 7},
            {.name = "Stretch", .order = 2, .importance = 26},
            {.name = "Self-collisions", .order = 3, .importance = 7, .contact = true},
            {.name = "Collisions", .order = 4, .importance = 6, .contact = true}};
}

std::vector<ScheduledSet> stretchAndCollide(int stretch, int collide) {
    return {{.name = "stretch", .importance = stretch},
            {.name = "collide", .importance = collide, .contact = true}};
}

SubstepPlan planOf(const Schedule& schedule, std::int64_t substep) {
    SubstepPlan plan;
    schedule.plan(substep, plan);
    return plan;
}

std::vector<int> countsOf(const Schedule& schedule, int set, int substeps) {
    std::vector<int> counts(static_cast<std::size_t>(substeps));
    int s = 0;
    for (int& k : counts) k = schedule.count(set, s++);
    return counts;
}

std::int64_t totalOf(const Schedule& schedule, int set, std::int64_t begin, std::int64_t end) {
    std::int64_t total = 0;
    for (std::int64_t s = begin; s < end; ++s) total += schedule.count(set, s);
    return total;
}

// Columns, from 1, in which `set` runs.
std::vector<int> columnsOf(const SubstepPlan& plan, int set) {
    std::vector<int> found;
    for (int j = 0; j < static_cast<int>(plan.columns.size()); ++j) {
        const SubstepPlan::Column& column = plan.columns[static_cast<std::size_t>(j)];
        for (int i = column.begin; i < column.end; ++i)
            if (plan.sets[static_cast<std::size_t>(i)] == set) found.push_back(j + 1);
    }
    return found;
}

std::string golden(const std::string& name) {
    std::ifstream file(std::string(PLAIT_ROOT) + "/golden/schedule/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// The law of counts in the plainest form, without reduced fractions or periods.
std::int64_t countByHand(Wide numerator, Wide denominator, std::int64_t s) {
    const Wide k = (s + 1) * numerator / denominator - s * numerator / denominator;
    return std::max(std::int64_t{1}, static_cast<std::int64_t>(k));
}

}  // namespace

TEST_CASE("The patterns of figures 9, 11 and 13 are those written by hand",
          "[schedule][SC1][SC3]") {
    std::vector<ScheduledSet> sets = figureSets();
    CHECK(print(Schedule(sets, {.mode = ScheduleMode::sequential}), 0) == golden("figure-9.txt"));
    CHECK(print(Schedule(sets), 0) == golden("figure-11.txt"));

    // Figure 13, registered last, and as the paper puts it: an order higher, the same importance.
    sets[4].order = 5;
    sets.push_back({.name = "Custom", .order = 4, .importance = 7, .contact = true});
    CHECK(print(Schedule(sets), 0) == golden("figure-13.txt"));
}

TEST_CASE("Sequential runs all of one set, then the next, contacts last", "[schedule][SC2]") {
    std::vector<ScheduledSet> sets = figureSets();
    sets[4].order = -1;  // still after every set that is no contact, now before self-collisions
    const SubstepPlan plan = planOf(Schedule(sets, {.mode = ScheduleMode::sequential}), 0);
    std::vector<int> expected;
    for (const auto& [set, k] : {std::pair{0, 9}, {1, 7}, {2, 26}, {4, 6}, {3, 7}})
        expected.insert(expected.end(), static_cast<std::size_t>(k), set);
    CHECK(plan.sets == expected);
    REQUIRE(plan.columns.size() == expected.size());
    for (const SubstepPlan::Column& column : plan.columns) CHECK(column.end == column.begin + 1);
    CHECK(plan.constraints(plan.columns[41]).size() == 1);
    CHECK(plan.contacts(plan.columns[42]).size() == 1);
}

TEST_CASE("A custom set follows each call of the set it is registered behind", "[schedule]") {
    std::vector<ScheduledSet> sets = figureSets();
    sets.push_back({.name = "probe", .order = 3, .importance = 7, .contact = true});
    for (int substeps = 1; substeps <= 30; ++substeps) {
        const Schedule schedule(sets, {.substeps = substeps});
        for (int s = 0; s < substeps; ++s) {
            const SubstepPlan plan = planOf(schedule, s);
            CHECK(plan.counts[5] == plan.counts[3]);
            for (std::size_t i = 0; i + 1 < plan.sets.size(); ++i)
                REQUIRE((plan.sets[i] == 3) == (plan.sets[i + 1] == 5));
        }
    }
}

TEST_CASE("Counts are those of the guide's sections 2.4 and 4.1", "[schedule][SC7]") {
    const auto stretch = [](int importance, int substeps) {
        return Schedule({{.name = "stretch", .importance = importance}}, {.substeps = substeps});
    };
    CHECK(countsOf(stretch(10, 2), 0, 2) == std::vector{5, 5});
    CHECK(countsOf(stretch(10, 10), 0, 10) == std::vector<int>(10, 1));
    CHECK(countsOf(stretch(10, 20), 0, 20) == std::vector<int>(20, 1));
    CHECK(stretch(10, 2).strength(0) == 1.0);
    CHECK(stretch(10, 10).strength(0) == 1.0);
    CHECK(stretch(10, 20).strength(0) == 0.5);
    CHECK(countsOf(stretch(10, 3), 0, 6) == std::vector{3, 3, 4, 3, 3, 4});

    // One collide for every 5 stretches up to 4 substeps; there it is the 5th of every 5 exactly
    // where the substeps divide both counts.
    for (int n = 1; n <= 4; ++n) {
        const Schedule schedule(stretchAndCollide(20, 4), {.substeps = n});
        CHECK(totalOf(schedule, 0, 0, n) == 20);
        CHECK(totalOf(schedule, 1, 0, n) == 4);
        if (n == 3) continue;
        const std::vector<int> columns = columnsOf(planOf(schedule, 0), 1);
        for (std::size_t i = 0; i < columns.size(); ++i)
            CHECK(columns[i] == 5 * static_cast<int>(i + 1));
    }
    for (const auto& [n, stretches] : {std::pair{10, 20}, {30, 30}}) {
        const Schedule schedule(stretchAndCollide(20, 4), {.substeps = n});
        CHECK(totalOf(schedule, 0, 0, n) == stretches);
        CHECK(totalOf(schedule, 1, 0, n) == n);
    }
    // A collide for every 10 stretches at 500 needs 50 substeps; at 4 collides, 10 are too few.
    const Schedule stiff(stretchAndCollide(500, 4), {.substeps = 50});
    CHECK(countsOf(stiff, 0, 50) == std::vector<int>(50, 10));
    CHECK(countsOf(stiff, 1, 50) == std::vector<int>(50, 1));
}

TEST_CASE("Collision iterations per frame are the larger of request and substeps",
          "[schedule][SC9]") {
    CHECK(countsOf(Schedule(stretchAndCollide(20, 10), {.substeps = 2}), 1, 2) ==
          std::vector{5, 5});
    for (const int request : {1, 4, 5, 10, 37})
        for (const int n : {1, 3, 4, 10, 30})
            CHECK(totalOf(Schedule(stretchAndCollide(20, request), {.substeps = n}), 1, 0, n) ==
                  std::max(request, n));
}

TEST_CASE("Totals and intensity over 1/24 s are exact wherever the run stands", "[schedule]") {
    for (int n = 1; n <= 30; ++n)
        for (int importance = 1; importance <= 500; ++importance) {
            const Schedule schedule({{.name = "set", .importance = importance}}, {.substeps = n});
            for (const std::int64_t begin :
                 {std::int64_t{0}, std::int64_t{7}, std::int64_t{999'999'937}}) {
                std::int64_t total = 0;
                for (std::int64_t s = begin; s < begin + n; ++s) {
                    const int k = schedule.count(0, s);
                    REQUIRE(k == countByHand(importance, n, s));
                    total += k;
                }
                REQUIRE(total == std::max(importance, n));
                const double intensity = schedule.strength(0) * static_cast<double>(total);
                REQUIRE(intensity == Approx(importance).epsilon(1e-15).margin(0));
            }
        }
}

TEST_CASE("A second holds the same evaluations at every frame rate", "[schedule][IN14]") {
    for (const int fps : {24, 30, 48, 60})
        for (const int n : {1, 2, 3, 7, 20})
            for (const int importance : {1, 4, 10, 26, 500}) {
                const Schedule schedule({{.name = "set", .importance = importance}},
                                        {.substeps = n, .frameRate = {fps, 1}});
                REQUIRE(totalOf(schedule, 0, 0, fps * n) == std::max(24 * importance, fps * n));
                REQUIRE(totalOf(schedule, 0, 5, 5 + fps * n) == std::max(24 * importance, fps * n));
            }
    // 29.97: 1001 s are 30000 frames.
    const Schedule video({{.name = "set", .importance = 10}},
                         {.substeps = 3, .frameRate = {30000, 1001}});
    CHECK(totalOf(video, 0, 0, 90000) == 240 * 1001);
}

TEST_CASE("Counts stay exact in long runs and at the ends of the ranges", "[schedule]") {
    for (const int importance : {1, 999, 999'999, 1'000'000})
        for (const auto& [fps, n] : {std::pair{FrameRate{24, 1}, 7},
                                     {{30000, 1001}, 35'791},
                                     {{1, 11}, 9'973},
                                     {{60000, 1001}, 1}}) {
            const Schedule schedule({{.name = "set", .importance = importance}},
                                    {.substeps = n, .frameRate = fps});
            for (std::int64_t s = 999'999'000; s <= 1'000'000'000; ++s)
                REQUIRE(schedule.count(0, s) ==
                        countByHand(Wide{24} * importance * fps.seconds, Wide{fps.frames} * n, s));
        }
}

TEST_CASE("Columns are evenly spread, the last is complete and ends in a contact",
          "[schedule][SC3][SC4]") {
    for (const int n : {1, 2, 3, 5, 8, 13, 30}) {
        const Schedule schedule(figureSets(), {.substeps = n});
        for (int s = 40 * n; s < 41 * n; ++s) {
            const SubstepPlan plan = planOf(schedule, s);
            const int m = *std::max_element(plan.counts.begin(), plan.counts.end());
            REQUIRE(static_cast<int>(plan.columns.size()) == m);
            for (int set = 0; set < 5; ++set) {
                const std::vector<int> columns = columnsOf(plan, set);
                const int k = schedule.count(set, s);
                REQUIRE(plan.counts[static_cast<std::size_t>(set)] == k);
                REQUIRE(static_cast<int>(columns.size()) == k);
                REQUIRE(columns.back() == m);
                int previous = 0;  // gaps from the end of the substep before count too
                for (int i = 1; i <= k; ++i) {
                    const int column = columns[static_cast<std::size_t>(i - 1)];
                    REQUIRE(column == (i * m + k - 1) / k);
                    REQUIRE(column - previous >= m / k);
                    REQUIRE(column - previous <= (m + k - 1) / k);
                    previous = column;
                }
            }
            const SubstepPlan::Column& last = plan.columns.back();
            REQUIRE(plan.constraints(last).size() == 3);
            REQUIRE(plan.contacts(last).size() == 2);
            REQUIRE(plan.sets.back() == 4);
            for (const SubstepPlan::Column& column : plan.columns) {
                const auto begin = plan.sets.begin();
                REQUIRE(std::is_sorted(begin + column.begin, begin + column.end));
                for (const int set : plan.constraints(column)) REQUIRE(set < 3);
                for (const int set : plan.contacts(column)) REQUIRE(set >= 3);
            }
        }
    }
}

TEST_CASE("Orders place sets in a column; equal orders keep registration", "[schedule]") {
    const Schedule schedule({{.name = "c", .order = -5, .contact = true},
                             {.name = "late", .order = 9},
                             {.name = "twin one", .order = 2},
                             {.name = "early", .order = -9},
                             {.name = "twin two", .order = 2}});
    CHECK(planOf(schedule, 0).sets == std::vector{3, 2, 4, 1, 0});
    CHECK(std::vector(schedule.order().begin(), schedule.order().end()) ==
          std::vector{3, 2, 4, 1, 0});
    CHECK(planOf(Schedule({}), 3).columns.empty());
}

TEST_CASE("Iterations and collision passes fix the counts of every substep", "[schedule]") {
    const Schedule schedule(figureSets(), {.substeps = 3, .iterations = 100});
    const Schedule both(figureSets(), {.substeps = 3, .iterations = 100, .collisionPasses = 10});
    const Schedule dense(figureSets(), {.iterations = 4, .collisionPasses = 12});
    for (int s = 0; s < 6; ++s) {
        CHECK(planOf(schedule, s).counts == std::vector{100, 100, 100, s % 3 == 2 ? 3 : 2, 2});
        const SubstepPlan plan = planOf(both, s);
        CHECK(plan.counts == std::vector{100, 100, 100, 10, 10});
        CHECK(columnsOf(plan, 4) == std::vector{10, 20, 30, 40, 50, 60, 70, 80, 90, 100});
        CHECK(columnsOf(planOf(dense, s), 0) == std::vector{3, 6, 9, 12});
    }
    CHECK(both.strength(0) == 1.0);
}

TEST_CASE("The secondary pass runs in every N-th pass of the busiest set", "[schedule][SC20]") {
    const auto bend = [](int interval, const ScheduleOptions& options) {
        return Schedule({{.name = "stretch", .importance = 8},
                         {.name = "shear", .importance = 3},
                         {.name = "bend", .importance = 500, .secondaryInterval = interval},
                         {.name = "collide", .importance = 20, .contact = true}},
                        options);
    };
    // Frequencies 1, 0.5 and 0.25 of 8 passes, given as iterations: contacts do not count.
    const ScheduleOptions eight{.iterations = 8, .collisionPasses = 2};
    CHECK(columnsOf(planOf(bend(1, eight), 5), 2) == std::vector{1, 2, 3, 4, 5, 6, 7, 8});
    CHECK(columnsOf(planOf(bend(2, eight), 5), 2) == std::vector{2, 4, 6, 8});
    CHECK(columnsOf(planOf(bend(4, eight), 5), 2) == std::vector{4, 8});

    // By importance: exactly 1/N of stretch in all, its intensity too where one a substep is more.
    for (const int interval : {1, 2, 4})
        for (int n = 1; n <= 30; ++n) {
            const Schedule schedule = bend(interval, {.substeps = n});
            const std::int64_t total = totalOf(schedule, 2, 0, n);
            REQUIRE(total == std::max(8 / interval, n));
            REQUIRE(schedule.strength(2) * static_cast<double>(total) == Approx(8.0 / interval));
        }
    // 5 passes a substep at frequency 0.5: two and three by turns.
    CHECK(countsOf(bend(2, {.iterations = 5}), 2, 4) == std::vector{2, 3, 2, 3});
    CHECK(columnsOf(planOf(bend(9, {.iterations = 5, .collisionPasses = 5}), 0), 2) ==
          std::vector{5});
}

TEST_CASE("A plan used again keeps its memory", "[schedule]") {
    for (const ScheduleMode mode : {ScheduleMode::interleaved, ScheduleMode::sequential}) {
        // 8 evaluations, then 9: more than a vector grown to 8 holds.
        const Schedule schedule({{.name = "set", .importance = 17}}, {.substeps = 2, .mode = mode});
        SubstepPlan plan;
        schedule.plan(0, plan);
        const int* const sets = plan.sets.data();
        const SubstepPlan::Column* const columns = plan.columns.data();
        const int* const counts = plan.counts.data();
        for (int s = 1; s < 9; ++s) {
            schedule.plan(s, plan);
            REQUIRE(plan.sets == planOf(schedule, s).sets);
            REQUIRE((plan.sets.data() == sets && plan.columns.data() == columns &&
                     plan.counts.data() == counts));
        }
    }
}

TEST_CASE("Bad numbers are refused by name", "[schedule]") {
    const auto refusal = [](const std::vector<ScheduledSet>& sets, const ScheduleOptions& options) {
        try {
            Schedule(sets, options);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    CHECK(refusal({{.name = "bend", .importance = 0}}, {}) ==
          "schedule: importance of set 'bend' must be 1 to 1000000, not 0");
    CHECK(refusal({{.name = "bend", .secondaryInterval = -2}}, {}) ==
          "schedule: secondary interval of set 'bend' must be 0 to 1000000, not -2");
    CHECK(refusal({{.name = "bend", .secondaryInterval = 2}}, {}) ==
          "schedule: secondary set 'bend' has no primary set to follow");
    CHECK(refusal({{.name = "floor", .contact = true, .secondaryInterval = 2}}, {}) ==
          "schedule: contact set 'floor' cannot be in the secondary pass");
    CHECK(refusal({}, {.substeps = 0}) == "schedule: substeps must be 1 to 1000000, not 0");
    CHECK(refusal({}, {.frameRate = {0, 1}}) ==
          "schedule: frames of the frame rate must be 1 to 1000000, not 0");
    CHECK(refusal({}, {.frameRate = {24, -1}}) ==
          "schedule: seconds of the frame rate must be 1 to 1000000, not -1");
    CHECK(refusal({}, {.iterations = -1}) == "schedule: iterations must be 0 to 1000000, not -1");
    CHECK(refusal({}, {.collisionPasses = -1}) ==
          "schedule: collision passes must be 0 to 1000000, not -1");
    CHECK(refusal({{.name = "set"}}, {.substeps = 999'983, .frameRate = {999'979, 1}}) ==
          "schedule: set 'set' at 24/999962000357 evaluations a substep is too fine a fraction");
    CHECK(refusal({{.name = "a"}, {.name = "b"}}, {}) == "accepted");  // equal orders are no fault
    SubstepPlan plan;
    CHECK_THROWS_AS(Schedule({}).plan(-1, plan), std::invalid_argument);
}
