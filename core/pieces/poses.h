// Where pieces are, and how they answer a push.
#pragma once

#include "../constraint.h"
#include "../numbers/rotation.h"
#include "../numbers/symmetric.h"
#include "../world.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

// A piece at rest, about its centre.
struct Body {
    Range vertices;
    Vec<double> centre{};                // m, at rest
    double inverseMass = 0;              // 1/kg; 0: a vertex is pinned, and it does not yield
    Symmetric<double> inverseInertia{};  // 1/(kg m^2), at rest; 0 likewise
    std::array<int, 3> base;             // vertices far apart, for a first guess
    std::vector<Vec<double>> arm{};      // m, from the centre, by vertex
    std::vector<double> mass{};          // kg, by vertex; a pinned one has a million times the
                                         // mass of all, so that the pose is its own
    Vec<double> heavy{};                 // m, the centre by these masses, from `centre`
};

struct Pose {
    Vec<double> centre;  // m
    Rotation turn;       // from rest

    friend bool operator==(const Pose&, const Pose&) = default;
};

class Pieces {
public:
    explicit Pieces(const World& world) : Pieces(world, world.pieces) {}
    Pieces(const World& world, std::span<const Range> ranges);

    int count() const { return static_cast<int>(bodies_.size()); }
    const Body& body(int piece) const { return bodies_[static_cast<std::size_t>(piece)]; }
    // -1: of none.
    int of(int vertex) const { return of_.empty() ? -1 : of_[static_cast<std::size_t>(vertex)]; }

    // The pose nearest to where its vertices are, by their masses: proper, whatever they are like.
    template <class Real>
    Pose poseOf(const Sweep<Real>& sweep, int piece) const;
    // The same where the substep began.
    template <class Real>
    Pose startOf(const Sweep<Real>& sweep, int piece) const;
    // Its vertices go where the pose has them, but for pinned ones.
    template <class Real>
    void put(const Sweep<Real>& sweep, int piece, const Pose& pose) const;

private:
    template <class At>
    Pose nearestPose(const Body& body, const At& at) const;

    std::vector<Body> bodies_;
    std::vector<int> of_;  // by vertex; empty: there are no pieces
};

// How far what is at `lever` (m, from the centre) moves along n by an impulse of 1 (kg m) along it.
double yieldOf(const Body& body, const Pose& pose, const Vec<double>& lever, const Vec<double>& n);
// The pose after an impulse (kg m) there.
Pose pushed(const Body& body, const Pose& pose, const Vec<double>& lever,
            const Vec<double>& impulse);

// From one pose to another: the centre straight and steadily, the turn about one axis.
class PoseWay {
public:
    PoseWay() = default;
    PoseWay(const Pose& from, const Pose& to);

    const Pose& start() const { return from_; }
    Pose at(double part) const;                        // 0 to 1
    const Vec<double>& shift() const { return way_; }  // m, of the centre
    const Vec<double>& turn() const { return turn_; }  // rad, for turnBy
    // By how much what is within `radius` (m) of the centre goes along n of unit length at most,
    // for each part of the way of length 1.
    double along(const Vec<double>& n, double radius) const {
        return dot(way_, n) + radius * length(cross(n, turn_));
    }
    double angle() const { return length(turn_); }  // rad, at least as much as it turns

private:
    Pose from_;
    Vec<double> way_{}, turn_{};  // m; for turnBy
};

}  // namespace plait
