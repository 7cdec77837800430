#include "light.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

constexpr double shorter = 1e-12;  // by this part at least, or it is rounding

}  // namespace

Geodesics::Light::Light(const Geodesics& surface, std::span<const int> sources)
    : surface_(surface),
      ways_(surface.bends_.size(), {infinity, -1}),
      sent_(ways_.size(), -1),
      latest_(surface.entries_.size(), -1),
      waiting_(surface.entries_.size(), -1),
      isDark_(ways_.size(), false),
      isTouched_(surface.taken_.size(), false) {
    for (const int source : sources) {
        if (source < 0 || source >= static_cast<int>(ways_.size()))
            throw std::invalid_argument("ways: there is no vertex " + std::to_string(source));
        reach(source, 0, source);
    }
    spread();
}

void Geodesics::Light::spread() {
    while (!open_.empty()) {
        const auto [key, unused, vertex, window] = open_.top();
        open_.pop();
        ++visited_;
        if (window >= 0)
            pass(window);
        else if (key == ways_[vertex].length)
            leave(vertex);
    }
}

void Geodesics::Light::reach(int vertex, double length, int source) {
    if (dark_) return loseWay(vertex, length);
    if (!(length < (1 - shorter) * ways_[vertex].length)) return;
    ways_[vertex] = {length, source};
    open_.emplace(length, ++order_, vertex, -1);
}

// On from a vertex along its edges, and, where ways may turn, into the triangles around it.
void Geodesics::Light::leave(int vertex) {
    const auto [length, source] = ways_[vertex];
    for (const int step : surface_.edges_[vertex])
        reach(surface_.steps_[step].vertex, length + surface_.steps_[step].length, source);
    if (length > 0 && !surface_.bends_[vertex]) return;
    parent_ = -1 - vertex;
    for (const int entry : surface_.corners_[vertex]) {
        if (surface_.taken_[entry / 3]) continue;
        const Entry& e = surface_.entries_[entry];
        send(entry, {0, e.length, e.at, length, source});
    }
}

// Out across a side of a triangle, into what lies beyond.
void Geodesics::Light::send(int out, const Beam& beam) {
    const Entry& e = surface_.entries_[out];
    for (const int in : surface_.beyond_[out]) {
        if (surface_.taken_[in / 3]) continue;
        const bool turned = surface_.entries_[in].from != e.from;
        Window w{in,          beam.source, beam.begin, beam.end, {beam.light.x, -beam.light.y},
                 beam.before, latest_[in]};
        if (turned) {
            w.begin = e.length - beam.end, w.end = e.length - beam.begin;
            w.light.x = e.length - beam.light.x;
        }
        enter(w);
    }
}

void Geodesics::Light::enter(const Window& w) {
    if (dark_) return loseLight(w);
    if (!touched_.empty() && (!isTouched_[w.entry / 3] || isLit(w))) return;
    const double side = surface_.entries_[w.entry].length;
    if (!(w.end - w.begin > (touched_.empty() ? 0 : alike * side)) ||
        !(-w.light.y > alike * side) || !helps(w))
        return;
    // Beside one that still waits, from the same light: the two halves of one.
    int& last = waiting_[w.entry];
    if (last >= 0) {
        Window& other = windows_[last];
        const double near = alike * side;
        if (other.source == w.source && distance(other.light, w.light) < near &&
            other.begin < w.end + near && w.begin < other.end + near) {
            other.begin = std::min(other.begin, w.begin);
            other.end = std::max(other.end, w.end);
            other.before = std::min(other.before, w.before);  // a vertex may be left twice
            adopt(last);
            return;
        }
    }
    last = latest_[w.entry] = static_cast<int>(windows_.size());
    windows_.push_back(w);
    adopt(last);
    queue(last, w.begin, w.end);
}

void Geodesics::Light::adopt(int window) {
    int& list = childrenOf(parent_);
    children_.push_back({window, list});
    list = static_cast<int>(children_.size()) - 1;
}

// To be passed when the nearest of it is.
void Geodesics::Light::queue(int window, double begin, double end) {
    const Window& w = windows_[window];
    const double x = std::clamp(w.light.x, begin, end);
    open_.emplace(w.before + distance(w.light, {x, 0}), ++order_, -1, window);
}

// False if the way over an end of the side is shorter for all that the window lights.
bool Geodesics::Light::helps(const Window& w) const {
    const Entry& e = surface_.entries_[w.entry];
    const double over = (1 + shorter);
    return w.before + distance(w.light, {w.end, 0}) < over * (ways_[e.from].length + w.end) &&
           w.before + distance(w.light, {w.begin, 0}) <
               over * (ways_[e.to].length + (e.length - w.begin));
}

// Through a triangle: to the apex, if it is lit, and to the sides left and right of it.
void Geodesics::Light::pass(int number) {
    Window w = windows_[number];
    parent_ = number;
    const Entry& e = surface_.entries_[w.entry];
    if (waiting_[w.entry] == number) waiting_[w.entry] = -1;
    if (dark_) {
        Shadow& shadow = shadows_.at(number);
        if (shadow.passed) return;
        shadow.passed = true;
        w.begin = shadow.begin, w.end = shadow.end;
    } else if (!helps(w)) {
        // No light has gone on by it, unless it is lit once more.
        if (touched_.empty()) windows_[number].end = windows_[number].begin;
        return;
    }
    const double middle = w.light.x - (e.at.x - w.light.x) * w.light.y / (e.at.y - w.light.y);
    const double near = (dark_ ? blurred : alike) * e.length;
    if (middle > w.begin - near && middle < w.end + near)
        reach(e.apex, w.before + distance(w.light, e.at), w.source);

    const double known = ways_[e.apex].length;
    const auto overApex = [&](double x) {
        return !dark_ && w.before + distance(w.light, {x, 0}) >
                             (1 + shorter) * (known + distance(e.at, {x, 0}));
    };
    const int t = w.entry / 3, j = w.entry % 3;
    const double blur = dark_ ? near : 0;
    if (w.begin < middle + blur && !overApex(w.begin))
        aim(w, 3 * t + (j + 2) % 3, {0, 0}, e.from, w.begin, std::min(middle, w.end), middle);
    if (w.end > middle - blur && !overApex(w.end))
        aim(w, 3 * t + (j + 1) % 3, {e.length, 0}, e.to, w.end, std::max(middle, w.begin), middle);
}

// On to the side from `foot`, an end of the side entered, to the apex: what comes in between
// x0, nearer to the foot, and x1; `middle` goes to the apex itself.
void Geodesics::Light::aim(const Window& w, int out, Point foot, int footVertex, double x0,
                           double x1, double middle) {
    const Entry& in = surface_.entries_[w.entry];
    const Entry& e = surface_.entries_[out];
    const Point along{in.at.x - foot.x, in.at.y - foot.y};
    const auto hit = [&](double x) {
        if (x == middle) return 1.0;
        const Point ray{x - w.light.x, -w.light.y};
        const double down = along.x * ray.y - along.y * ray.x;
        const double u = (w.light.x - foot.x) * ray.y - w.light.y * ray.x;
        return down == 0 ? 0.0 : std::clamp(u / down, 0.0, 1.0);
    };
    const double u0 = e.length * hit(x0), u1 = e.length * hit(x1);
    const Point to{w.light.x - foot.x, w.light.y};
    const double x = divide(along.x * to.x + along.y * to.y, e.length);
    const double y = divide(along.x * to.y - along.y * to.x, e.length);
    // `send` takes the light above the side, from e.from to e.to.
    if (e.from == footVertex)
        send(out, {u0, u1, {x, y < 0 ? -y : y}, w.before, w.source});
    else
        send(out,
             {e.length - u1, e.length - u0, {e.length - x, y < 0 ? -y : y}, w.before, w.source});
}

}  // namespace plait
