// The schedule: how often, and in which order, the sets of constraints are evaluated in a substep.
//
// It knows of a set only its order and its importance (S 6), so a user's own set takes part like
// any other. It is data, in integers: it can be printed, compared and drawn.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plait {

// What the scheduler knows of a set.
struct ScheduledSet {
    std::string name;      // for messages and tables only
    int order = 0;         // place in a column, later wins; equal orders keep registration order
    int importance = 1;    // evaluations in 1/24 s, 1 to 1e6 (M 2.2)
    bool contact = false;  // after all other sets of its column, whatever the orders (M 2.2)
    // 0: the set runs by its importance. N, 1 to 1e6: it is in the secondary pass and runs in every
    // N-th pass of the most important primary set, its own importance unused (V: frequency 1/N).
    int secondaryInterval = 0;
};

// Frames in a number of seconds, each 1 to 1e6: {24, 1}, or {30000, 1001} for 29.97.
struct FrameRate {
    int frames = 24;
    int seconds = 1;
};

enum class ScheduleMode {
    interleaved,  // column by column, the sets spread evenly over the columns (S figure 11)
    sequential,   // all evaluations of one set, then the next: the baseline that fails (S figure 9)
};

struct ScheduleOptions {
    int substeps = 1;  // in a frame, 1 to 1e6
    FrameRate frameRate = {};
    ScheduleMode mode = ScheduleMode::interleaved;
    int iterations = 0;       // K > 0: K evaluations a substep for every set but contacts (V)
    int collisionPasses = 0;  // P > 0: P evaluations a substep for every contact set (V)
};

// The evaluations of one substep in the order they run.
struct SubstepPlan {
    // Places in `sets`: [begin, firstContact) are the column's non-contact sets, [firstContact,
    // end) its contact sets, each by order.
    struct Column {
        int begin;
        int firstContact;
        int end;
    };
    std::vector<int> counts;  // evaluations of each set, by registration index
    std::vector<int> sets;    // registration indices, column after column
    std::vector<Column> columns;

    std::span<const int> constraints(const Column& column) const;
    std::span<const int> contacts(const Column& column) const;
};

// For a frame of T seconds in n substeps let R = I * 24 T / n for a set of importance I; R = K or P
// where those are given; and for the secondary pass R = R' / N, with R' that of the most important
// primary set that is no contact. All in exact arithmetic:
//
// - in substep s of the run a set is evaluated k = max(1, floor((s+1) R) - floor(s R)) times, so
//   that its total is exact over time and every effect is evaluated once a substep (M 2.4, 4.1);
// - the busiest set fixes the number of columns, m = max k, and a set runs in column j (1 to m)
//   where floor(j k / m) > floor((j-1) k / m): its i-th evaluation is in column ceil(i m / k), so
//   gaps differ by at most one, the last column is complete, and contacts are the last word (S 6).
//
// A secondary set thus has exactly 1/N of the passes in the long run, where that is at least one a
// substep; where R' = m and N divides m it is in columns N, 2N, ..., m. V's smoothing iterations
// and post-collision passes follow the last column and are no part of the table.
class Schedule {
public:
    // Sets are known from here on by their place in `sets`. Throws std::invalid_argument, naming
    // the value, for numbers out of range, for a contact set in the secondary pass, for a secondary
    // pass without a primary set, and for frame rates and substeps whose R is no fraction of 31-bit
    // denominator.
    explicit Schedule(std::vector<ScheduledSet> sets, const ScheduleOptions& options = {});

    const std::vector<ScheduledSet>& sets() const { return sets_; }
    const ScheduleOptions& options() const { return options_; }

    // Registration indices in the order of a complete column: non-contact sets, then contact sets,
    // each by order.
    std::span<const int> order() const { return order_; }

    // k of `set` in `substep`, which counts from 0 at the start of the run.
    int count(int set, std::int64_t substep) const;

    // min(1, R), constant over substeps: the factor by which a method whose stiffness lies in the
    // number of evaluations weakens each, where one a substep is more than was asked for (M 2.4).
    // Sets whose stiffness is a compliance need none.
    double strength(int set) const;

    // Writes the evaluations of `substep` over `plan`; a plan that is used again with the same
    // schedule allocates nothing. Throws std::invalid_argument for a negative substep.
    void plan(std::int64_t substep, SubstepPlan& plan) const;

private:
    // R in lowest terms.
    struct Rate {
        std::int64_t numerator;
        std::int64_t denominator;
    };
    Rate rate(const ScheduledSet& set, int busiest) const;

    std::vector<ScheduledSet> sets_;
    ScheduleOptions options_;
    std::vector<Rate> rates_;          // by registration index
    std::vector<int> order_;           // registration indices in the order of a column
    std::size_t mostEvaluations_ = 0;  // no substep has more
};

// The substep as a table, as S figures 9 and 11 draw it: a row for each set with its count, in
// order from the top; a mark for each evaluation. Interleaved, it runs column by column;
// sequential, row by row, each row drawn from the first column.
std::string print(const Schedule& schedule, std::int64_t substep);

}  // namespace plait
