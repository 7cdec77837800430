#include "rod.h"

#include "../numbers/elementary.h"
#include "chain_set.h"
#include "rod_rows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

class RodMaker {
public:
    RodMaker(const Shape& curve, const RodOptions& options, const std::string& name)
        : curve_(curve), options_(options), name_(name) {
        checkOptions();
        checkCurve();
        if (framed()) arm_ = armOf();
    }

    Range addPoints(World& world) const {
        return world.add(curve_, {.density = options_.wire.density * options_.wire.area()});
    }

    Range addDirectors(World& world, const Range& points) const {
        if (!framed()) return {};
        const Range all = world.add({SimplicialComplex(edges_), directors()});
        for (int e = 0; e < edges_; ++e) {
            const double mass = directorMass(e);
            world.mass[all.first + e] = mass;
            for (const int v : {e, next(e)}) world.mass[points.first + v] -= mass / 2;
        }
        return all;
    }

    void hold(const World& world, const Rod& rod, Chains& chains, RodRows& all) const {
        all.add(restRows<Stretch>(stencils(rod, edges_, 2), world.rest));
        for (int e = 0; e < edges_; ++e) {
            const int a = rod.points.first + e, b = rod.points.first + next(e);
            chains.keep({{a, b}, length(world.rest[b] - world.rest[a]), options_.strain});
        }
        std::vector<int> order;
        for (int v = 0; v < vertices_; ++v) {
            order.push_back(rod.points.first + v);
            if (framed() && v < edges_) order.push_back(rod.directors.first + v);
        }
        chains.addCurve(order);
        switch (options_.model) {
            case RodModel::framed:
                holdFrames(chains, all, world, rod);
                break;
            case RodModel::curved:
                holdCurve(all, world, rod);
                break;
            case RodModel::straight:
                holdStraight(all, rod);
                break;
        }
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw std::invalid_argument(name_ + ": " + what);
    }

    bool framed() const { return options_.model == RodModel::framed; }

    void checkOptions() const {
        const Wire& wire = options_.wire;
        const auto positive = [&](double value, const char* what) {
            if (!(value > 0) || !std::isfinite(value))
                refuse(std::string(what) + " must be positive, not " + std::to_string(value));
        };
        positive(wire.youngs, "Young's modulus");
        positive(wire.density, "density");
        positive(options_.strain, "the strain that contacts may leave");
        positive(wire.along, "the section along the director");
        if (wire.across != 0) positive(wire.across, "the section across the director");
        if (options_.arm != 0) positive(options_.arm, "the arm");
        if (!(wire.poisson > -1 && wire.poisson <= 0.5))
            refuse("Poisson's ratio is above -1 and at most 0.5, not " +
                   std::to_string(wire.poisson));
        if (!framed() && (options_.arm != 0 || !options_.toward.empty()))
            refuse("a rod of points only has no directors");
        if (options_.model != RodModel::straight) return;
        if (!options_.natural.empty()) refuse("a straight rod has no natural curvature");
        if (wire.across != 0 && wire.across != wire.along)
            refuse("a straight rod is of round wire");
    }

    void checkCurve() {
        vertices_ = static_cast<int>(curve_.positions.size());
        edges_ = curve_.complex.count(1);
        if (edges_ < 2 || edges_ > vertices_ || edges_ + 1 < vertices_)
            refuse("a curve has an edge between each vertex and the next");
        joints_ = edges_ == vertices_ ? edges_ : edges_ - 1;
        for (int e = 0; e < edges_; ++e) {
            const auto ends = curve_.complex.vertices(1, e);
            if (std::min(ends[0], ends[1]) != std::min(e, next(e)) ||
                std::max(ends[0], ends[1]) != std::max(e, next(e)))
                refuse("edge " + std::to_string(e) + " does not join a vertex to the next");
            if (!(length(edge(e)) > 0)) refuse("edge " + std::to_string(e) + " has no length");
        }
        checkCount(options_.natural.size(), joints_, "one natural curvature a joint");
        checkCount(options_.toward.size(), edges_, "one direction an edge");
    }

    void checkCount(std::size_t given, int wanted, const std::string& what) const {
        if (given > 1 && given != static_cast<std::size_t>(wanted))
            refuse(what + ", or one for all");
    }

    double armOf() const {
        double sum = 0;
        for (int e = 0; e < edges_; ++e) sum += length(edge(e));
        const double gyration = options_.wire.gyration(),
                     arm =
                         options_.arm > 0 ? options_.arm : std::max(sum / edges_ / 2, 2 * gyration);
        if (!(arm > gyration))
            refuse("an arm of " + std::to_string(arm) +
                   " m is too short for the inertia of the wire: above " +
                   std::to_string(gyration) + " m");
        return arm;
    }

    int next(int vertex) const { return vertex + 1 == vertices_ ? 0 : vertex + 1; }
    Vec<double> edge(int e) const { return curve_.positions[next(e)] - curve_.positions[e]; }
    // Of a joint half of each of its edges.
    double jointLength(int joint) const {
        return (length(edge(joint)) + length(edge(next(joint)))) / 2;
    }

    // The vertices from `first` on, `arity` of them, for as many firsts as told.
    std::vector<int> stencils(const Rod& rod, int count, int arity) const {
        std::vector<int> ids;
        for (int first = 0; first < count; ++first)
            for (int v = first, a = 0; a < arity; ++a, v = next(v))
                ids.push_back(rod.points.first + v);
        return ids;
    }

    // What is told of a joint, in rad.
    Vec<double> natural(int joint) const {
        const auto& given = options_.natural;
        const Vec<double> turn = jointLength(joint) * given[given.size() == 1 ? 0 : joint];
        if (!(length(turn) < pi)) refuse("the natural curvature is above half a turn a joint");
        return turn;
    }

    double directorMass(int e) const {
        const double part = options_.wire.gyration() / arm_;
        return options_.wire.density * options_.wire.area() * length(edge(e)) * part * part;
    }

    std::vector<Vec<double>> directors() const {
        std::vector<Vec<double>> at;
        Vec<double> last = anyAcross(edge(0));
        for (int e = 0; e < edges_; ++e) {
            const auto& given = options_.toward;
            const Vec<double> toward = given.empty() ? last : given[given.size() == 1 ? 0 : e];
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

    void holdFrames(Chains& chains, RodRows& all, const World& world, const Rod& rod) const {
        const int d = rod.directors.first;
        std::vector<int> held;
        for (int e = 0; e < edges_; ++e) {
            const std::array edge{rod.points.first + e, rod.points.first + next(e)};
            held.insert(held.end(), {edge[0], edge[1], d + e});
            chains.ride({d + e, edge});
        }
        Rows<FrameTurn> turns;
        const std::vector<int> points = stencils(rod, joints_, 3);
        for (int j = 0; j < joints_; ++j) {
            turns.ids.insert(turns.ids.end(), &points[3 * j], &points[3 * j] + 3);
            turns.ids.insert(turns.ids.end(), {d + j, d + next(j)});
            turns.rows.push_back(turnOf(world, j, &turns.ids[5 * j]));
        }
        all.add(restRows<DirectorAcross>(held, world.rest));
        all.add(restRows<DirectorLength>(held, world.rest));
        all.add(turns);
    }

    FrameTurn::Row<double> turnOf(const World& world, int joint, const int* ids) const {
        Stencil<Vec<double>, 5> x;
        for (int a = 0; a < 5; ++a) x[a] = world.rest[ids[a]];
        auto row = FrameTurn::rest(x);
        const double l = jointLength(joint);
        const Wire& wire = options_.wire;
        row.compliance = {l / wire.bending(), l / wire.bendingSide(), l / wire.twisting()};
        if (options_.natural.empty()) return row;
        const Vec<double> turn = natural(joint);
        const double half = length(turn) / 2;
        row.rest = half > 0 ? (sine(half) / (half * cosine(half))) * turn : turn;
        return row;
    }

    // Torsion is the dihedral angle of the planes at both ends of an edge, pi where those are one.
    void holdCurve(RodRows& all, const World& world, const Rod& rod) const {
        auto angles = restRows<Angle>(stencils(rod, joints_, 3), world.rest);
        for (int j = 0; j < joints_; ++j) {
            auto& row = angles.rows[j];
            const double l = jointLength(j),
                         bent = options_.natural.empty() ? row.rest : natural(j).y;
            for (const double angle : {row.rest, bent})
                if (!(angle > 1e-3 && angle < pi - 1e-3))
                    refuse("joint " + std::to_string(j) +
                           " is straight: a curved rod has a plane there");
            row = {bent, l / options_.wire.bendingSide()};
        }
        std::vector<int> dihedrals;
        const int torsions = joints_ == vertices_ ? vertices_ : joints_ - 1;
        const std::vector<int> points = stencils(rod, torsions, 4);
        for (int e = 0; e < torsions; ++e)
            for (const int a : {1, 2, 0, 3}) dihedrals.push_back(points[4 * e + a]);
        auto torsion = restRows<Bend>(dihedrals, world.rest);
        for (int e = 0; e < torsions; ++e) {
            auto& row = torsion.rows[e];
            const double l = length(edge(next(e)));
            row.compliance = l / options_.wire.twisting();
            if (options_.natural.empty()) continue;
            const double turn = (natural(e).z + natural(next(e)).z) / 2;
            row.rest = turn > 0 ? turn - pi : turn + pi;
        }
        all.add(angles);
        all.add(torsion);
    }

    void holdStraight(RodRows& all, const Rod& rod) const {
        Rows<BendVector> bends;
        bends.ids = stencils(rod, joints_, 3);
        for (int j = 0; j < joints_; ++j)
            bends.rows.push_back({jointLength(j) / options_.wire.bending()});
        all.add(bends);
    }

    const Shape& curve_;
    const RodOptions& options_;
    std::string name_;
    int vertices_ = 0, edges_ = 0, joints_ = 0;
    double arm_ = 0;
};

}  // namespace

std::vector<Rod> addRods(World& world, std::span<const Shape> curves, const RodOptions& options,
                         SetOptions set) {
    std::vector<RodMaker> makers;
    std::vector<Rod> rods;
    for (const Shape& curve : curves) {
        makers.emplace_back(curve, options, set.name);
        rods.push_back({makers.back().addPoints(world), {}});
    }
    Chains chains;
    RodRows rows;
    for (std::size_t i = 0; i < rods.size(); ++i) {
        rods[i].directors = makers[i].addDirectors(world, rods[i].points);
        makers[i].hold(world, rods[i], chains, rows);
    }
    rows.addTo(chains);
    chains.constrain(world, std::move(set));
    return rods;
}

Rod addRod(World& world, const Shape& curve, const RodOptions& options, SetOptions set) {
    return addRods(world, std::span(&curve, 1), options, std::move(set)).front();
}

}  // namespace plait
