// Every kind of constraints/kinds.h goes through everything here, without a line of its own.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/constraints/constants.h>
#include <plait/sets/constraint_set.h>

#include <array>
#include <cmath>
#include <cstring>
#include <tuple>
#include <vector>

using namespace plait;
using plait::test::note;
using plait::test::Random;
using plait::test::report;

namespace {

template <class... Kind>
std::tuple<Kind...> asTuple(KindList<Kind...>);
using AllKinds = decltype(asTuple(Kinds{}));

template <class Kind>
using Points = Stencil<Vec<double>, Kind::arity>;

// Those that act between vertices, not on the world; and those with a compliance.
template <class... Kind>
auto onlyFree(KindList<Kind...>) {
    return std::tuple_cat(std::conditional_t<!anchored<Kind>, std::tuple<Kind>, std::tuple<>>{}...);
}
template <class Kind>
constexpr bool complies = requires(typename Kind::template Row<double> row) { row.compliance; };
template <class... Kind>
auto onlyCompliant(KindList<Kind...>) {
    return std::tuple_cat(std::conditional_t<complies<Kind>, std::tuple<Kind>, std::tuple<>>{}...);
}
using FreeKinds = decltype(onlyFree(Kinds{}));
using CompliantKinds = decltype(onlyCompliant(Kinds{}));

// Random stencils without slivers: as rest shapes their gradients stay below 8 / m.
template <class Kind>
Points<Kind> randomPoints(Random& random) {
    for (;;) {
        Points<Kind> x, g;
        for (auto& p : x) p = random.point(1);
        Points<Kind> local = x;
        for (auto& p : local) p = p - x[0];
        Kind::evaluate(Kind::rest(x), local, g);
        double largest = 0;
        for (const auto& v : g) largest = std::max(largest, length(v));
        if (Kind::arity == 1 || largest < 8) return x;
    }
}

// C and its gradient at absolute positions, as the kernels see them.
template <class Kind>
double evaluateAt(const typename Kind::template Row<double>& row, const Points<Kind>& x,
                  Points<Kind>& g) {
    Points<Kind> local;
    Vec<double> origin = x[0];
    if constexpr (anchored<Kind>) origin = Kind::origin(row);
    for (int a = 0; a < Kind::arity; ++a) local[a] = x[a] - origin;
    return Kind::evaluate(row, local, g);
}

// A set of constraints on vertices of their own, and what a sweep needs.
template <class Kind, class Real>
struct Sample {
    Rows<Kind> rows;
    std::vector<Particle<Real>> particles;
    std::vector<Padded<Real>> out;

    explicit Sample(Random& random, int count, double compliance = 0) {
        for (int i = 0; i < count; ++i) {
            const auto rest = randomPoints<Kind>(random);
            auto row = Kind::rest(rest);
            if constexpr (requires { row.compliance; }) row.compliance = compliance;
            if constexpr (requires { row.compression; }) row.compression = compliance;
            rows.rows.push_back(row);
            for (int a = 0; a < Kind::arity; ++a) {
                rows.ids.push_back(static_cast<int>(particles.size()));
                add(rest[a] + random.point(0.2), random.uniform(0.5, 2), random);
            }
        }
        add({0, 0, 0}, 0, random);
    }

    void add(const Vec<double>& x, double w, Random& random) {
        const Vec<Real> d{Real(random.uniform(-.01, .01)), Real(random.uniform(-.01, .01)),
                          Real(.003)};
        particles.push_back(
            {{Real(x.x), Real(x.y), Real(x.z)}, Real(w), w > 0 ? d : Vec<Real>{}, 0});
        out.push_back({w > 0 ? Real(3) * d : Vec<Real>{}, 0});
    }

    int padding() const { return static_cast<int>(particles.size()) - 1; }

    Vec<double> position(int i) const {
        const auto& p = particles[static_cast<std::size_t>(i)];
        return {double(p.x.x) + double(p.d.x), double(p.x.y) + double(p.d.y),
                double(p.x.z) + double(p.d.z)};
    }
    Points<Kind> points(int constraint) const {
        Points<Kind> x;
        for (int a = 0; a < Kind::arity; ++a)
            x[a] = position(rows.ids[static_cast<std::size_t>(constraint * Kind::arity + a)]);
        return x;
    }

    Sweep<Real> sweep(double h = 1) {
        return {&particles[0].x.x, &out[0].v.x, Real(1 / (h * h)), 1, 1};
    }
    ConstraintSet<Kind, Real> set(KernelChoice choice = bestKernels()) const {
        return ConstraintSet<Kind, Real>(rows, padding(), choice);
    }
};

// Sums over the corrections of all vertices: of m d (over sum |m d|), of x cross m d likewise.
template <class Kind, class Real>
std::pair<double, double> momentumErrors(const Sample<Kind, Real>& before,
                                         const Sample<Kind, Real>& after) {
    Vec<double> linear{}, angular{};
    double linearSize = 0, angularSize = 0;
    for (int i = 0; i < before.padding(); ++i) {
        const double m = 1 / double(before.particles[static_cast<std::size_t>(i)].w);
        const Vec<double> x = before.position(i), p = m * (after.position(i) - x);
        linear += p;
        angular += cross(x, p);
        linearSize += length(p);
        angularSize += length(x) * length(p);
    }
    return {divide(length(linear), linearSize), divide(length(angular), angularSize)};
}

template <class Real>
bool finite(const std::vector<Particle<Real>>& particles) {
    for (const auto& p : particles)
        if (!std::isfinite(p.d.x) || !std::isfinite(p.d.y) || !std::isfinite(p.d.z)) return false;
    return true;
}

std::vector<KernelChoice> everyChoice() {
    std::vector<KernelChoice> choices;
    for (const Isa isa : {Isa::v2, Isa::v3, Isa::v4})
        for (const int lanes : {1, 4, 8, 16})
            if (available({isa, lanes})) choices.push_back({isa, lanes});
    return choices;
}

template <class Kind>
std::string nameOf() {
    const char* names[] = {"stretch", "angle", "shear",  "bend",    "attach",
                           "tether",  "plane", "sphere", "capsule", "volume"};
    return names[kindIndex<Kind>(Kinds{})];
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("kinds: the gradient is that of finite differences", "[kinds][IN11]",
                        AllKinds) {
    Random random(1);
    double worst = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const auto rest = randomPoints<TestType>(random);
        const auto row = TestType::rest(rest);
        Points<TestType> x = rest, g, unused;
        for (auto& p : x) p += random.point(0.3);
        evaluateAt<TestType>(row, x, g);
        for (int a = 0; a < TestType::arity; ++a)
            for (double Vec<double>::* axis : {&Vec<double>::x, &Vec<double>::y, &Vec<double>::z}) {
                constexpr double e = 1e-5;
                const auto at = [&](double shift) {
                    Points<TestType> y = x;
                    y[a].*axis += shift;
                    return evaluateAt<TestType>(row, y, unused);
                };
                // Fourth order; a fold passing through pi wraps by 2 pi and is left out.
                const double c[] = {at(-2 * e), at(-e), at(e), at(2 * e)};
                if (std::fabs(c[3] - c[0]) > 1) continue;
                const double slope = (c[0] - 8 * c[1] + 8 * c[2] - c[3]) / (12 * e);
                worst = std::max(worst, std::fabs(slope - g[a].*axis) / (1 + std::fabs(slope)));
            }
    }
    REQUIRE(report("gradient of " + nameOf<TestType>(), worst, 1e-7));
}

TEMPLATE_LIST_TEST_CASE("kinds: the gradient is that of automatic differentiation", "[kinds][IN11]",
                        AllKinds) {
    using D = Dual<double>;
    Random random(21);
    double worst = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const auto rest = randomPoints<TestType>(random);
        const auto row = TestType::rest(rest);
        Points<TestType> x = rest, g;
        for (auto& p : x) p += random.point(0.3);
        evaluateAt<TestType>(row, x, g);
        const auto dualRow = eachAs<typename TestType::template Row<D>,
                                    typename TestType::template Row<double>, D, double>(row);
        Vec<double> origin = x[0];
        if constexpr (anchored<TestType>) origin = TestType::origin(row);
        for (int a = 0; a < TestType::arity; ++a) {
            // The first vertex is where the others are measured from.
            if (a == 0 && !anchored<TestType>) continue;
            for (int axis = 0; axis < 3; ++axis) {
                Stencil<Vec<D>, TestType::arity> local, unused;
                for (int b = 0; b < TestType::arity; ++b) {
                    const Vec<double> p = x[b] - origin;
                    local[b] = {D(p.x, a == b && axis == 0), D(p.y, a == b && axis == 1),
                                D(p.z, a == b && axis == 2)};
                }
                const double slope = TestType::evaluate(dualRow, local, unused).slope;
                const double ours = axis == 0 ? g[a].x : axis == 1 ? g[a].y : g[a].z;
                worst = std::max(worst, std::fabs(slope - ours) / (1 + std::fabs(slope)));
            }
        }
    }
    REQUIRE(report("gradient of " + nameOf<TestType>() + ", differentiated", worst, 1e-10));
}

TEMPLATE_LIST_TEST_CASE("kinds: translation and rotation leave C alone", "[kinds][IN11]",
                        FreeKinds) {
    Random random(2);
    double worst = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const auto row = TestType::rest(randomPoints<TestType>(random));
        const auto x = randomPoints<TestType>(random);
        Points<TestType> g;
        evaluateAt<TestType>(row, x, g);
        Vec<double> force{}, torque{};
        double size = 0;
        for (int a = 0; a < TestType::arity; ++a) {
            force += g[a];
            torque += cross(x[a], g[a]);
            size += length(g[a]);
        }
        worst = std::max({worst, length(force) / size, length(torque) / size});
    }
    REQUIRE(report("force and torque of " + nameOf<TestType>(), worst, 1e-13));
}

TEMPLATE_LIST_TEST_CASE("kinds: the rest shape stays", "[kinds]", AllKinds) {
    Random random(3);
    double worst = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const auto rest = randomPoints<TestType>(random);
        Points<TestType> g;
        worst = std::max(worst, std::fabs(evaluateAt<TestType>(TestType::rest(rest), rest, g)));
    }
    REQUIRE(report("C of " + nameOf<TestType>() + " at rest", worst, 1e-14));
}

namespace {

template <class Kind, class Real>
void checkMomentum(double bound) {
    Random random(4);
    Sample<Kind, Real> sample(random, 40);
    const Sample<Kind, Real> before = sample;
    auto set = sample.set();
    Workers workers(1);
    set.begin({1, 1}, workers);
    for (int i = 0; i < 100; ++i) {
        const auto sweep = sample.sweep();
        set.project(sweep, i % 2 ? Direction::backward : Direction::forward, workers);
        // Damping and smoothing move momentum about in the same way.
        if (i == 0) set.damp(sweep, workers);
    }
    const auto [linear, angular] = momentumErrors(before, sample);
    const std::string name = nameOf<Kind>() + (sizeof(Real) == 4 ? ", float" : ", double");
    REQUIRE(report("momentum through 100 projections of " + name, linear, bound));
    // Turning: gradients are taken at the positions of each projection, so only a single one keeps
    // x cross m d exactly; over many it is kept at the positions in between.
    Sample<Kind, Real> once = before;
    auto single = once.set();
    single.begin({1, 1}, workers);
    single.project(once.sweep(), Direction::forward, workers);
    REQUIRE(report("angular momentum through a projection of " + name,
                   momentumErrors(before, once).second, bound));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("kinds: projections keep momentum", "[kinds][IN7]", FreeKinds) {
    checkMomentum<TestType, double>(1e-12);
    checkMomentum<TestType, float>(1e-6);
}

TEMPLATE_LIST_TEST_CASE("kinds: repeated projection ends at C = 0 or on its free side",
                        "[kinds][IN7][DC2][DC3]", AllKinds) {
    Random random(5);
    Sample<TestType, double> sample(random, 50, 0);
    auto set = sample.set();
    Workers workers(1);
    set.begin({1, 1}, workers);
    for (int i = 0; i < 60; ++i) set.project(sample.sweep(), Direction::forward, workers);
    double worst = 0;
    for (int i = 0; i < sample.rows.size(); ++i) {
        Points<TestType> g;
        const auto& row = sample.rows.rows[static_cast<std::size_t>(i)];
        const double c = evaluateAt<TestType>(row, sample.points(i), g);
        const bool free = TestType::compliance(row, c) >= slack;
        worst = std::max(worst, free ? 0 : std::fabs(c));
    }
    REQUIRE(report("C of " + nameOf<TestType>() + " after 60 projections", worst, 1e-9));
}

// XPBD's fixed point is C = -a lambda, a = compliance / h^2, with the positions moved by W J^T
// lambda.
TEMPLATE_LIST_TEST_CASE("kinds: compliance holds whatever the number of evaluations", "[kinds]",
                        CompliantKinds) {
    Random random(6);
    constexpr double compliance = 0.05, h = 0.5;
    for (const int evaluations : {50, 500}) {
        Sample<TestType, double> sample(random, 20, compliance);
        auto set = sample.set();
        Workers workers(1);
        set.begin({h, 1}, workers);
        for (int i = 0; i < evaluations; ++i)
            set.project(sample.sweep(h), Direction::forward, workers);
        double worst = 0;
        for (int i = 0; i < sample.rows.size(); ++i) {
            Points<TestType> g;
            const auto& row = sample.rows.rows[static_cast<std::size_t>(i)];
            const double c = evaluateAt<TestType>(row, sample.points(i), g);
            worst = std::max(worst, std::fabs(c + compliance / (h * h) * set.multiplier(i)));
        }
        REQUIRE(report("residual of " + nameOf<TestType>() + ", " + std::to_string(evaluations) +
                           " evaluations",
                       worst, 1e-9));
    }
}

namespace {

template <class Kind>
std::vector<float> bitsOf(KernelChoice choice) {
    Random random(7);
    Sample<Kind, float> sample(random, 37, 1e-3);  // not a multiple of any width
    for (int i = 0; i < 9; ++i) {  // and some where the stencil has no extent, or no freedom
        auto& p = sample.particles;
        const auto v = [&](int a) { return static_cast<std::size_t>(i * Kind::arity + a); };
        if (i < 3)
            for (int a = 1; a < Kind::arity; ++a) p[v(a)] = p[v(0)];
        if (i >= 3 && i < 6)
            for (int a = 0; a < Kind::arity; ++a) p[v(a)].w = 0;
        if (i >= 6)
            for (int a = 0; a < Kind::arity; ++a) p[v(a)].x.y = p[v(a)].x.z = 0;
    }
    auto set = sample.set(choice);
    std::vector<int> counts(sample.particles.size(), 3);
    set.relaxBy(counts);
    Workers workers(1);
    set.begin({0.1, 1}, workers);
    auto sweep = sample.sweep(0.1);
    sweep.strength = 0.75F;
    for (int i = 0; i < 3; ++i)
        set.project(sweep, i % 2 ? Direction::backward : Direction::forward, workers);
    set.damp(sweep, workers);
    set.smooth(sweep, workers);
    std::vector<float> bits;
    for (const auto& p : sample.particles) bits.insert(bits.end(), {p.d.x, p.d.y, p.d.z});
    for (const auto& p : sample.out) bits.insert(bits.end(), {p.v.x, p.v.y, p.v.z});
    for (int i = 0; i < sample.rows.size(); ++i) bits.push_back(set.multiplier(i));
    return bits;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("kinds: every lane width and instruction set gives the same bits",
                        "[kinds][determinism]", AllKinds) {
    const std::vector<float> scalar = bitsOf<TestType>({Isa::v2, 1});
    for (const float f : scalar) REQUIRE(std::isfinite(f));
    for (const KernelChoice choice : everyChoice()) {
        const std::vector<float> wide = bitsOf<TestType>(choice);
        INFO(nameOf<TestType>() << " v" << static_cast<int>(choice.isa) + 2 << " x"
                                << choice.lanes);
        REQUIRE(std::memcmp(scalar.data(), wide.data(), scalar.size() * sizeof(float)) == 0);
    }
}

// Coincident, collinear, coplanar, folded, tiny, huge and pinned, in all mixtures.
TEMPLATE_LIST_TEST_CASE("kinds: degenerate input stays finite", "[kinds][DC6]", AllKinds) {
    const auto check = []<class Real>(Real) {
        Random random(8);
        for (const double size : {0.0, 1e-18, 1e-6, 1.0, 1e6}) {
            for (int flat = 0; flat < 4; ++flat) {
                Sample<TestType, Real> sample(random, 16);
                for (auto& p : sample.particles) {
                    const int corner = random.below(3);
                    p.x = {Real(size * (corner == 1)), Real(flat > 1 ? size * (corner == 2) : 0),
                           Real(flat > 2 ? size * random.uniform(-1, 1) : 0)};
                    p.d = {};
                    if (p.w > 0 && random.below(4) == 0) p.w = 0;
                }
                auto set = sample.set();
                Workers workers(1);
                set.begin({1e-4, 1}, workers);
                for (int i = 0; i < 4; ++i)
                    set.project(sample.sweep(1e-4), Direction::forward, workers);
                set.damp(sample.sweep(1e-4), workers);
                INFO(nameOf<TestType>() << " size " << size << " flat " << flat);
                REQUIRE(finite(sample.particles));
            }
        }
    };
    check(0.0F);
    check(0.0);
}

TEST_CASE("kinds: bend is finite and signed from flat to fully folded", "[kinds][DC6]") {
    const auto angleAt = [](double fold) {  // second triangle turned about the edge by `fold`
        const Points<Bend> x{
            {{0, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}, {std::cos(fold), 0.5, std::sin(fold)}}};
        Points<Bend> g;
        const double c = evaluateAt<Bend>({0, 0}, x, g);
        for (const auto& v : g) REQUIRE(std::isfinite(length(v)));
        return c;
    };
    double worst = 0;
    const double sign = angleAt(0.5) > 0 ? 1 : -1;
    for (int i = -100; i <= 100; ++i) {
        const double fold = i * 0.0314159;
        worst = std::max(worst, std::fabs(sign * angleAt(fold) - fold));
    }
    REQUIRE(report("dihedral angle over both folds", worst, 1e-14));
    REQUIRE(std::fabs(angleAt(pi)) == Approx(pi));
    REQUIRE(angleAt(0) == 0);
}

TEST_CASE("kinds: a link buckles where compression is slack and holds where it is not", "[kinds]") {
    for (const double compression : {slack, 0.0}) {
        Rows<Stretch> rows{
            {0, 1}, {{.rest = 1, .compliance = 0, .compression = compression}}, {}, {}};
        ConstraintSet<Stretch, double> set(rows, 2, bestKernels());
        std::vector<Particle<double>> p{{{0, 0, 0}, 1, {}, 0}, {{0.5, 0, 0}, 1, {}, 0}, {}};
        Workers workers(1);
        set.begin({1, 1}, workers);
        set.project({&p[0].x.x, nullptr, 1, 1, 1}, Direction::forward, workers);
        REQUIRE(p[1].d.x - p[0].d.x == (compression > 0 ? 0 : 0.5));
    }
}

TEST_CASE("kinds: contacts push and never pull", "[kinds][CC1]") {
    Rows<PlaneContact> rows = restRows<PlaneContact>({0, 1}, std::vector<Vec<double>>(2));
    ConstraintSet<PlaneContact, double> set(rows, 2, bestKernels());
    std::vector<Particle<double>> p{
        {{0, 0, 0}, 1, {0, -0.5, 0}, 0}, {{0, 0, 0}, 1, {0, 0.5, 0}, 0}, {}};
    Workers workers(1);
    set.begin({1, 1}, workers);
    set.project({&p[0].x.x, nullptr, 1, 1, 1}, Direction::forward, workers);
    REQUIRE(p[0].d.y == Approx(0).margin(1e-15));
    REQUIRE(p[1].d.y == 0.5);
    std::vector<std::uint8_t> touched(3, 0);
    set.markTouched(touched);
    REQUIRE(touched == std::vector<std::uint8_t>{1, 0, 0});
    // What a contact gave within the substep, and no more, it takes back when others lift the
    // point.
    p[0].d.y += 0.1;
    set.project({&p[0].x.x, nullptr, 1, 1, 1}, Direction::forward, workers);
    REQUIRE(p[0].d.y == Approx(0).margin(1e-15));
    p[0].d.y += 1;
    set.project({&p[0].x.x, nullptr, 1, 1, 1}, Direction::forward, workers);
    REQUIRE(p[0].d.y == Approx(0.6));
    REQUIRE(set.multiplier(0) == Approx(0).margin(1e-15));
}
