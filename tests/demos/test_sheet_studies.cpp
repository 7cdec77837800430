// What studies of sheets are held against: soft motion by Runge-Kutta, the peers' table, and the
// converged solution of one step.
#include "demos/study/definitions/definitions.h"
#include "demos/study/definitions/peers.h"
#include "demos/study/references/reference.h"
#include "demos/study/references/soft_motion.h"
#include "demos/study/solve.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <cmath>
#include <limits>
#include <sstream>

using namespace plait;
using namespace plait::test;

namespace {

// x'' = g - x from x = 1 at rest, at 2, 4 ... 20 s: x = g + (1 - g) cos t.
double errorOfSoftMotion(int steps) {
    const World world = studyRun(studyNamed("unit-spring"), {}).scene.world;
    const double g = 0.25;
    Trajectory exact;
    for (int f = 1; f <= 10; ++f)
        exact.push_back({Vec<double>{g + (1 - g) * std::cos(2.0 * f), 0, 0}});
    return rmsDistance(softMotion(world, {g, 0, 0}, 2, 10, steps), exact, 10, 1);
}

}  // namespace

TEST_CASE("soft motion is that of springs under gravity, to order 4", "[study]") {
    const double coarse = errorOfSoftMotion(64), half = errorOfSoftMotion(128);
    CHECK(report("soft motion, order less 4", std::fabs(std::log2(coarse / half) - 4), 0.02));
    // Amplitude and phase of Runge-Kutta 4 are off by h^5 / 144 and h^5 / 120 a step.
    CHECK(report("soft motion, 20 s in steps of 1/64 s", half, 20 * std::pow(64, -4) / 100));
    const World rigid = studyRun(studyNamed("pendulum"), {}).scene.world;
    CHECK_THROWS_AS(softMotion(rigid, down, 1, 1, 1), std::invalid_argument);
}

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// "×256" times its length, "310 %", or a dash: as a strain.
double strainFrom(const std::string& cell) {
    if (cell.starts_with("×")) return std::stod(cell.substr(std::string("×").size())) - 1;
    return cell.ends_with("%") ? std::stod(cell) / 100 : unknown;
}

// Rows as they were measured: engine | substeps x iterations | ms of 1/60 s | strain at the end |
// mean of it | worst | mean of the second second | frame at which it blew up.
struct Measured {
    int n;
    const char* rows;
};
constexpr Measured measured[] = {{128, R"(Bullet|1x10|10.1|×256|310 %|×256|×196|no
Bullet|1x20|17.8|×113|107 %|×134|×123|no
Bullet|10x4|69.4|486 %|4.75 %|744 %|375 %|no
Jolt|5x1|2.58|×3.4e+04|×123|×3.4e+04|–|23
Jolt|10x1|5.1|×7.4e+04|×93.9|×7.4e+04|–|12
Jolt|20x1|10.1|×7.44e+04|×244|×7.44e+04|–|6
Jolt|40x1|20.1|×4e+06|×3.8e+03|×4e+06|–|3
Jolt + LRA|20x1|12|×175|438 %|×250|×202|no
PBD lib float|1x20|22.8|×146|150 %|×169|×151|no
PBD lib float|10x1|14.7|969 %|8.46 %|×40.7|×11.5|no
PBD lib float|20x1|28.1|562 %|6.19 %|992 %|474 %|no
PBD lib float|50x1|66.2|106 %|0.767 %|264 %|95.3 %|no
Blender|-|616|0.11 %|–|0.1 %|–|no
)"},
                                 {256, R"(Bullet|1x10|61.2|×698|509 %|×698|×438|no
Bullet|1x20|89.8|×611|427 %|×611|×390|no
Bullet|10x4|340|×47.9|23 %|×56|×46.1|no
Jolt|5x1|11.4|×1.29e+05|×85.1|×1.29e+05|–|24
Jolt|10x1|22.6|×6.37e+04|×38|×6.37e+04|–|12
Jolt|20x1|45|×4.57e+05|×138|×4.57e+05|–|6
Jolt|40x1|89.5|×1.89e+07|×2.46e+03|×1.89e+07|–|3
Jolt + LRA|20x1|56.8|×452|×39|×569|×505|no
PBD lib float|1x20|91.7|×794|433 %|×794|×511|no
PBD lib float|10x1|61.2|×231|113 %|×278|×250|no
PBD lib float|20x1|117|×12.1|6.09 %|×80.7|×24.9|no
)"}};

// The point that such a row must have become.
PeerPoint pointFrom(const std::string& row, int n) {
    std::vector<std::string> cells{""};
    for (const char c : row) {
        if (c == '|')
            cells.emplace_back();
        else
            cells.back() += c;
    }
    PeerPoint point{.cost = std::stod(cells[2]) * 2.5, .evaluations = 0, .errors = {}};
    const double links = 2.0 * n * (n - 1) + (n - 1.0) * (n - 1);
    const std::size_t times = cells[1].find('x');
    if (times != std::string::npos)
        point.evaluations =
            60 * links * std::stod(cells[1]) * std::stod(cells[1].substr(times + 1));
    const bool burst = cells[7] != "no";
    for (const std::size_t column : {5, 6, 3, 4})
        point.errors.push_back(burst ? std::numeric_limits<double>::infinity()
                                     : strainFrom(cells[column]));
    return point;
}

bool alike(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b)) || std::fabs(a / b - 1) < 1e-9;
}

}  // namespace

TEST_CASE("peers stand in charts as they were measured", "[study]") {
    for (const auto& [n, rows] : measured) {
        std::vector<PeerPoint> points;
        for (const Peer& peer : peersOnSheet(n))
            points.insert(points.end(), peer.points.begin(), peer.points.end());
        std::istringstream lines(rows);
        std::size_t i = 0;
        for (std::string row; std::getline(lines, row); ++i) {
            INFO(n << ": " << row);
            REQUIRE(i < points.size());
            const PeerPoint expected = pointFrom(row, n);
            CHECK(alike(points[i].cost, expected.cost));
            CHECK(alike(points[i].evaluations, expected.evaluations));
            for (std::size_t e = 0; e < 4; ++e)
                CHECK(alike(points[i].errors[e], expected.errors[e]));
        }
        CHECK(i == points.size());
    }
}

// Of one step: xpbd drops what is left of the momentum equation, and stays a fixed way off
// (validation B, the floor of method 5); descent over vertices goes all the way.
TEST_CASE("sweeps come near Newton's solution of a step of a sheet", "[study]") {
    const Study study = sheetStep(12);
    const Reference reference = findReference(study);
    REQUIRE(reference.frames == 1);
    const auto error = [&](const Settings& settings, int sweeps) {
        const Run run = studyRun(study, with(settings, "iterations", std::to_string(sweeps)));
        return study.measure(study, run, solve(study, run, false), reference)[0];
    };
    for (const Settings& settings : {firstOrder, by("block")}) {
        const std::string name = "step of 12 x 12, " + settings[0].second;
        const double start = error(settings, 1);
        double before = start;
        for (const int sweeps : {4, 16, 64}) {
            const double after = error(settings, sweeps);
            CHECK(after < before);
            before = after;
        }
        CHECK(report(name + ": error after 64 sweeps over that after one", before / start, 0.05));
    }
    const double floor = error(firstOrder, 256);
    note("step of 12 x 12, xpbd: floor, m", floor);
    CHECK(std::fabs(error(firstOrder, 512) / floor - 1) < 1e-3);
    CHECK(report("step of 12 x 12, block, 1,024 sweeps: m", error(by("block"), 1024), 1e-15));
}
