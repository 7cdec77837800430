#include "basics.h"

#include "collision/kdop.h"
#include "collision/query.h"
#include "forces/gravity.h"
#include "inextensible.h"
#include "measures.h"
#include "stencils.h"
#include "views.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace plait {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Weights = std::array<double, 3>;
using Corners = std::array<Vec<double>, 3>;

Vec<double> blend(const Weights& b, const Corners& q) {
    return b[0] * q[0] + b[1] * q[1] + b[2] * q[2];
}

// Of the point of edge q[i] q[j] that is nearest to p.
Weights nearestOnEdge(const Vec<double>& p, const Corners& q, int i, int j) {
    const Vec<double> e = q[j] - q[i];
    const double t = std::clamp(dot(p - q[i], e) / dot(e, e), 0.0, 1.0);
    Weights b{};
    b[i] = 1 - t;
    b[j] = t;
    return b;
}

// Of the point of a triangle, with area, that is nearest to p.
Weights nearestWeights(const Vec<double>& p, const Corners& q) {
    const Vec<double> n = cross(q[1] - q[0], q[2] - q[0]);
    Weights b;
    for (int i = 0; i < 3; ++i)
        b[i] = dot(cross(q[(i + 2) % 3] - q[(i + 1) % 3], p - q[(i + 1) % 3]), n) / dot(n, n);
    if (*std::min_element(b.begin(), b.end()) >= 0) return b;
    double least = infinity;
    for (int i = 0; i < 3; ++i) {
        const Weights edge = nearestOnEdge(p, q, i, (i + 1) % 3);
        const Vec<double> d = p - blend(edge, q);
        if (dot(d, d) >= least) continue;
        least = dot(d, d);
        b = edge;
    }
    return b;
}

struct Meeting {
    int ball;
    std::vector<int> triangles;  // three vertices each
    double radius;               // m
    bool onTheWay;               // look for it all the way, or only where the substep ends
};

// A ball does not enter a sheet: where they meet in the substep, the way from the nearest point of
// the triangle to the ball is the normal along which they stay apart.
template <class Real>
class Apart : public Constraint<Real> {
public:
    explicit Apart(Meeting meeting)
        : meeting_(std::move(meeting)), touched_(static_cast<std::size_t>(meeting_.ball) + 1) {}

    void begin(const Substep&, Workers&) override { std::ranges::fill(touched_, 0); }
    void project(const Sweep<Real>& sweep, Direction direction, Workers&) override {
        const int last = static_cast<int>(size()) - 1;
        for (int i = 0; i <= last; ++i)
            part(sweep.particles,
                 &meeting_.triangles[3 * (direction == Direction::forward ? i : last - i)]);
    }
    void markTouched(std::vector<std::uint8_t>& touched) const override {
        for (std::size_t i = 0; i < touched_.size(); ++i) touched[i] |= touched_[i];
    }
    long size() const override { return static_cast<long>(meeting_.triangles.size() / 3); }

private:
    MovingVertex path(const Real* particle) const {
        const Vec<double> start{particle[0], particle[1], particle[2]};
        const Vec<double> end = start + Vec<double>{particle[4], particle[5], particle[6]};
        return {meeting_.onTheWay ? start : end, end};
    }

    bool mayMeet(const MovingVertex& p, const std::array<MovingVertex, 3>& q) const {
        const std::array start{p.start, q[0].start, q[1].start, q[2].start};
        const std::array end{p.end, q[0].end, q[1].end, q[2].end};
        const Travel travel{.start = start, .end = end, .radius = 0.5 * meeting_.radius};
        constexpr int ball[]{0}, triangle[]{1, 2, 3};
        return sweptBounds<6>(ball, travel).overlaps(sweptBounds<6>(triangle, travel));
    }

    void part(Real* particles, const int* ids) {
        Real* const ball = particles + 8 * meeting_.ball;
        const std::array corners{particles + 8 * ids[0], particles + 8 * ids[1],
                                 particles + 8 * ids[2]};
        const MovingVertex p = path(ball);
        const std::array q{path(corners[0]), path(corners[1]), path(corners[2])};
        if (!mayMeet(p, q)) return;  // nearly all: the query is dearer
        const Impact t = thickPointTriangle(p, q[0], q[1], q[2], meeting_.radius);
        if (!t) return;
        const Corners then{at(q[0], *t), at(q[1], *t), at(q[2], *t)};
        const Weights b = nearestWeights(at(p, *t), then);
        const Vec<double> way = at(p, *t) - blend(b, then), n = (1 / length(way)) * way;
        const double c = dot(n, p.end - blend(b, {q[0].end, q[1].end, q[2].end})) - meeting_.radius;
        if (!(c < 0)) return;
        double w = ball[3];
        for (int i = 0; i < 3; ++i) w += b[i] * b[i] * corners[i][3];
        const double lambda = -c / w;
        for (const int v : {meeting_.ball, ids[0], ids[1], ids[2]}) touched_[v] = 1;
        move(ball, lambda * n);
        for (int i = 0; i < 3; ++i) move(corners[i], -b[i] * lambda * n);
    }

    static void move(Real* particle, const Vec<double>& impulse) {
        particle[4] += static_cast<Real>(particle[3] * impulse.x);
        particle[5] += static_cast<Real>(particle[3] * impulse.y);
        particle[6] += static_cast<Real>(particle[3] * impulse.z);
    }

    Meeting meeting_;
    std::vector<std::uint8_t> touched_;  // up to the ball, which comes after the sheet
};

// In m: from the middle of the ball to the sheet; below 0 where it is behind.
Metric clearance(const Meeting& meeting) {
    const auto measure = [=](const Snapshot& at) {
        const Vec<double> p = at.positions[static_cast<std::size_t>(meeting.ball)];
        double least = infinity;
        bool behind = false;
        for (std::size_t i = 0; i < meeting.triangles.size(); i += 3) {
            const int* const ids = &meeting.triangles[i];
            const Corners q{at.positions[ids[0]], at.positions[ids[1]], at.positions[ids[2]]};
            const Weights b = nearestWeights(p, q);
            const Vec<double> d = p - blend(b, q);
            if (length(d) >= least) continue;
            least = length(d);
            // Past the sheet's edge it may lie on either side.
            behind = *std::min_element(b.begin(), b.end()) > 0 &&
                     dot(d, cross(q[1] - q[0], q[2] - q[0])) < 0;
        }
        return behind ? -least : least;
    };
    return {.name = "clearance",
            .unit = "m",
            .measure = measure,
            .low = meeting.onTheWay ? 0.9 * meeting.radius : -infinity,
            .high = infinity,
            .caption = true};
}

}  // namespace

// A ball of 2.7 g, as in table tennis, flies 5 cm a substep against a curtain (S figure 14).
Scene bullet(const Knobs& knobs) {
    Scene scene;
    World& world = scene.world;
    constexpr int n = 33;
    constexpr double side = 0.8, radius = 0.02;
    const Range sheet = world.add(
        grid({.columns = n, .rows = n, .width = side, .height = side}, {.origin = {0, -side, 0}}),
        {.density = 0.2});
    const Range ball =
        world.add({SimplicialComplex(1), {{0.47 * side, -0.53 * side, knobs.number("distance")}}},
                  {.density = 0.0027, .velocity = {{0, 0, -knobs.number("speed")}}});
    const std::vector<int> pins = pointStencils({n * (n - 1), n * n});
    world.pin(pins);
    world.act<Gravity>(GravityOptions{});
    holdSheet(world, sheet, {.strands = false, .aggregates = true});
    const Meeting meeting{ball.first, triangleStencils(world.complex, sheet), radius,
                          knobs.text("detection") == "path"};
    const auto make = [meeting]<class Real>(const World&, KernelChoice) {
        return std::make_unique<Apart<Real>>(meeting);
    };
    world.constrain(recipeOf<Constraint>(make), {.name = "apart", .order = 3}, true);
    constexpr double floor = -1.05;
    Rows<PlaneContact> ground = restRows<PlaneContact>(pointStencils(ball), world.rest);
    ground.rows[0] = {{0, floor, 0}, {0, 1, 0}, radius};
    world.constrain(ground, {.name = "ground", .order = 4});
    scene.options.schedule = {.substeps = 8, .iterations = 20, .collisionPasses = 20};
    scene.seconds = 1;
    scene.metrics = {clearance(meeting), greatestStrain(world, sheet, {0, 10})};
    View& view = scene.view;
    view = viewOf({sheet, ball}, {0.5 * side, -0.55 * side, 0}, 1.4, Material::cotton,
                  {1.6, 0.35, 1.6});
    view.looks[1] = lookOf(ball, Material::brass, radius);
    view.groundHeight = floor;
    addBar(view, {-0.1, 0.01, 0}, {side + 0.1, 0.01, 0}, 0.012, Material::steel);
    for (const double x : {-0.1, side + 0.1})
        addBar(view, {x, view.groundHeight, 0}, {x, 0.03, 0}, 0.015, Material::matte);
    return scene;
}

}  // namespace plait
