// What touches, and the multipliers by which it stays apart: sweeps over pairs of pieces, each
// piece answering as the rigid body it is.
//
// A pair keeps its normal and its points for a substep, the points with their pieces. Sweeps go
// through pairs in colours, through the points of a pair in sequence. A pair that touched a substep
// earlier begins with what it was pressed by then (touch_memory.h).
#pragma once

#include "../../constraint.h"
#include "../../pieces/poses.h"
#include "../friction.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plait {

// Two points that stay apart.
struct TouchedPoint {
    Vec<double> first, second;  // m, on either piece, as it is at rest about its centre
    Vec<double> rest{};         // m, from the second to the first where friction wants them
    double gap = 0;             // m, to be kept in this substep
    double push = 0;            // multiplier across, kg m
    Vec<double> grip{};         // multiplier along, kg m
    bool slides = false;        // more was asked of friction than there is
    // As poses were when last asked for, about which sweeps are linear.
    Vec<double> apart{};                      // m, from the second to the first
    Vec<double> leverFirst{}, leverSecond{};  // m, from the centres
    double yield = 0;                         // 1/kg, across
    // Of sweeping on: what the last two sweeps gave it, and where that leads.
    double pushWas = 0, pushAlong = 0;
    Vec<double> gripWas{}, gripAlong{};
};

// A plane between two. It goes along with the piece whose face it is, which it always has behind
// it; what is between two edges stays as it is.
struct TouchedPair {
    enum class Face { first, second, none };
    int first, second;   // pieces
    Vec<double> normal;  // of unit length, to the first; of a face as it is at rest
    Face face;
    double gap;  // m, to be kept in the end
    Friction friction;
    double restitution;
    int from = 0, to = 0;  // its points
    int color = 0;
    bool leant = false;    // it began with what it was pressed by
    Vec<double> across{};  // the normal as it is about which sweeps are linear
    double stirred = 0;    // m, by both when it was last visited
};

class Touches {
public:
    explicit Touches(const Pieces& pieces);

    std::vector<Pose> poses;  // by piece, where it is by now
    std::vector<TouchedPair> pairs;
    std::vector<TouchedPoint> points;

    // A substep begins with this piece there: how it answers until the end.
    // `radius` (m) is that of what is farthest from its centre; what is held does not yield.
    void begin(int piece, const Pose& start, double radius, bool held);
    bool yields(int piece) const { return answers_[place(piece)].inverseMass > 0; }
    // When all have begun: pieces with the same leader, which is one of them, answer as one body.
    void join(std::span<const std::int32_t> leaders, std::span<const Pose> start);
    // How a piece, or all that moves with it, answers where the substep began.
    struct Answer {
        double radius = 0;                   // m
        double inverseMass = 0;              // 1/kg; 0: does not yield
        Symmetric<double> inverseInertia{};  // 1/(kg m^2)
    };
    const Answer& answerOf(int piece) const { return answers_[place(piece)]; }
    // With which it moves as one; itself if it moves alone.
    int leader(int piece) const { return leaders_[place(piece)]; }
    // The centre of these, now.
    Vec<double> centreOf(int piece) const {
        const Pose& pose = poses[place(leader(piece))];
        return pose.centre + pose.turn * centres_[place(leader(piece))];
    }
    // All that move as one with a leader.
    std::span<const int> members(int leader) const {
        return std::span(members_).subspan(
            place(starts_[place(leader)]),
            place(starts_[place(leader) + 1] - starts_[place(leader)]));
    }

    // For all pairs and points that there are by now; before a sweep.
    void colour();
    // Sweeps once, or until no point is nearer than `least` of its gap, or pushed farther than
    // twice its gap, but not for ever: by nonlinear conjugate gradients on top of sweeps
    // (Silcowitz, Niebe and Erleben 2010), since a light piece between a heavy one and the ground
    // takes sweeps alone as many times as the one is heavier. Returns how many.
    void sweep(Direction direction, Workers& workers);
    int sweepOn(double least, Workers& workers);

    std::span<TouchedPoint> of(const TouchedPair& pair) {
        return std::span(points).subspan(place(pair.from), place(pair.to - pair.from));
    }
    std::span<const TouchedPoint> of(const TouchedPair& pair) const {
        return std::span(points).subspan(place(pair.from), place(pair.to - pair.from));
    }
    // The normal, and where a point of the second is from one of the first, with these poses.
    static Vec<double> normalOf(const TouchedPair& pair, const Pose& first, const Pose& second);
    static Vec<double> apartOf(const TouchedPoint& point, const Pose& first, const Pose& second);
    Vec<double> normalOf(const TouchedPair& pair) const {
        return normalOf(pair, poses[place(pair.first)], poses[place(pair.second)]);
    }
    Vec<double> apartOf(const TouchedPair& pair, const TouchedPoint& point) const {
        return apartOf(point, poses[place(pair.first)], poses[place(pair.second)]);
    }
    // Where a push acts, from the centres of what answers: in one place, so that nothing is turned
    // by it that was not before. Of a face that is the point over it.
    struct Levers {
        Vec<double> first, second;  // m
    };
    Levers leversOf(const TouchedPair& pair, const TouchedPoint& point) const;
    // Makes sweeps linear about the poses: what cannot be is a convex problem then, on which they
    // converge whatever they begin with. With exact turns they throw what is light and thin.
    void linearise(Workers& workers);
    // Moves both by what is new of the multipliers at its points, in all.
    template <class New>
    void move(const TouchedPair& pair, const New& newOf) {
        Vec<double> sum{}, twistFirst{}, twistSecond{};
        for (TouchedPoint& point : of(pair)) {
            const Vec<double> impulse = newOf(point);
            sum += impulse;
            twistFirst += cross(point.leverFirst, impulse);
            twistSecond += cross(point.leverSecond, impulse);
        }
        push(pair.first, sum, twistFirst);
        push(pair.second, -sum, -twistSecond);
    }
    // Poses go where sweeps and moves have led.
    void apply(Workers& workers);

private:
    bool gripping_ = true;                 // false: sweeps leave grips as they are
    static constexpr int colorLimit = 64;  // pairs beyond run one by one

    static std::size_t place(int i) { return static_cast<std::size_t>(i); }
    template <class Visit>
    void forColours(Direction direction, Workers& workers, const Visit& visit);
    double stirred(const TouchedPair& pair) const {
        return stirred_[place(leader(pair.first))] + stirred_[place(leader(pair.second))];
    }
    static double yieldOf(const Answer& first, const Answer& second, const TouchedPoint& point,
                          const Vec<double>& direction);
    void joinCluster(int leader, std::span<const Pose> start);
    void part(TouchedPair& pair, Direction direction);
    void push(int piece, const Vec<double>& impulse, const Vec<double>& twist);
    Vec<double> apartNow(const TouchedPair& pair, const TouchedPoint& point) const {
        const Motion &a = motions_[place(leader(pair.first))],
                     &b = motions_[place(leader(pair.second))];
        return point.apart + a.shift - b.shift + cross(a.turn, point.leverFirst) -
               cross(b.turn, point.leverSecond);
    }
    bool settled(double least, Workers& workers) const;
    int sweepLinear(double least, int most, Workers& workers);
    double change() const;
    void goOn(double part, Workers& workers);

    const Pieces* pieces_;
    std::vector<Answer> answers_;
    struct Motion {
        Vec<double> shift{}, turn{};  // m, rad
    };
    std::vector<int> leaders_, starts_, members_;  // by piece; by leader, where it begins; pieces
    std::vector<Vec<double>> centres_;  // m, by leader: of all that move with it, from its own, as
                                        // it is at rest
    std::vector<Motion> motions_;       // by leader, since poses were last asked for
    std::vector<double> stirred_;       // m, by leader: how far pushes have moved it in all
    std::array<int, colorLimit + 2> colors_{};  // where each colour begins in byColor_
    std::vector<int> byColor_;                  // pairs
    std::vector<std::uint64_t> taken_;          // colours at each piece
};

}  // namespace plait
