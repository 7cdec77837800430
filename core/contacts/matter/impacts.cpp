#include "impacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plait {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

using Points = std::array<Vec<double>, 4>;

Vec<double> at(const Path& path, double t) { return (1 - t) * path.start + t * path.end; }

class Impacts {
public:
    Impacts(std::span<const Bounce> bounces, std::span<const double> inverseMass,
            std::span<Path> paths, double least)
        : bounces_(bounces), inverseMass_(inverseMass), paths_(paths), least_(least) {
        for (const Bounce& b : bounces_) times_.push_back(timeOf(b));
    }

    bool any() const {
        return std::ranges::any_of(times_, [](double time) { return time < never; });
    }

    // Where there are any.
    void next() {
        const auto first = std::ranges::min_element(times_);
        const Bounce& b = bounces_[static_cast<std::size_t>(first - times_.begin())];
        bend(b, *first);
        for (std::size_t i = 0; i < bounces_.size(); ++i)
            if (sharePath(bounces_[i], b)) times_[i] = timeOf(bounces_[i]);
    }

private:
    std::span<const int> verticesOf(const Bounce& b) const {
        return std::span(b.pair.vertices).first(b.pair.first + b.pair.second);
    }

    bool sharePath(const Bounce& a, const Bounce& b) const {
        for (const int v : verticesOf(a))
            for (const int u : verticesOf(b))
                if (u == v && inverseMass_[std::size_t(v)] > 0) return true;
        return false;
    }

    Points pointsAt(const Bounce& b, double t) const {
        Points x;
        for (std::size_t i = 0; i < 4; ++i) x[i] = at(paths_[std::size_t(b.pair.vertices[i])], t);
        return x;
    }

    Vec<double> relative(const Bounce& b, const Nearest& now) const {
        Vec<double> way{};
        for (std::size_t i = 0; i < 4; ++i) {
            const Path& path = paths_[std::size_t(b.pair.vertices[i])];
            way += now.weight[i] * (path.end - path.start);
        }
        return way;
    }

    // When they meet, where they approach each other then.
    double timeOf(const Bounce& b) const {
        double from = 0;
        for (const int v : verticesOf(b)) from = std::max(from, paths_[std::size_t(v)].from);
        const Impact t = impactOf(b.pair, pointsAt(b, from), pointsAt(b, 1), b.gap);
        if (!t) return never;
        const double time = from + *t * (1 - from);
        const Nearest now = nearest(b.pair, pointsAt(b, time));
        const double distance = length(now.apart);
        return dot(relative(b, now), now.apart) < -least_ * distance ? time : never;
    }

    void bend(const Bounce& b, double t) {
        const Points x = pointsAt(b, t);
        const Nearest now = nearest(b.pair, x);
        const Vec<double> normal = divide(1.0, length(now.apart)) * now.apart;
        const Vec<double> way = relative(b, now);
        const double approach = dot(way, normal);
        double yield = 0, gain = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto v = static_cast<std::size_t>(b.pair.vertices[i]);
            yield += now.weight[i] * now.weight[i] * inverseMass_[v];
            gain += now.weight[i] * dot(paths_[v].gain, normal);
        }
        const double speed = std::min(approach + (t - 0.5) * gain, 0.0);
        const double push = -divide((1 + b.restitution) * speed, yield);
        const Vec<double> along = way - approach * normal;
        const double grip = std::min(divide(length(along), yield), b.friction * push);
        const Vec<double> impulse = push * normal - divide(grip, length(along)) * along;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto v = static_cast<std::size_t>(b.pair.vertices[i]);
            if (now.weight[i] == 0 || inverseMass_[v] == 0) continue;
            Path& path = paths_[v];
            const Vec<double> goes =
                path.end - path.start + now.weight[i] * inverseMass_[v] * impulse;
            path = {x[i] - t * goes, x[i] + (1 - t) * goes, path.gain, t, true};
        }
    }

    std::span<const Bounce> bounces_;
    std::span<const double> inverseMass_;
    std::span<Path> paths_;
    double least_;
    std::vector<double> times_;
};

}  // namespace

Bounced bounce(std::span<const Bounce> bounces, std::span<const double> inverseMass,
               std::span<Path> paths, double least, int limit) {
    Impacts impacts(bounces, inverseMass, paths, least);
    int count = 0;
    for (; count < limit && impacts.any(); ++count) impacts.next();
    return {count, impacts.any()};
}

}  // namespace plait
