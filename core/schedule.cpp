#include "schedule.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace plait {

namespace {

constexpr int largest = 1'000'000;

[[noreturn]] void refuse(const std::string& what) {
    throw std::invalid_argument("schedule: " + what);
}

void requireRange(const std::string& what, int value, int smallest) {
    if (value < smallest || value > largest)
        refuse(what + " must be " + std::to_string(smallest) + " to " + std::to_string(largest) +
               ", not " + std::to_string(value));
}

void validate(const ScheduledSet& set) {
    const std::string of = " of set '" + set.name + "'";
    requireRange("importance" + of, set.importance, 1);
    requireRange("secondary interval" + of, set.secondaryInterval, 0);
    if (set.contact && set.secondaryInterval > 0)
        refuse("contact set '" + set.name + "' cannot be in the secondary pass");
}

void validate(const ScheduleOptions& options) {
    requireRange("substeps", options.substeps, 1);
    requireRange("frames of the frame rate", options.frameRate.frames, 1);
    requireRange("seconds of the frame rate", options.frameRate.seconds, 1);
    requireRange("iterations", options.iterations, 0);
    requireRange("collision passes", options.collisionPasses, 0);
}

// The largest importance among primary sets other than contacts; 0 without any.
int busiestPrimary(const std::vector<ScheduledSet>& sets) {
    int busiest = 0;
    for (const ScheduledSet& set : sets)
        if (!set.contact && set.secondaryInterval == 0) busiest = std::max(busiest, set.importance);
    return busiest;
}

// Whether a set of k evaluations runs in column j of 1 to m.
bool runsIn(std::int64_t j, std::int64_t k, std::int64_t m) { return j * k / m > (j - 1) * k / m; }

std::span<const int> slice(const std::vector<int>& all, int begin, int end) {
    return std::span(all).subspan(static_cast<std::size_t>(begin),
                                  static_cast<std::size_t>(end - begin));
}

std::string padded(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

}  // namespace

std::span<const int> SubstepPlan::constraints(const Column& column) const {
    return slice(sets, column.begin, column.firstContact);
}

std::span<const int> SubstepPlan::contacts(const Column& column) const {
    return slice(sets, column.firstContact, column.end);
}

Schedule::Schedule(std::vector<ScheduledSet> sets, const ScheduleOptions& options)
    : sets_(std::move(sets)), options_(options), order_(sets_.size()) {
    validate(options_);
    for (const ScheduledSet& set : sets_) validate(set);

    const int busiest = busiestPrimary(sets_);
    std::int64_t most = 0;
    for (const ScheduledSet& set : sets_) {
        const Rate& r = rates_.emplace_back(rate(set, busiest));
        most += (r.numerator + r.denominator - 1) / r.denominator;
    }
    if (most > std::numeric_limits<int>::max())
        refuse(std::to_string(most) + " evaluations in a substep are too many");
    mostEvaluations_ = static_cast<std::size_t>(most);

    std::iota(order_.begin(), order_.end(), 0);
    std::ranges::sort(order_, {}, [this](int i) {
        const ScheduledSet& set = sets_[static_cast<std::size_t>(i)];
        return std::tuple(set.contact, set.order, i);
    });
}

Schedule::Rate Schedule::rate(const ScheduledSet& set, int busiest) const {
    const bool secondary = set.secondaryInterval > 0;
    if (secondary && busiest == 0)
        refuse("secondary set '" + set.name + "' has no primary set to follow");

    // Every factor is at most 1e6, so the products stay below 2^63.
    std::int64_t numerator = set.contact ? options_.collisionPasses : options_.iterations;
    std::int64_t denominator = secondary ? set.secondaryInterval : 1;
    if (numerator == 0) {
        numerator =
            std::int64_t{24} * (secondary ? busiest : set.importance) * options_.frameRate.seconds;
        denominator *= std::int64_t{options_.frameRate.frames} * options_.substeps;
    }
    const std::int64_t divisor = std::gcd(numerator, denominator);
    const Rate lowest{numerator / divisor, denominator / divisor};
    if (lowest.denominator > std::numeric_limits<std::int32_t>::max())
        refuse("set '" + set.name + "' at " + std::to_string(lowest.numerator) + "/" +
               std::to_string(lowest.denominator) +
               " evaluations a substep is too fine a fraction");
    return lowest;
}

int Schedule::count(int set, std::int64_t substep) const {
    const Rate& r = rates_[static_cast<std::size_t>(set)];
    // floor(s R) grows by the numerator every `denominator` substeps: of s only the remainder
    // matters, and with the whole part of R taken out no product exceeds the denominator squared.
    const std::int64_t s = substep % r.denominator;
    const std::int64_t part = r.numerator % r.denominator;
    const std::int64_t k =
        r.numerator / r.denominator + (s + 1) * part / r.denominator - s * part / r.denominator;
    return static_cast<int>(std::max(std::int64_t{1}, k));
}

double Schedule::strength(int set) const {
    const Rate& r = rates_[static_cast<std::size_t>(set)];
    return std::min(1.0, static_cast<double>(r.numerator) / static_cast<double>(r.denominator));
}

void Schedule::plan(std::int64_t substep, SubstepPlan& plan) const {
    if (substep < 0) refuse("substep must not be negative, not " + std::to_string(substep));
    plan.counts.resize(sets_.size());
    plan.sets.clear();
    plan.sets.reserve(mostEvaluations_);
    plan.columns.clear();
    plan.columns.reserve(mostEvaluations_);

    const bool sequential = options_.mode == ScheduleMode::sequential;
    const auto open = [&plan] {
        const int end = static_cast<int>(plan.sets.size());
        plan.columns.push_back({end, end, end});
    };
    const auto append = [&](int set) {
        plan.sets.push_back(set);
        ++plan.columns.back().end;
        if (!sets_[static_cast<std::size_t>(set)].contact) ++plan.columns.back().firstContact;
    };

    int m = 0;
    for (const int set : order_) {
        const int k = count(set, substep);
        plan.counts[static_cast<std::size_t>(set)] = k;
        m = std::max(m, k);
        for (int i = 0; sequential && i < k; ++i) {
            open();
            append(set);
        }
    }
    if (sequential) return;
    for (int j = 1; j <= m; ++j) {
        open();
        for (const int set : order_)
            if (runsIn(j, plan.counts[static_cast<std::size_t>(set)], m)) append(set);
    }
}

std::string print(const Schedule& schedule, std::int64_t substep) {
    SubstepPlan plan;
    schedule.plan(substep, plan);
    const bool sequential = schedule.options().mode == ScheduleMode::sequential;

    std::size_t labelWidth = 0;
    std::size_t width = 0;
    std::vector<std::string> labels;
    for (std::size_t set = 0; set < plan.counts.size(); ++set) {
        labels.push_back(schedule.sets()[set].name + " (" + std::to_string(plan.counts[set]) + ")");
        labelWidth = std::max(labelWidth, labels.back().size());
        width = std::max(width, static_cast<std::size_t>(plan.counts[set]));
    }

    std::vector<std::vector<bool>> marks(labels.size(), std::vector<bool>(width));
    std::vector<std::size_t> drawn(labels.size());
    for (std::size_t j = 0; j < plan.columns.size(); ++j)
        for (const int run : slice(plan.sets, plan.columns[j].begin, plan.columns[j].end)) {
            const auto set = static_cast<std::size_t>(run);
            marks[set][sequential ? drawn[set]++ : j] = true;
        }

    const std::size_t cell = std::to_string(width).size() + 1;
    std::string text = sequential ? "sequential: one row at a time, from the top\n"
                                  : "interleaved: one column at a time, from the top\n";
    text += std::string(labelWidth, ' ');
    for (std::size_t j = 1; j <= width; ++j) text += padded(std::to_string(j), cell);
    for (const int row : schedule.order()) {
        const auto set = static_cast<std::size_t>(row);
        text += "\n" + labels[set] + std::string(labelWidth - labels[set].size(), ' ');
        for (const bool mark : marks[set]) text += padded(mark ? "|" : ".", cell);
    }
    return text + "\n";
}

}  // namespace plait
