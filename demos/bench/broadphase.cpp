#include "broadphase.h"

#include "broadphase_sets.h"
#include "demos/tools/files.h"
#include "demos/tools/machine.h"
#include "render/charts/chart.h"

#include <plait/collision/hash_grid.h>
#include <plait/collision/kdop_tree.h>
#include <plait/collision/query.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace plait {
namespace {

constexpr int sizes[]{1000, 10000, 100000, 1000000};
constexpr std::size_t methods = 5;  // of measureAll
constexpr int firstParticles = 3;   // of the sets

double now(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The best of some rounds, with one thread and with two in turns, so that a change of the machine's
// mood meets both.
class Times {
public:
    template <class Body>
    void measure(Workers* const (&workers)[2], const Body& body) {
        const double own = now(CLOCK_THREAD_CPUTIME_ID);
        for (int t = 0; t < 2; ++t) {
            const double start = now(CLOCK_MONOTONIC);
            body(*workers[t]);
            wall_[t] = std::min(wall_[t], now(CLOCK_MONOTONIC) - start);
            if (t == 0) own_ = std::min(own_, now(CLOCK_THREAD_CPUTIME_ID) - own);
        }
    }
    double one() const { return own_; }  // s of the processor, which other programs leave alone
    double gain() const { return wall_[0] / wall_[1]; }

private:
    double own_ = HUGE_VAL, wall_[2]{HUGE_VAL, HUGE_VAL};
};

struct Row {
    std::string set, method;
    int count = 0;
    Times build{}, refit{}, pairs{};  // refit: a grid has none
    double candidates = 0;            // a primitive
    double query = 0;                 // s a candidate

    double nanoseconds(double seconds) const { return 1e9 * seconds / count; }
    // A substep, its queries included, with what is done in `prepare`: ns a primitive.
    double substep(const Times& prepare) const {
        return nanoseconds(prepare.one() + pairs.one()) + 1e9 * candidates * query;
    }
};

void ask(const BroadPhaseSet& set, const Candidate& pair) {
    const auto a = set.primitive(pair.a), b = set.primitive(pair.b);
    const auto way = [&](int v) { return MovingVertex{set.start[v], set.end[v]}; };
    if (set.arity == 1)
        thickPointPoint(way(a[0]), way(b[0]), 2 * set.radius);
    else
        thickEdgeEdge(way(a[0]), way(a[1]), way(b[0]), way(b[1]), 2 * set.radius);
}

// Seconds a candidate, of some of them; the best of some rounds.
double queryCost(const BroadPhaseSet& set, std::span<const Candidate> found) {
    const std::size_t step = 1 + found.size() / 20000, asked = (found.size() + step - 1) / step;
    double best = HUGE_VAL;
    for (int round = 0; round < 5 && asked > 0; ++round) {
        const double start = now(CLOCK_THREAD_CPUTIME_ID);
        for (std::size_t i = 0; i < found.size(); i += step) ask(set, found[i]);
        best = std::min(best, now(CLOCK_THREAD_CPUTIME_ID) - start);
    }
    return asked > 0 ? best / double(asked) : 0;
}

template <int k>
auto bounds(const BroadPhaseSet& set) {
    return [&set](int i) {
        return sweptBounds<k>(set.primitive(i), {set.start, set.end, set.radius, {}});
    };
}

// round(row, workers, found, apart) for some rounds.
template <class Round>
Row measured(const BroadPhaseSet& set, const std::string& method, const Round& round) {
    Row row{.set = set.name, .method = method, .count = set.count()};
    Workers one(1), two(2);
    Candidates found;
    const NoSharedVertex apart{set.vertices, set.arity, set.vertices, set.arity};
    const int rounds = std::clamp(200000 / set.count(), 2, 50);
    for (int i = 0; i < rounds; ++i) round(row, {&one, &two}, found, apart);
    row.candidates = double(found.pairs().size()) / set.count();
    row.query = queryCost(set, found.pairs());
    return row;
}

template <int k>
Row measureTree(const BroadPhaseSet& set) {
    const auto bound = bounds<k>(set);
    Workers serial(1);
    KDopTree<k> tree(set.count(), bound, serial);
    return measured(
        set, k == 6 ? "AABB" : std::to_string(k) + "-DOP",
        [&](Row& row, Workers* const(&workers)[2], Candidates& found, const NoSharedVertex& apart) {
            row.build.measure(workers, [&](Workers& w) { KDopTree<k>(set.count(), bound, w); });
            row.refit.measure(workers, [&](Workers& w) { tree.refit(bound, w); });
            row.pairs.measure(workers, [&](Workers& w) { tree.selfPairs(found, w, apart); });
        });
}

Row measureGrid(const BroadPhaseSet& set) {
    const auto bound = bounds<6>(set);
    HashGrid grid;
    Row row = measured(
        set, "hash",
        [&](Row& r, Workers* const(&workers)[2], Candidates& found, const NoSharedVertex& apart) {
            r.build.measure(workers, [&](Workers& w) { grid.build(set.count(), bound, w); });
            r.pairs.measure(workers, [&](Workers& w) { grid.selfPairs(found, w, apart); });
        });
    row.refit = row.build;
    return row;
}

std::vector<Row> measureAll(const BroadPhaseSet& set) {
    return {measureTree<6>(set), measureTree<14>(set), measureTree<18>(set), measureTree<26>(set),
            measureGrid(set)};
}

void print(const Row& row) {
    const bool grid = row.method == "hash";
    std::printf("%-22s %8d %-7s %8.0f ", row.set.c_str(), row.count, row.method.c_str(),
                row.nanoseconds(row.build.one()));
    if (grid)
        std::printf("%8s ", "");
    else
        std::printf("%8.0f ", row.nanoseconds(row.refit.one()));
    std::printf("%8.0f %8.2f %8.0f %8.0f  %5.2f ", row.nanoseconds(row.pairs.one()), row.candidates,
                1e9 * row.query, row.substep(row.refit), row.build.gain());
    if (grid)
        std::printf("%5s ", "");
    else
        std::printf("%5.2f ", row.refit.gain());
    std::printf("%5.2f\n", row.pairs.gain());
    std::fflush(stdout);
}

std::string csvOf(const std::vector<Row>& rows) {
    std::string csv =
        "set,primitives,method,build[s],refit[s],pairs[s],candidates,query[s],buildGain,refitGain,"
        "pairsGain\n";
    for (const Row& row : rows) {
        char line[256];
        std::snprintf(line, sizeof line, "\"%s\",%d,%s,%.4g,%.4g,%.4g,%.6g,%.4g,%.3g,%.3g,%.3g\n",
                      row.set.c_str(), row.count, row.method.c_str(), row.build.one(),
                      row.refit.one(), row.pairs.one(), row.candidates * row.count, row.query,
                      row.build.gain(), row.refit.gain(), row.pairs.gain());
        csv += line;
    }
    return csv;
}

// Of one set, in the order of measureAll within each count.
Chart chartOf(std::span<const Row> rows, bool particles) {
    Chart chart{.title = rows[0].set,
                .x = {.label = "primitives", .logarithmic = true},
                .y = {.label = "substep [ns a primitive]", .logarithmic = true}};
    const auto add = [&](std::size_t method, const std::string& name, Times Row::* prepare, int i) {
        Curve curve{.name = name, .style = curveStyle(i)};
        for (std::size_t r = method; r < rows.size(); r += methods)
            curve.points.push_back({double(rows[r].count), rows[r].substep(rows[r].*prepare)});
        chart.curves.push_back(curve);
    };
    for (std::size_t m = 0; m < methods; ++m)
        add(m, rows[m].method, &Row::refit, static_cast<int>(m));
    if (particles) add(0, "AABB, built each substep", &Row::build, methods);
    return chart;
}

Figure figureOf(const std::vector<Row>& rows) {
    Figure figure{.title = "The broad phase: bounds anew, candidates, and their queries",
                  .note = "one thread, " + thisMachine().processor,
                  .columns = 3,
                  .height = 900};
    const std::size_t each = methods * std::size(sizes);
    for (int set = 0; set < broadPhaseSets; ++set)
        figure.charts.push_back(
            chartOf(std::span(rows).subspan(set * each, each), set >= firstParticles));
    return figure;
}

// The claims of the catalogue, for the largest count.
void answerClaims(const std::vector<Row>& rows) {
    std::printf("\nat %d primitives, substeps with their queries:\n", sizes[std::size(sizes) - 1]);
    for (std::size_t set = 0; set < broadPhaseSets; ++set) {
        const Row* row = &rows[((set + 1) * std::size(sizes) - 1) * methods];
        const double box = row->substep(row->refit),
                     hash = row[methods - 1].substep(row[methods - 1].build);
        if (set >= firstParticles) {
            std::printf(
                "BP3 %-22s hash %.2f of an AABB tree built each substep, %.2f of one refitted\n",
                row->set.c_str(), hash / row->substep(row->build), hash / box);
            continue;
        }
        std::printf("BP2 %-22s", row->set.c_str());
        for (std::size_t m = 1; m < methods; ++m)
            std::printf(" %s %.2f", row[m].method.c_str(), row[m].substep(row[m].refit) / box);
        std::printf(" of an AABB tree\n");
    }
}

// How many times faster two threads are, medians: on fewer primitives the first halvings of a tree,
// which are one thread's, are too much of it.
void printGains(const std::vector<Row>& rows) {
    constexpr int least = 5000;
    std::printf("two threads, from %d primitives on, medians:", least);
    for (const auto& [name, times] :
         {std::pair{"build", &Row::build}, {"refit", &Row::refit}, {"pairs", &Row::pairs}}) {
        std::vector<double> gains;
        for (const Row& row : rows)
            if (row.count >= least) gains.push_back((row.*times).gain());
        const auto middle = gains.begin() + static_cast<long>(gains.size() / 2);
        std::nth_element(gains.begin(), middle, gains.end());
        std::printf(" %s %.2f", name, *middle);
    }
    std::printf(" times faster than one\n");
}

}  // namespace

int benchBroadPhase() {
    double load = 0;
    if (getloadavg(&load, 1) < 1) load = 0;
    std::printf(
        "broad phase, ns a primitive with one thread; `two` is how many times faster two threads "
        "are, which other programs spoil:\nload before the start %.1f, on %d cores\n\n",
        load, usableCores());
    std::printf("%-22s %8s %-7s %8s %8s %8s %8s %8s %8s  %17s\n", "", "", "", "", "", "", "candi-",
                "ns a", "", "two: build refit pairs");
    std::printf("%-22s %8s %-7s %8s %8s %8s %8s %8s %8s\n", "", "", "", "build", "refit", "pairs",
                "dates", "query", "substep");
    std::vector<Row> rows;
    for (int set = 0; set < broadPhaseSets; ++set)
        for (const int count : sizes)
            for (const Row& row : measureAll(broadPhaseSet(set, count))) {
                print(row);
                rows.push_back(row);
            }
    answerClaims(rows);
    printGains(rows);
    const std::filesystem::path folder = "out/bench/broadphase";
    makeFolder(folder);
    writeWhole(folder / "table.csv", csvOf(rows));
    writeFigure(folder / "chart", figureOf(rows));
    std::printf("\n%s\n", (folder / "chart.svg").c_str());
    return 0;
}

}  // namespace plait
