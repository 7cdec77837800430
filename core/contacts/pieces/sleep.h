// Islands of pieces that rest are not looked at any more (Erleben 2004, "contact groups"): all that
// touches, directly or by others, falls asleep together when none of it has been faster than a
// speed for a while, and wakes together when something that is awake comes to touch it, or when
// what it lies on moves. Asleep a vertex has no inverse mass and no speed, so that whatever meets
// it finds it immovable.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace plait {

template <class Real>
struct Drawer;

struct SleepOptions {
    double speed = 0;    // m/s, of the fastest vertex of a piece; 0: nothing falls asleep
    double delay = 0.5;  // s

    explicit operator bool() const { return speed > 0; }
};

// Who sleeps, and for how long the others have been slow; behind what else is in the drawer.
class Sleep {
public:
    Sleep(int pieces, const SleepOptions& options);

    explicit operator bool() const { return bool(options_); }
    bool asleep(int piece) const { return !beds_.empty() && beds_[place(piece)] >= 0; }

    template <class Real>
    void furnish(Drawer<Real>& drawer) const;
    template <class Real>
    void read(const Drawer<Real>& drawer);

    // All that fell asleep together with this piece wakes.
    void wake(int piece);

    // A substep of h (s) ends. Joins what touches; then says how fast each was (m/s; below 0: it
    // does not move by itself); then asks who falls asleep.
    void begin();
    void join(int first, int second);
    void note(int piece, double speed, double h);
    void fall(double h);
    template <class Real>
    void write(Drawer<Real>& drawer) const;

private:
    static constexpr int integersEach = 2;

    static std::size_t place(int piece) { return static_cast<std::size_t>(piece); }
    int rootOf(int piece);

    SleepOptions options_;
    // By piece: the first of those it fell asleep with, -1 while it is awake; substeps for which it
    // has been slow.
    std::vector<std::int32_t> beds_, calm_;
    std::vector<int> joined_;             // by piece: towards the first of its island
    std::vector<std::int32_t> restless_;  // by first of an island: the least of calm_
};

}  // namespace plait
