#include "rod.h"

#include "chain_set.h"
#include "frame_rows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

// Second moments of the section: about the director, across it, and of torsion; m^4.
struct Moments {
    double director, side, torsion;
};

Moments momentsOf(const Wire& wire) {
    const double u = wire.along, v = wire.across;
    if (v == 0) {
        const double moment = pi * u * u * u * u / 64;
        return {moment, moment, 2 * moment};
    }
    const double a = std::max(u, v), b = std::min(u, v), thin = b / a;
    const double torsion =
        a * b * b * b * (1.0 / 3 - 0.21 * thin * (1 - thin * thin * thin * thin / 12));
    return {u * v * v * v / 12, v * u * u * u / 12, torsion};
}

}  // namespace

double Wire::area() const { return across == 0 ? pi * along * along / 4 : along * across; }
double Wire::bending() const { return youngs * momentsOf(*this).director; }
double Wire::bendingSide() const { return youngs * momentsOf(*this).side; }
double Wire::twisting() const { return youngs / (2 * (1 + poisson)) * momentsOf(*this).torsion; }
double Wire::gyration() const {
    const Moments moments = momentsOf(*this);
    return squareRoot((moments.director + moments.side) / area());
}

namespace {

class RodMaker {
public:
    RodMaker(const Shape& curve, const RodOptions& options, const std::string& name)
        : curve_(curve), options_(options), name_(name) {
        checkWire();
        checkCurve();
    }

    Rod addTo(World& world) {
        Rod rod;
        rod.points = world.add(curve_, {.density = options_.wire.density * options_.wire.area()});
        rod.directors = world.add({SimplicialComplex(edges_), directors()});
        for (int e = 0; e < edges_; ++e) {
            const double mass = directorMass(e);
            world.mass[rod.directors.first + e] = mass;
            for (const int v : {e, next(e)}) world.mass[rod.points.first + v] -= mass / 2;
        }
        return rod;
    }

    Chains chains(const World& world, const Rod& rod) const {
        const int x = rod.points.first, d = rod.directors.first;
        std::vector<int> order, links, held;
        for (int v = 0; v < std::ssize(curve_.positions); ++v) {
            order.push_back(x + v);
            if (v < edges_) order.push_back(d + v);
        }
        Rows<FrameTurn> turns;
        for (int e = 0; e < edges_; ++e) {
            links.insert(links.end(), {x + e, x + next(e)});
            held.insert(held.end(), {x + e, x + next(e), d + e});
            const int f = next(e);  // the vertex and the edge behind this one
            if (f == edges_) continue;
            turns.ids.insert(turns.ids.end(), {x + e, x + f, x + next(f), d + e, d + f});
            turns.rows.push_back(turnOf(world, &turns.ids[turns.ids.size() - 5]));
        }
        Chains all;
        all.addCurve(order);
        for (int e = 0; e < edges_; ++e) all.ride({d + e, {x + e, x + next(e)}});
        all.add(restRows<Stretch>(links, world.rest));
        all.add(restRows<DirectorAcross>(held, world.rest));
        all.add(restRows<DirectorLength>(held, world.rest));
        all.add(turns);
        return all;
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw std::invalid_argument(name_ + ": " + what);
    }

    void checkWire() const {
        const Wire& wire = options_.wire;
        const auto positive = [&](double value, const char* what) {
            if (!(value > 0) || !std::isfinite(value))
                refuse(std::string(what) + " must be positive, not " + std::to_string(value));
        };
        positive(wire.youngs, "Young's modulus");
        positive(wire.density, "density");
        positive(wire.along, "the section along the director");
        if (wire.across != 0) positive(wire.across, "the section across the director");
        if (options_.arm != 0) positive(options_.arm, "the arm");
        if (!(wire.poisson > -1 && wire.poisson <= 0.5))
            refuse("Poisson's ratio is above -1 and at most 0.5, not " +
                   std::to_string(wire.poisson));
    }

    void checkCurve() {
        const int vertices = static_cast<int>(curve_.positions.size());
        edges_ = curve_.complex.count(1);
        if (edges_ < 2 || edges_ > vertices || edges_ + 1 < vertices)
            refuse("a curve has an edge between each vertex and the next");
        double sum = 0;
        for (int e = 0; e < edges_; ++e) {
            const auto ends = curve_.complex.vertices(1, e);
            if (std::min(ends[0], ends[1]) != std::min(e, next(e)) ||
                std::max(ends[0], ends[1]) != std::max(e, next(e)))
                refuse("edge " + std::to_string(e) + " does not join a vertex to the next");
            if (!(length(edge(e)) > 0)) refuse("edge " + std::to_string(e) + " has no length");
            sum += length(edge(e));
        }
        arm_ = options_.arm > 0 ? options_.arm
                                : std::max(sum / edges_ / 2, 2 * options_.wire.gyration());
        if (!(arm_ > options_.wire.gyration()))
            refuse("an arm of " + std::to_string(arm_) +
                   " m is too short for the inertia of the wire: above " +
                   std::to_string(options_.wire.gyration()) + " m");
        const std::size_t given = options_.toward.size();
        if (given > 1 && given != static_cast<std::size_t>(edges_))
            refuse("one direction an edge, or one for all");
    }

    int next(int vertex) const {
        return vertex + 1 == static_cast<int>(curve_.positions.size()) ? 0 : vertex + 1;
    }
    Vec<double> edge(int e) const { return curve_.positions[next(e)] - curve_.positions[e]; }

    double directorMass(int e) const {
        const double part = options_.wire.gyration() / arm_;
        return options_.wire.density * options_.wire.area() * length(edge(e)) * part * part;
    }

    std::vector<Vec<double>> directors() const {
        std::vector<Vec<double>> at;
        Vec<double> last = anyAcross(edge(0));
        for (int e = 0; e < edges_; ++e) {
            const auto& given = options_.toward;
            const Vec<double> toward =
                given.empty() ? last : given[given.size() == 1 ? 0 : static_cast<std::size_t>(e)];
            const Vec<double> t = (1 / length(edge(e))) * edge(e);
            const Vec<double> across = toward - dot(toward, t) * t;
            if (!(length(across) > 1e-9 * length(toward)))
                refuse("the director of edge " + std::to_string(e) + " points along it");
            last = (1 / length(across)) * across;
            at.push_back(0.5 * (curve_.positions[e] + curve_.positions[next(e)]) + arm_ * last);
        }
        return at;
    }

    static Vec<double> anyAcross(const Vec<double>& t) {
        const bool alongX = std::fabs(t.x) > std::fabs(t.y);
        return cross(t, alongX ? Vec<double>{0, 1, 0} : Vec<double>{1, 0, 0});
    }

    // A joint's length is half of each of its edges.
    FrameTurn::Row<double> turnOf(const World& world, const int* ids) const {
        Stencil<Vec<double>, 5> x;
        for (int a = 0; a < 5; ++a) x[a] = world.rest[ids[a]];
        auto row = FrameTurn::rest(x);
        const double l = (length(x[1] - x[0]) + length(x[2] - x[1])) / 2;
        const Wire& wire = options_.wire;
        row.compliance = {l / wire.bending(), l / wire.bendingSide(), l / wire.twisting()};
        return row;
    }

    const Shape& curve_;
    const RodOptions& options_;
    std::string name_;
    int edges_ = 0;
    double arm_ = 0;
};

}  // namespace

Rod addRod(World& world, const Shape& curve, const RodOptions& options, SetOptions set) {
    RodMaker maker(curve, options, set.name);
    const Rod rod = maker.addTo(world);
    maker.chains(world, rod).constrain(world, std::move(set));
    return rod;
}

}  // namespace plait
