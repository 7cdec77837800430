// The set of all contacts of pieces among themselves: convex solids stay their thicknesses apart,
// with friction, and never pass through each other.
//
// Looked at in two levels: first which pieces come near each other on their way, then each such
// pair for itself. A pair goes along its way to where it first comes near (approach.h); the plane
// that parts it there is its contact, at the points where one covers the other. Either piece
// answers as the rigid body it is, so that one push parts what touches in one point, however many
// vertices a piece has (vertex by vertex a shard of 12 takes 17 evaluations to 1 %). After the last
// column all ways are looked at once more (finish), as in matter/contact_set.h.
#pragma once

#include "../../contact_constraint.h"
#include "../counts.h"
#include "../matter/impact_zones.h"
#include "../surface.h"
#include "approach.h"
#include "near_pieces.h"
#include "piece_bounces.h"
#include "sleep.h"
#include "touch_memory.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace plait {

struct World;

template <class Real>
class PieceContacts : public ContactConstraint<Real> {
public:
    // One surface a piece of the world, in their order.
    PieceContacts(const World& world, std::vector<Surface> surfaces, const ContactOptions& options,
                  const SleepOptions& sleep);

    void beginFrame(double /*t0*/, double /*t1*/) override {
        gaveUp_ = false;
        near_.pairs.clear();  // a run that is resumed knows nothing of what parted them last
        std::ranges::fill(placed_, 0);
    }
    void furnish(Drawer<Real>& kept) const override {
        memory_.furnish(kept);
        sleep_.furnish(kept);
    }
    void begin(const Substep& substep, Workers& workers) override;
    bool needsPast() const override { return bouncy_; }
    void strike(const Sweep<Real>& sweep, const State<Real>& state, const Drawer<Real>& kept,
                Workers& workers) override;
    void project(const Sweep<Real>& sweep, Direction direction, Workers& workers) override;
    long finish(const Sweep<Real>& sweep, Workers& workers) override;
    long holdBack(const Sweep<Real>& sweep, Workers& workers) override;
    void addLoads(std::vector<Load>& loads) const override;
    void conclude(const Sweep<Real>& sweep, Workers& workers) override;
    void rebound(State<Real>& state, Drawer<Real>& kept) const override;
    void markTouched(std::vector<std::uint8_t>& touched) const override;
    long failures() const override { return counts_.failures(); }
    // Points looked at in the evaluation last made.
    long size() const override { return std::ssize(touches_.points); }

    const ContactCounts& counts() const { return counts_; }

private:
    struct Found {
        std::vector<TouchedPair> pairs;
        std::vector<TouchedPoint> points;
    };

    void prepare(const Sweep<Real>& sweep, Workers& workers);
    void begin(const Sweep<Real>& sweep, int piece);
    void foreseeAll(Workers& workers);
    NearPieces::Bounds boundsOf(int piece) const;
    double gapOf(int first, int second) const;
    // How far a corner's arc leaves its chord at most.
    double bulgeOf(int piece) const {
        return shapes_[piece].radius * ways_[piece].angle() * ways_[piece].angle() / 8;
    }
    // look(near, found), a block of pairs in sequence.
    template <class Look>
    void lookAtNear(Workers& workers, const Look& look) {
        constexpr int each = 64;
        const int count = static_cast<int>(near_.pairs.size()), blocks = (count + each - 1) / each;
        if (std::ssize(found_) < blocks) found_.resize(blocks);
        for (Found& found : found_) found.pairs.clear(), found.points.clear();
        workers.forBlocks(blocks, 4, [&](int begin, int end) {
            for (int b = begin; b < end; ++b)
                for (int i = b * each; i < std::min(count, (b + 1) * each); ++i)
                    look(near_.pairs[i], found_[b]);
        });
    }
    void joinClusters();
    void addHeld(std::vector<Load>& loads) const;
    bool joined(const NearPieces::Near& near) const {
        return touches_.leader(near.first) == touches_.leader(near.second);
    }
    bool staysAway(const NearPieces::Near& near) const;
    void foresee(NearPieces::Near& near, Found& found) const;
    bool parted(const NearPieces::Near& near) const;
    bool crosses(const NearPieces::Near& near, Meeting& meeting) const;
    void check(NearPieces::Near& near, Found& found) const;
    Parting planeOf(const NearPieces::Near& near, const Meeting& meeting, const Pose& firstThere,
                    const Pose& secondThere) const;
    void add(const NearPieces::Near& near, const Meeting& meeting, const PoseWay& firstWay,
             const PoseWay& secondWay, Found& found) const;
    long take();
    void noteLeft(const Sweep<Real>& sweep, int piece);
    void putAll(const Sweep<Real>& sweep, Workers& workers);
    void findPoses(const Sweep<Real>& sweep, Workers& workers);
    long sweepOn(const Sweep<Real>& sweep, Workers& workers);
    long findCrossing(Workers& workers);
    long putBack(const Sweep<Real>& sweep, Workers& workers, long crossing, bool hold);
    long putEverythingBack(const Sweep<Real>& sweep) const;
    void noteComing(const Sweep<Real>& sweep, const State<Real>& state, int piece);
    void holdSleepers(const Sweep<Real>& sweep) const;
    bool wakes(const TouchedPair& pair) const;
    bool wakeTouched(const Sweep<Real>& sweep);
    void joinIslands();
    void rest(State<Real>& state, Drawer<Real>& kept) const;
    void gatherBodies();
    void gatherPairs();
    void bounce();
    void spreadStruck();
    void leave(State<Real>& state, int piece) const;
    void leaveAll(State<Real>& state) const;

    ContactOptions options_;
    Pieces pieces_;
    int clusters_;                           // as the world has it
    std::span<const std::int32_t> leaders_;  // of pieces that move as one; empty: each alone
    std::vector<Surface> surfaces_;
    std::vector<double> thickness_;  // m, by piece
    std::vector<Convex> shapes_;
    double slack_ = 0;                   // m, that contacts reach beyond their gap
    std::vector<unsigned char> pinned_;  // by vertex: its piece does not yield
    std::vector<unsigned char> moves_;   // by piece, in this substep
    std::vector<unsigned char> placed_;  // by piece: it sleeps, and its pose is known
    std::vector<PoseWay> ways_;          // as foreseen
    std::vector<Pose> starts_, looked_;  // where the substep began; when last asked what crosses
    std::vector<Pose> leant_;            // as what is remembered would have it
    std::vector<unsigned char> struck_;  // by what is not remembered
    std::vector<unsigned char> moved_;   // since then
    std::vector<float> strayed_;         // m: how far what is of a piece is off its way as foreseen
    NearPieces near_;
    std::vector<Found> found_;  // by block of near_
    Touches touches_;           // foreseen, then those that crossed
    TouchMemory memory_;
    mutable Sleep sleep_;  // what it says of the next substep is only known after velocities are
    bool bouncy_ = false;  // something has restitution
    struct Coming {
        Vec<double> velocity{}, momentum{}, gain{};  // m/s; kg m^2/s, about its centre; m/s^2
    };
    std::vector<Coming> coming_;   // by piece, where the substep began
    PieceBounces bounces_;         // bodies by leader
    std::vector<Vec<Real>> left_;  // d, as its pose was last found or put
    ImpactZones zones_;
    std::vector<int> whole_;                // vertices of two pieces
    std::vector<std::array<int, 2>> back_;  // pairs of pieces put back in this substep
    double gravity_ = 0;                    // m/s^2
    double h_ = 0;                          // s
    bool ready_ = false;                    // touches_ are those of this substep
    int backRounds_ = 0;                    // in which what crossed was put back in this substep
    bool gaveUp_ = false;                   // in this base step: nothing moves until its end
    ContactCounts counts_;
};

extern template class PieceContacts<float>;
extern template class PieceContacts<double>;

// Adds the set of all contacts of the world's pieces with each other; `surfaces` has one a piece,
// in their order, of which thickness, friction, and vertices count. Throws std::invalid_argument,
// naming the value, for one out of range, and for a piece that is not convex.
// What is to fall asleep may meet pieces alone: a solver of a world with other contacts throws.
void meetPieces(World& world, std::vector<Surface> surfaces, const ContactOptions& options = {},
                const SleepOptions& sleep = {});

}  // namespace plait
