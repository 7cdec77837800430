// Grains pair by pair, by what V says of its averages and its shock, and in heaps.
#include "tests/catch.h"
#include "tests/report.h"

#include <plait/complex/shapes.h>
#include <plait/contacts/solids/collider.h>
#include <plait/forces/gravity.h>
#include <plait/grains/grains.h>
#include <plait/numbers/splitmix.h>
#include <plait/solver.h>

#include <algorithm>

using namespace plait;
using namespace plait::test;

namespace {

constexpr double r = 0.01;

struct Heap {
    World world;
    Grains grains;

    Heap(std::vector<Vec<double>> at, Grains given, double mass = 0.01) : grains(std::move(given)) {
        const auto n = static_cast<int>(at.size());
        grains.slop = 0;
        grains.vertices = world.add({SimplicialComplex(n), std::move(at)}, {.density = mass});
    }
    void push() { pushGrains(world, grains, {.name = "grains", .importance = 1}); }
};

SolverOptions once(int iterations = 1) {
    SolverOptions options;
    options.schedule = {.substeps = 1, .frameRate = {1, 1}, .iterations = iterations};
    options.sweeps = Sweeps::oneWay;
    return options;
}

// A substep of 1 s of nothing else: velocities are what moved (m).
template <class Real = double>
std::vector<Vec<double>> moved(Heap heap, int iterations = 1) {
    heap.push();
    Solver<Real> solver(heap.world, once(iterations));
    solver.frame();
    return solver.velocities();
}

std::vector<Vec<double>> cloud(int n, double side) {
    Splitmix chance(5);
    std::vector<Vec<double>> at;
    for (int i = 0; i < n; ++i)
        at.push_back({side * chance.next(), side * chance.next(), side * chance.next()});
    return at;
}

Vec<double> sum(const std::vector<Vec<double>>& of) {
    Vec<double> all{0, 0, 0};
    for (const Vec<double>& v : of) all += v;
    return all;
}

double largest(const std::vector<Vec<double>>& of) {
    double most = 0;
    for (const Vec<double>& v : of) most = std::max(most, length(v));
    return most;
}

bool same(const std::vector<Vec<double>>& a, const std::vector<Vec<double>>& b) {
    bool all = a.size() == b.size();
    for (std::size_t i = 0; all && i < a.size(); ++i) all = length(a[i] - b[i]) == 0;
    return all;
}

}  // namespace

TEST_CASE("grains: two are pushed apart, or drawn together, by their weights",
          "[grains][GR5][GR6][GR7]") {
    const std::vector<Vec<double>> near{{0, 0, 0}, {0.016, 0, 0}}, far{{0, 0, 0}, {0.024, 0, 0}};
    const auto gap = [](std::vector<Vec<double>> at, const Grains& grains) {
        const auto by = moved({at, grains});
        CHECK(length(by[0] + by[1]) < 1e-15);
        return length(at[1] + by[1] - at[0] - by[0]) - 2 * r;
    };
    CHECK(std::fabs(gap(near, {.radius = r})) < 1e-15);
    CHECK(gap(near, {.radius = r, .weight = 0.5}) == Approx(-0.002));
    CHECK(gap(near, {.radius = r, .repulsion = 0.25}) == Approx(-0.003));
    CHECK(gap(near, {.radius = r, .repulsion = 0}) == Approx(-0.004));
    CHECK(gap(far, {.radius = r, .attraction = 1}) == Approx(0.004));
    CHECK(gap(far, {.radius = r, .attraction = 0.5, .cling = 0.005}) == Approx(0.002));
    CHECK(gap(far, {.radius = r, .attraction = 0.5, .cling = 0.003}) == Approx(0.004));
}

TEST_CASE("grains: no pair is missed, whatever they look at", "[grains][GR1][GR2][GR3][GR4]") {
    const auto at = cloud(600, 0.13);
    const Heap heap(at, {.radius = r, .averaging = Averaging::none, .searchScale = 1.2});
    const auto by = moved(heap);
    double off = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        Vec<double> expected{0, 0, 0};
        for (std::size_t j = 0; j < at.size(); ++j) {
            const Vec<double> apart = at[i] - at[j];
            const double d = length(apart);
            if (i != j && d < 2 * r) expected += (2 * r - d) / (2 * d) * apart;
        }
        off = std::max(off, length(by[i] - expected));
    }
    CHECK(report("an evaluation against all pairs, m", off, 1e-14));

    // Moved by as much in each of twelve evaluations, by neighbours found once or from far away.
    Grains wide = heap.grains;
    wide.averaging = Averaging::pair;
    Grains narrow = wide, alike = wide, apart = wide;
    wide.searchScale = 4;
    narrow.searchScale = 2;
    const auto one = moved({at, narrow}, 12), other = moved({at, wide}, 12);
    off = 0;
    for (std::size_t i = 0; i < at.size(); ++i) off = std::max(off, length(one[i] - other[i]));
    CHECK(report("neighbours found once against twice as far, m", off, 1e-14));
    alike.radii.assign(at.size(), r);
    CHECK(same(moved({at, alike}, 12), moved({at, apart}, 12)));
    apart.pieces.assign(at.size(), 3);
    CHECK(largest(moved({at, apart})) == 0);
    apart.pieces.assign(at.size(), -1);
    CHECK(same(moved({at, apart}), moved({at, alike})));

    // What clings from afar is far apart in cells as well.
    std::vector<Vec<double>> row;
    for (int i = 0; i < 40; ++i) row.push_back({0.071 * i, 0, 0});
    const auto clung =
        moved({row, {.radius = r, .attraction = 0.1, .cling = 0.06, .searchScale = 1}});
    CHECK(clung.front().x == Approx(0.1 * 0.051 / 2));
    CHECK(clung.back().x == Approx(-0.1 * 0.051 / 2));

    // Of five around it the nearest two.
    const std::vector<Vec<double>> five{{0, 0, 0},      {0.012, 0, 0},  {0, 0.014, 0},
                                        {-0.018, 0, 0}, {0, -0.017, 0}, {0, 0, 0.019}};
    const auto two =
        moved({five, {.radius = r, .averaging = Averaging::none, .mostNeighbours = 2}});
    CHECK(length(two[0] - Vec<double>{-0.004, -0.003, 0}) < 1e-15);
}

TEST_CASE("grains: averages keep many that meet in hand, by the pair with their momentum",
          "[grains][GR8]") {
    const auto at = cloud(400, 0.06);  // some thirty on each
    const auto worst = [&](Averaging averaging, double weight) {
        return largest(moved({at, {.radius = r, .weight = weight, .averaging = averaging}}, 20));
    };
    note("furthest moved with averages, m", worst(Averaging::pair, 1));
    note("without, weight 1, m", worst(Averaging::none, 1));
    CHECK(worst(Averaging::pair, 1) < 0.1);
    CHECK(worst(Averaging::grain, 1) < 0.1);
    CHECK(worst(Averaging::none, 1) > 3 * worst(Averaging::pair, 1));
    const auto drift = [&](Averaging averaging) {
        return length(sum(moved({at, {.radius = r, .averaging = averaging}}, 20))) / 400;
    };
    CHECK(report("way of the centre, by the pair, m", drift(Averaging::pair), 1e-15));
    CHECK(drift(Averaging::grain) > 1e-6);
}

TEST_CASE("grains: what is under counts as heavier by shock", "[grains][GR9][GR10]") {
    const auto lower = [](double shock, double tilt) {
        const Vec<double> along{std::sin(tilt), std::cos(tilt), 0};
        const auto by = moved({{{0, 0, 0}, 0.016 * along}, {.radius = r, .shock = shock}});
        return -dot(by[0], along) / 0.004;
    };
    CHECK(lower(0, 0) == Approx(0.5));
    // x = -0.3 of the lower: k = 0.7405.
    CHECK(lower(0.3, 0) == Approx(0.7405 / 1.7405));
    CHECK(lower(0.3, pi / 2) == Approx(0.5));
    // No more than 1: k = 1 - 1 + 1 / 2 - 1 / 6.
    CHECK(lower(50, 0) == Approx((1 / 3.0) / (4 / 3.0)));
    // A column of ten that has sunk into itself stands up in fewer evaluations.
    const auto sunk = [](double shock) {
        std::vector<Vec<double>> at;
        for (int i = 0; i < 10; ++i) at.push_back({0, 0.018 * i, 0});
        Heap heap(at, {.radius = r, .shock = shock});
        heap.world.pin({0});
        const auto by = moved(heap, 20);
        return 9 * 2 * r - (at[9] + by[9]).y;
    };
    note("a column is too low without shock, m", sunk(0));
    note("with, m", sunk(0.5));
    CHECK(sunk(0.5) < 0.8 * sunk(0));
}

TEST_CASE("grains: friction holds what presses, and lets slide what does not", "[grains]") {
    // The upper one comes down by 4 mm while it goes aside by `slid`.
    const auto after = [](double slid, double friction) {
        Heap heap({{0, 0, 0}, {0, 0.02, 0}},
                  {.radius = r, .staticFriction = 1.5 * friction, .dynamicFriction = friction});
        heap.world.pin({0});
        heap.world.velocity[1] = {slid, -0.004, 0};
        return moved(heap)[1];
    };
    CHECK(std::fabs(after(1e-5, 0.4).x) < 1e-7);
    const double push = 2 * r - std::hypot(0.008, 0.016);
    CHECK(length(after(0.008, 0.4) - after(0.008, 0)) == Approx(0.4 * push));
}

TEMPLATE_TEST_CASE("grains: the same bits with any threads, resumed and again",
                   "[grains][determinism]", float, double) {
    const auto make = [] {
        Heap heap(cloud(500, 0.12), {.radius = r});
        heap.world.act<Gravity>(GravityOptions{});
        heap.push();
        const Collider floor{.solid = Solid::plane(), .frame = {{0, -0.05, 0}}};
        collide(heap.world, {floor}, {{.vertices = heap.grains.vertices, .thickness = r}},
                {.name = "floor", .order = 1});
        return heap.world;
    };
    const auto options = [](int threads) {
        SolverOptions all;
        all.schedule = {.substeps = 10};
        all.threads = threads;
        return all;
    };
    Solver<TestType> one(make(), options(1)), three(make(), options(3)),
        resumed(make(), options(1));
    for (int frame = 0; frame < 6; ++frame) {
        if (frame == 3) resumed.restore(one.state(), one.evaluations());
        one.frame(), three.frame();
        if (frame >= 3) resumed.frame();
    }
    CHECK(one.hash() == three.hash());
    CHECK(one.hash() == resumed.hash());
}

TEST_CASE("grains: what makes no sense is refused", "[grains]") {
    const auto refuses = [](Grains grains, const std::string& why) {
        Heap heap({{0, 0, 0}, {1, 0, 0}}, grains);
        CHECK_THROWS_WITH(heap.push(), Catch::Contains("grains: ") && Catch::Contains(why));
    };
    refuses({.radius = 0}, "radius");
    refuses({.radii = {1}}, "one radius a grain");
    refuses({.staticFriction = -1}, "below 0");
    refuses({.searchScale = 0.5}, "look as far");
    refuses({.mostNeighbours = -1}, "neighbours");
    refuses({.pieces = {1}}, "one piece a grain");
    refuses({.up = {0, 2, 0}}, "unit length");
}
