#include "detection.h"

#include "broadphase_sets.h"
#include "demos/tools/files.h"
#include "demos/tools/machine.h"
#include "render/charts/chart.h"

#include <plait/contacts/search/pair_search.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

namespace plait {
namespace {

constexpr int sizes[]{10000, 30000, 100000, 300000, 1000000};

struct Row {
    int triangles = 0;
    double first = HUGE_VAL, again = HUGE_VAL;  // s: trees built, and trees refitted
    long pairs = 0;
    bool looked = true;
};

// Of one thread, which other programs leave alone.
double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Higher folds: all has left its margin, and no rigid motion leads there.
std::vector<Vec<double>> stretched(std::vector<Vec<double>> x) {
    for (Vec<double>& p : x) p.z *= 1.1;
    return x;
}

// The best of some rounds.
Row measured(int count) {
    const FoldedSheets sheets = foldedSheets(count);
    const int vertices = static_cast<int>(sheets.start.size());
    const std::vector<Vec<double>> start = stretched(sheets.start), end = stretched(sheets.end);
    const std::vector<unsigned char> pinned(sheets.start.size(), 0);
    Row row{.triangles = sheets.complex.count(2)};
    Workers one(1);
    for (int round = 0; round < std::clamp(300000 / count, 2, 10); ++round) {
        PairSearch search(sheets.complex, {{.vertices = {0, vertices}, .thickness = sheets.radius}},
                          pinned, sheets.margin);
        const double begun = now();
        row.looked &= search.cover(sheets.start, sheets.end, sheets.radius, one);
        const double built = now();
        row.looked &= search.cover(start, end, sheets.radius, one);
        row.first = std::min(row.first, built - begun);
        row.again = std::min(row.again, now() - built);
        row.pairs = search.size();
    }
    return row;
}

Curve curveOf(const std::vector<Row>& rows, const char* name, double Row::* seconds, int style) {
    Curve curve{.name = name, .style = curveStyle(style)};
    for (const Row& row : rows)
        curve.points.push_back({double(row.triangles), 1e9 * row.*seconds / row.triangles});
    return curve;
}

// n log n through the first point.
Curve theoryOf(const Curve& found) {
    Curve curve{.name = "n log n", .style = theoryStyle};
    const ChartPoint& from = found.points.front();
    for (const ChartPoint& point : found.points)
        curve.points.push_back({point.x, from.y * std::log(point.x) / std::log(from.x)});
    return curve;
}

Figure figureOf(const std::vector<Row>& rows) {
    Chart chart{.x = {.label = "triangles", .logarithmic = true},
                .y = {.label = "looking for pairs [ns a triangle]", .logarithmic = true}};
    chart.curves = {curveOf(rows, "trees built", &Row::first, 1),
                    curveOf(rows, "trees refitted", &Row::again, 2)};
    chart.curves.push_back(theoryOf(chart.curves[0]));
    chart.curves.push_back(theoryOf(chart.curves[1]));
    chart.curves.back().name.clear();
    return {.title = "Looking for contacts: crumpled sheets on each other",
            .note = "one thread, " + thisMachine().processor,
            .charts = {chart}};
}

}  // namespace

int benchDetection() {
    std::printf(
        "pairs of sheets that lie on each other in folds, points with triangles and edges with\n"
        "edges, all looked for anew, one thread; growth: time beside that of the first line, over\n"
        "that of n log n\n\n%9s %10s %14s %14s %8s %14s %8s\n",
        "triangles", "pairs each", "build [ns]", "/ log2 n", "growth", "refit [ns]", "growth");
    std::vector<Row> rows;
    for (const int count : sizes) {
        rows.push_back(measured(count));
        const Row& row = rows.back();
        const double n = row.triangles, n0 = rows[0].triangles;
        const double bits = std::log2(n), expected = n * bits / (n0 * std::log2(n0));
        std::printf("%9d %10.2f %14.0f %14.1f %8.2f %14.0f %8.2f%s\n", row.triangles,
                    double(row.pairs) / n, 1e9 * row.first / n, 1e9 * row.first / n / bits,
                    row.first / rows[0].first / expected, 1e9 * row.again / n,
                    row.again / rows[0].again / expected, row.looked ? "" : "  NOT LOOKED FOR");
        std::fflush(stdout);
    }
    const std::filesystem::path folder = "out/bench/detection";
    makeFolder(folder);
    writeFigure(folder / "chart", figureOf(rows));
    std::printf("\n%s\n", (folder / "chart.svg").c_str());
    return 0;
}

}  // namespace plait
