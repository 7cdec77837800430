// Chains at rest (validation D1 to D3): what sweeps make of a heavy tip, of stiff links beside soft
// ones, and of many links.
#include "hanging_chain.h"
#include "map.h"

#include <cmath>

namespace plait {
namespace {

constexpr int twenty = 20;

HangingChain rigid(int links, double tip = 1) {
    HangingChain chain{std::vector<double>(links, 1.0), std::vector<double>(links, 0.0)};
    chain.mass.back() = tip;
    return chain;
}

// Whole sweeps, from 1 up, of which the excess is `allowed`.
double sweepsFor(const HangingChain& chain, ChainSolve solve, double allowed) {
    double few = 1, many = 1;
    const auto excess = [&](double sweeps) {
        solve.sweeps = static_cast<int>(sweeps);
        return settledExcess(chain, solve);
    };
    while (excess(many) > allowed && many < 1e8) few = many, many *= 2;
    while (many - few > 1) {
        const double sweeps = std::floor((few + many) / 2);
        (excess(sweeps) > allowed ? few : many) = sweeps;
    }
    return many;
}

// The upper half soft, the lower `ratio` times as stiff, so that a heavy stiff piece hangs on soft
// links; 1 kg a link.
HangingChain halves(double ratio) {
    HangingChain chain{std::vector<double>(twenty, 1.0), std::vector<double>(twenty, 1.0 / 3600)};
    for (int i = twenty / 2; i < twenty; ++i) chain.compliance[i] /= ratio;
    return chain;
}

double extension(const HangingChain& chain) {
    double sum = 0;
    for (const double longer : chain.exact()) sum += longer;
    return sum;
}

}  // namespace

StabilityMap massRatioMap() {
    constexpr double allowed = 0.01;
    const auto cell = [](Method method) {
        return [=](double ratio, double sweeps) {
            const ChainSolve solve{
                .substeps = 10, .sweeps = static_cast<int>(sweeps), .method = method};
            return settle(rigid(twenty, ratio), solve, allowed, 0.4);
        };
    };
    const auto theory = [](double ratio) {
        return sweepsFor(rigid(twenty, ratio), {.substeps = 10}, allowed);
    };
    return {.name = "mass-ratio",
            .title = "A heavy tip on a chain of 20 links",
            .words =
                "A chain of 20 rigid links of 1 kg, 1 m long, hangs from rest for 0.4 s "
                "with damping, at 600 substeps a second. It drifts where it ends "
                "more than 1 % too long.",
            .note = "600 substeps a second; drifting: more than 1 % too long at rest",
            .theoryWords =
                "what the sweeps of a substep leave of the tensions, in the "
                "stationary state",
            .x = {"mass of the tip over that of a link", 1, 1e4},
            .y = {"sweeps in a substep", 1, 640, true},
            .goodAtLowY = false,
            .fails = Outcome::drifting,
            .boundaryAt = {1, 10, 100, 1e3, 1e4},
            .panels = {{"xpbd", cell(Method::xpbd), theory, true}, {"block", cell(Method::block)}}};
}

StabilityMap stiffnessRatioMap() {
    constexpr double allowed = 0.01;  // of the extension
    const auto cell = [](Method method) {
        return [=](double ratio, double sweeps) {
            const HangingChain chain = halves(ratio);
            const ChainSolve solve{
                .sweeps = static_cast<int>(sweeps), .method = method, .damping = 0.34};
            return settle(chain, solve, allowed * extension(chain), 3);
        };
    };
    const auto theory = [](Method method) {
        return [=](double ratio) {
            const HangingChain chain = halves(ratio);
            return sweepsFor(chain, {.method = method}, allowed * extension(chain));
        };
    };
    return {.name = "stiffness-ratio",
            .title = "Stiff links below soft ones",
            .words =
                "A chain of 20 links of 1 kg, 1 m long, hangs from rest for 3 s with "
                "damping, at 60 steps a second. The upper half is of springs of 3600 "
                "N/m. It drifts where its extension ends more than 1 % wrong.",
            .note =
                "chain of 20 links, 60 steps a second; drifting: extension more than "
                "1 % wrong at rest",
            .theoryWords =
                "what the sweeps of a step leave, in the stationary state: by "
                "links (xpbd) the ratio hardly matters, by vertices (block) "
                "sweeps grow with it",
            .x = {"stiffness of the lower half over the upper", 1, 1e6},
            .y = {"sweeps in a step", 1, 512, true},
            .goodAtLowY = false,
            .fails = Outcome::drifting,
            .boundaryAt = {1, 10, 100, 1e3, 1e4, 1e5, 1e6},
            .panels = {{"xpbd", cell(Method::xpbd), theory(Method::xpbd)},
                       {"block", cell(Method::block), theory(Method::block), true}}};
}

StabilityMap chainLengthMap() {
    constexpr double allowed = 0.01;
    constexpr int most = 400;
    const auto cell = [](auto solve) {
        return [=](double budget, double links) {
            return settle(rigid(static_cast<int>(links)), solve(static_cast<int>(budget)), allowed,
                          1);
        };
    };
    const auto substeps = [](int budget) { return ChainSolve{.substeps = budget, .sweeps = 1}; };
    const auto sweeps = [](int budget) { return ChainSolve{.sweeps = budget}; };
    const auto linksOfSubsteps = [](double budget) {
        const double h = 1 / (60 * budget);
        return std::sqrt(2 * (allowed / (9.81 * h * h) + 1));
    };
    const auto linksOfSweeps = [](double budget) {
        int links = 2;
        while (links < most &&
               settledExcess(rigid(links + 1), {.sweeps = static_cast<int>(budget)}) < allowed)
            ++links;
        return double(links);
    };
    return {.name = "chain-length",
            .title = "How many links a budget of sweeps holds together",
            .words =
                "A chain of rigid links of 1 kg, 1 m long, hangs from rest for 1 s "
                "with damping. The budget is spent on substeps of one sweep, or on "
                "sweeps of one step. It drifts where it ends more than 1 % too long.",
            .note = "xpbd; drifting: more than 1 % too long at rest",
            .theoryWords =
                "substeps: g h^2 (N^2 / 2 - 1); iterations: what "
                "the sweeps of a step leave of the tensions",
            .x = {"sweeps in 1/60 s", 1, 128, true},
            .y = {"links", 2, most, true},
            .fails = Outcome::drifting,
            .boundaryAt = {1, 4, 16, 64},
            .panels = {{"budget x 1 sweep", cell(substeps), linksOfSubsteps, true},
                       {"1 step x budget", cell(sweeps), linksOfSweeps, true}}};
}

}  // namespace plait
