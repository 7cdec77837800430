#include "geodesics.h"

#include "arctangent.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>
#include <tuple>

namespace plait {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979324;
constexpr double flat = 1e-6;      // rad that the angles around a vertex may miss
constexpr double alike = 1e-9;     // of the length of a side: the same place
constexpr double shorter = 1e-12;  // by this part at least, or it is rounding

Csr listsOf(int count, std::span<const std::array<int, 2>> pairs) {
    Csr lists;
    lists.start.assign(static_cast<std::size_t>(count) + 1, 0);
    for (const auto& [list, item] : pairs) ++lists.start[list + 1];
    for (int i = 0; i < count; ++i) lists.start[i + 1] += lists.start[i];
    lists.item.resize(pairs.size());
    std::vector<int> end(lists.start.begin(), lists.start.end() - 1);
    for (const auto& [list, item] : pairs) lists.item[end[list]++] = item;
    return lists;
}

}  // namespace

Geodesics::Geodesics(const SimplicialComplex& complex, Range range,
                     std::span<const Vec<double>> rest)
    : bends_(rest.size(), false) {
    const int vertices = complex.count(0);
    const auto inside = [&](std::span<const int> simplex) {
        return std::all_of(simplex.begin(), simplex.end(),
                           [&](int v) { return v >= range.first && v < range.last; });
    };
    std::vector<std::array<int, 2>> ends, apexes, across, sides;
    std::vector<double> angle(rest.size(), 0);
    for (int t = 0; t < complex.count(2); ++t) {
        const std::span<const int> v = complex.vertices(2, t);
        if (!inside(v)) continue;
        for (int j = 0; j < 3; ++j) {
            const int from = v[(j + 1) % 3], to = v[(j + 2) % 3], apex = v[j];
            const Vec<double> side = rest[to] - rest[from], out = rest[apex] - rest[from];
            const double l = length(side);
            const int entry = static_cast<int>(entries_.size());
            entries_.push_back({from,
                                to,
                                apex,
                                l,
                                {divide(dot(out, side), l), divide(length(cross(side, out)), l)}});
            apexes.push_back({apex, entry});
            sides.push_back({complex.faces(2, t)[j], entry});
            const Vec<double> a = rest[from] - rest[apex], b = rest[to] - rest[apex];
            angle[apex] += arctangent2(length(cross(a, b)), dot(a, b));
        }
    }
    const Csr at = listsOf(complex.count(1), sides);
    std::vector<bool> rim(rest.size(), false);
    for (int e = 0; e < complex.count(1); ++e) {
        const std::span<const int> v = complex.vertices(1, e);
        if (!inside(v)) continue;
        for (const int end : {0, 1}) {
            ends.push_back({v[end], static_cast<int>(steps_.size())});
            steps_.push_back({v[1 - end], length(rest[v[1]] - rest[v[0]])});
            // A thread, or a seam of three sheets and more: no angle says how ways run there.
            if (at[e].empty() || at[e].size() > 2) bends_[v[end]] = true;
            if (at[e].size() == 1) rim[v[end]] = true;
        }
        for (const int entry : at[e])
            for (const int other : at[e])
                if (other != entry) across.push_back({entry, other});
    }
    for (std::size_t v = 0; v < rest.size(); ++v)
        if (angle[v] > (rim[v] ? pi : 2 * pi) + flat) bends_[v] = true;
    corners_ = listsOf(vertices, apexes);
    beyond_ = listsOf(static_cast<int>(entries_.size()), across);
    edges_ = listsOf(vertices, ends);
}

// One spreading of light over a surface.
class Geodesics::Light {
public:
    explicit Light(const Geodesics& surface)
        : surface_(surface),
          ways_(surface.bends_.size(), {infinity, -1}),
          waiting_(surface.entries_.size(), -1) {}

    std::vector<Way> from(std::span<const int> sources) {
        for (const int source : sources) {
            if (source < 0 || source >= static_cast<int>(ways_.size()))
                throw std::invalid_argument("ways: there is no vertex " + std::to_string(source));
            reach(source, 0, source);
        }
        while (!open_.empty()) {
            const auto [key, unused, vertex, window] = open_.top();
            open_.pop();
            if (window >= 0)
                pass(window);
            else if (key == ways_[vertex].length)
                leave(vertex);
        }
        return std::move(ways_);
    }

private:
    // What is lit of a side, from `begin` to `end` along it, by a source (x, y), y < 0, that is
    // itself `before` away from where the way began.
    struct Window {
        int entry;
        double begin, end;
        Point light;
        double before;
        int source;
    };

    static double distance(Point a, Point b) {
        return squareRoot((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
    }

    void reach(int vertex, double length, int source) {
        if (!(length < (1 - shorter) * ways_[vertex].length)) return;
        ways_[vertex] = {length, source};
        open_.emplace(length, ++order_, vertex, -1);
    }

    // On from a vertex along its edges, and, where ways may turn, into the triangles around it.
    void leave(int vertex) {
        const auto [length, source] = ways_[vertex];
        for (const int step : surface_.edges_[vertex])
            reach(surface_.steps_[step].vertex, length + surface_.steps_[step].length, source);
        if (length > 0 && !surface_.bends_[vertex]) return;
        for (const int entry : surface_.corners_[vertex]) {
            const Entry& e = surface_.entries_[entry];
            send(entry, {0, e.length, e.at, length, source});
        }
    }

    struct Beam {
        double begin, end;  // along the side
        Point light;        // in the plane of the triangle that it leaves, the side as x axis
        double before;
        int source;
    };

    // Out across a side of a triangle, into whatever triangles lie beyond.
    void send(int out, const Beam& beam) {
        const Entry& e = surface_.entries_[out];
        for (const int in : surface_.beyond_[out]) {
            const bool turned = surface_.entries_[in].from != e.from;
            Window w{in,          beam.begin, beam.end, {beam.light.x, -beam.light.y},
                     beam.before, beam.source};
            if (turned) {
                w.begin = e.length - beam.end, w.end = e.length - beam.begin;
                w.light.x = e.length - beam.light.x;
            }
            enter(w);
        }
    }

    void enter(const Window& w) {
        const double side = surface_.entries_[w.entry].length;
        if (!(w.end - w.begin > 0) || !(-w.light.y > alike * side) || !helps(w)) return;
        // Beside one that still waits, from the same light: the two halves of one.
        int& last = waiting_[w.entry];
        if (last >= 0) {
            Window& other = windows_[last];
            const double near = alike * side;
            if (other.source == w.source && distance(other.light, w.light) < near &&
                other.begin < w.end + near && w.begin < other.end + near) {
                other.begin = std::min(other.begin, w.begin);
                other.end = std::max(other.end, w.end);
                return;
            }
        }
        last = static_cast<int>(windows_.size());
        windows_.push_back(w);
        const double x = std::clamp(w.light.x, w.begin, w.end);
        open_.emplace(w.before + distance(w.light, {x, 0}), ++order_, -1, last);
    }

    // False if the way over an end of the side is shorter for all that the window lights.
    bool helps(const Window& w) const {
        const Entry& e = surface_.entries_[w.entry];
        const double over = (1 + shorter);
        return w.before + distance(w.light, {w.end, 0}) < over * (ways_[e.from].length + w.end) &&
               w.before + distance(w.light, {w.begin, 0}) <
                   over * (ways_[e.to].length + (e.length - w.begin));
    }

    // Through a triangle: to the apex, if it is lit, and to the sides left and right of it.
    void pass(int number) {
        const Window w = windows_[number];
        const Entry& e = surface_.entries_[w.entry];
        if (waiting_[w.entry] == number) waiting_[w.entry] = -1;
        if (!helps(w)) return;
        const double middle = w.light.x - (e.at.x - w.light.x) * w.light.y / (e.at.y - w.light.y);
        const double near = alike * e.length;
        if (middle > w.begin - near && middle < w.end + near)
            reach(e.apex, w.before + distance(w.light, e.at), w.source);

        const double known = ways_[e.apex].length;
        const auto overApex = [&](double x) {
            return w.before + distance(w.light, {x, 0}) >
                   (1 + shorter) * (known + distance(e.at, {x, 0}));
        };
        const int t = w.entry / 3, j = w.entry % 3;
        if (w.begin < middle && !overApex(w.begin))
            aim(w, 3 * t + (j + 2) % 3, {0, 0}, e.from, w.begin, std::min(middle, w.end), middle);
        if (w.end > middle && !overApex(w.end))
            aim(w, 3 * t + (j + 1) % 3, {e.length, 0}, e.to, w.end, std::max(middle, w.begin),
                middle);
    }

    // On to the side from `foot`, an end of the side entered, to the apex: what comes in between
    // x0, nearer to the foot, and x1; `middle` goes to the apex itself.
    void aim(const Window& w, int out, Point foot, int footVertex, double x0, double x1,
             double middle) {
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
            send(
                out,
                {e.length - u1, e.length - u0, {e.length - x, y < 0 ? -y : y}, w.before, w.source});
    }

    const Geodesics& surface_;
    std::vector<Way> ways_;
    std::vector<Window> windows_;
    std::vector<int> waiting_;  // by entry: its last window, while it waits
    // Length, order of arrival, then a vertex or a window.
    using Event = std::tuple<double, long, int, int>;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> open_;
    long order_ = 0;
};

std::vector<Geodesics::Way> Geodesics::from(std::span<const int> sources) const {
    return Light(*this).from(sources);
}

}  // namespace plait
