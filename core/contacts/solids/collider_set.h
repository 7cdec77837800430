// The set of all contacts of vertices with colliders (S 7). Everything happens in the collider's
// own axes, in which what it carries along stands still: so its velocity at the contact, turning
// included, drags by friction, and a path is straight from where the vertex was to where it is.
//
// A vertex and a collider are one constraint, and vertices do not know of each other: all run at
// once. One that cannot have reached any collider yet costs the square of its way.
#pragma once

#include "../../contact_constraint.h"
#include "../matter/impacts.h"
#include "collider.h"

namespace plait {

template <class Real>
class ColliderSet : public ContactConstraint<Real> {
public:
    ColliderSet(const World& world, const std::vector<Collider>& colliders,
                const std::vector<Surface>& surfaces, const ColliderOptions& options);

    void beginFrame(double t0, double t1) override;
    void begin(const Substep& substep, Workers& workers) override;
    bool needsPast() const override { return bouncy_; }
    double partingTime(const Sweep<Real>& sweep, Workers& workers) override;
    void strike(const Sweep<Real>& sweep, const State<Real>& state, const Drawer<Real>& kept,
                Workers& workers) override;
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    long finish(const Sweep<Real>& sweep, Workers& workers) override;
    long holdBack(const Sweep<Real>& sweep, Workers& workers) override;
    void conclude(const Sweep<Real>& sweep, Workers& workers) override;
    void rebound(State<Real>& state, Drawer<Real>& kept) const override;
    void markTouched(std::vector<std::uint8_t>& touched) const override;
    long failures() const override { return failed_; }
    long size() const override { return static_cast<long>(rows_.size()); }

private:
    struct Body {
        Collider collider;
        Placement from, to;     // at the ends of the base step
        Vec<double> turn;       // rad, in it
        Placement before, now;  // at the ends of the substep
        double way, twist;      // m, and m for each m from its origin, that it moves in the substep
    };
    struct Member {
        int vertex, surface;
        double thickness;  // m
        bool isRound;      // a particle or of a curve
    };
    // What a vertex must stay in front of, in the collider's axes: dot(normal, x) >= offset.
    struct Plane {
        Vec<double> normal;
        double offset;  // m
        double value(const Vec<double>& x) const { return dot(normal, x) - offset; }
    };
    struct Row {
        double push = 0;     // multiplier across, kg m
        Vec<double> grip{};  // multiplier along, kg m, in the collider's axes
        Plane plane{};       // by which it was last pushed
    };

    void prepare(const Sweep<Real>& sweep, Workers& workers);
    void measure(const Sweep<Real>& sweep, int member);
    bool mayTouch(const Sweep<Real>& sweep, int member);
    double hold(const Member& member, const Body& body) const;
    double gapOf(const Member& member, const Side& start) const;
    Plane touch(const Member& member, const Body& body, const Vec<double>& start,
                const Vec<double>& end) const;
    bool part(const Sweep<Real>& sweep, int member, std::size_t body);
    bool isFar(const Sweep<Real>& sweep, int member, std::size_t body) const;
    std::array<Vec<double>, 2> wayOf(const Sweep<Real>& sweep, int member, std::size_t body) const;
    bool passes(const Sweep<Real>& sweep, int member, std::size_t body) const;
    bool isPressed(const Sweep<Real>& sweep, int member, std::size_t body) const;
    template <class Act>
    long whereItPasses(const Sweep<Real>& sweep, Workers& workers, const Act& act);
    bool strike(const Member& member, Path& path) const;

    ColliderOptions options_;
    double gravity_;  // m/s^2: what rests approaches by its step
    std::vector<Surface> surfaces_;
    std::vector<Body> bodies_;
    std::vector<Member> members_;  // vertices that move
    std::vector<Row> rows_;        // a member's one after the other, by body
    std::vector<double> free_;     // by row, m^2: how far it may go before it can touch, squared
    // By member: the least of these; whether they are of this substep, or not looked at because it
    // is `room` (m, at least) away from all; whether one of its rows was written.
    struct Reach {
        double clear = 0, room = 0;
        bool measured = false, written = false;
    };
    std::vector<Reach> reach_;
    bool bouncy_ = false;
    std::vector<Vec<double>> kick_;   // by member, m/s: by which a bounce is faster than its step
    std::vector<std::uint8_t> bent_;  // by member
    double h_ = 0;                    // s
    double opens_ = 0;                // m, that what begins too near may part
    bool ready_ = false;              // rows_ are those of this substep
    bool moving_ = false;             // a body moves in it
    // Times that a vertex was left inside, one that is round within a quarter of its thickness, or
    // that one had more bounces than are followed.
    long failed_ = 0;
};

extern template class ColliderSet<float>;
extern template class ColliderSet<double>;

}  // namespace plait
