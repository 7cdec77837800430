#include "ccd.h"

#include "ccd_data.h"
#include "demos/tools/errors.h"

#include <plait/solver.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>

namespace plait {
namespace {

constexpr int repeats = 5;
// Of the histogram, us.
constexpr std::array<double, 13> bounds{0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

struct Tally {
    std::vector<double> microseconds;
    int told = 0, missed = 0, invented = 0;
};

// The median of the repeats: this machine does other things too.
void ask(const CcdQuery& query, double thickness, bool touches, Tally& tally) {
    std::array<double, repeats> taken{};
    Impact impact;
    for (double& t : taken) {
        const auto start = std::chrono::steady_clock::now();
        impact = answer(query, thickness);
        t = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
                .count();
    }
    std::nth_element(taken.begin(), taken.begin() + repeats / 2, taken.end());
    tally.microseconds.push_back(taken[repeats / 2]);
    tally.told += impact.has_value();
    tally.missed += touches && !impact;
    tally.invented += !touches && impact;
}

void print(const std::string& name, Tally& tally, bool known) {
    auto& t = tally.microseconds;
    if (t.empty()) return;
    std::sort(t.begin(), t.end());
    std::printf("%-28s %6zu %6d", name.c_str(), t.size(), tally.told);
    if (known) {
        std::printf(" %6d %8d", tally.missed, tally.invented);
    } else {
        std::printf(" %6s %8s", "?", "?");
    }
    std::printf(" %7.2f %7.2f %7.1f ", t[t.size() / 2], t[t.size() * 99 / 100], t.back());
    std::size_t below = 0;
    for (const double bound : bounds) {
        const auto end = std::lower_bound(t.begin(), t.end(), bound);
        const auto count = static_cast<std::size_t>(end - t.begin());
        std::printf(" %5zu", count - below);
        below = count;
    }
    std::printf(" %5zu\n", t.size() - below);
}

void header() {
    std::printf("microseconds a query, the median of %d; on the right: how many took less than\n\n",
                repeats);
    std::printf("%-28s %6s %6s %6s %8s %7s %7s %7s ", "", "asked", "told", "missed", "invented",
                "median", "99 %", "worst");
    for (const double bound : bounds) std::printf(" %5g", bound);
    std::printf("  more\n");
}

void askTable(const std::string& name, const std::vector<CcdQuery>& queries) {
    Tally thin, thick, clear;
    for (const CcdQuery& q : queries) {
        ask(q, 0, q.touches, thin);
        if (!q.distances) continue;
        ask(q, 1.001 * q.leastHigh, true, thick);
        const double below = 0.999 * q.leastLow - 1e-6;
        if (below > 0) ask(q, below, false, clear);
    }
    print(name + ", thin", thin, true);
    print("  just reached", thick, true);
    print("  1e-6 clear", clear, true);
}

// Vertices anywhere in a cube, and going anywhere else in it.
std::vector<CcdQuery> randomQueries(bool edges) {
    std::uint64_t state = 1;
    const auto number = [&] {
        // Knuth's multiplier; the upper half of the state.
        state = state * 6364136223846793005 + 1442695040888963407;
        return static_cast<double>(state >> 32) * 0x1p-31 - 1;
    };
    std::vector<CcdQuery> queries(10'000);
    for (CcdQuery& q : queries) {
        q.edges = edges;
        for (MovingVertex& m : q.vertex)
            m = {{number(), number(), number()}, {number(), number(), number()}};
    }
    return queries;
}

void askRandom() {
    for (const bool edges : {false, true}) {
        Tally thin, thick;
        for (const CcdQuery& q : randomQueries(edges)) {
            ask(q, 0, false, thin);
            ask(q, 0.1, false, thick);
        }
        print(edges ? "random edges, thin" : "random triangles, thin", thin, false);
        print("  thick", thick, false);
    }
}

}  // namespace

int benchCcd() {
    const std::filesystem::path usual = "../shared/ccd", folder = ccdFolder(usual);
    const std::vector<std::string> tables = ccdTables(folder);
    if (tables.empty() && folder != usual)
        throw FileError(folder.string() + ": PLAIT_CCD_DATA names no folder of query sets");
    if (tables.empty())
        std::printf(
            "no query sets in %s, nor does PLAIT_CCD_DATA name a folder of them: random queries, "
            "whose answers are not known\n\n",
            usual.c_str());
    else
        std::printf(
            "just reached: with a thickness of 1.001 times the least distance; 1e-6 clear: of "
            "0.999 times less 1e-6\n");
    const FlushDenormals flush;
    header();
    for (const std::string& name : tables)
        askTable(name, readCcdQueries(folder / "open" / (name + ".csv.gz")));
    if (tables.empty()) askRandom();
    return 0;
}

}  // namespace plait
