#include "enclosure.h"

#include "../inspection/facing.h"
#include "../inspection/weld.h"
#include "../measure/surfaces/geometry.h"
#include "../stencils.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace plait {
namespace {

using Edge = std::array<int, 2>;
using Triangle = std::array<int, 3>;

// Where a surface is not closed; edges as they run in their triangle.
struct Openings {
    std::vector<Edge> open;     // of one triangle
    std::vector<Edge> twisted;  // of more, that cannot all face outward
};

Openings openingsOf(std::span<const Triangle> triangles) {
    struct Side {
        Edge sorted, edge;
        auto operator<=>(const Side&) const = default;
    };
    std::vector<Side> sides;
    for (const Triangle& t : triangles)
        for (int j = 0; j < 3; ++j) {
            const Edge edge{t[j], t[(j + 1) % 3]};
            sides.push_back({{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}, edge});
        }
    std::ranges::sort(sides);
    Openings openings;
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last = std::find_if(first, sides.end(),
                                       [&](const Side& s) { return s.sorted != first->sorted; });
        const auto up =
            std::count_if(first, last, [](const Side& s) { return s.edge == s.sorted; });
        if (last - first == 1)
            openings.open.push_back(first->edge);
        else if (2 * up != last - first)
            openings.twisted.push_back(first->sorted);
        first = last;
    }
    return openings;
}

std::string listed(const std::vector<Edge>& edges) {
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, edges.size()); ++i)
        text += (i ? ", " : "") + std::to_string(edges[i][0]) + "-" + std::to_string(edges[i][1]);
    return text + (edges.size() > most ? ", ..." : "");
}

std::string edgesOf(const std::vector<Edge>& edges) {
    return std::to_string(edges.size()) + (edges.size() == 1 ? " edge" : " edges");
}

// What to do about open edges: their vertices may be doubled.
std::string remedy(std::span<const Vec<double>> positions, std::span<const Triangle> triangles) {
    const Shape shape{SimplicialComplex(static_cast<int>(positions.size()),
                                        {{}, {triangles.begin(), triangles.end()}, {}}),
                      {positions.begin(), positions.end()}};
    const std::vector<int> into = weldOf(shape).into;
    int doubled = 0, first = 0;
    for (int v = static_cast<int>(into.size()) - 1; v >= 0; --v)
        if (into[v] != v) ++doubled, first = v;
    if (doubled == 0) return "close or cap them";
    return std::to_string(doubled) + " vertices lie where others do (" + std::to_string(first) +
           " where " + std::to_string(into[first]) + " is): weld them by inspect()";
}

// Of closed loops of edges: each from its lowest vertex on.
std::vector<std::vector<int>> loopsOf(std::vector<Edge> edges) {
    std::ranges::sort(edges);
    std::vector<bool> used(edges.size(), false);
    const auto leaving = [&](int v) {
        auto at = std::ranges::lower_bound(edges, Edge{v, 0}) - edges.begin();
        while (used[at]) ++at;
        return static_cast<std::size_t>(at);
    };
    std::vector<std::vector<int>> loops;
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (used[start]) continue;
        std::vector<int>& loop = loops.emplace_back();
        for (std::size_t at = start;; at = leaving(edges[at][1])) {
            used[at] = true;
            loop.push_back(edges[at][0]);
            if (edges[at][1] == loop[0]) break;
        }
    }
    return loops;
}

// Places of the triangles that hang together by vertices.
std::vector<std::vector<int>> partsOf(std::span<const Triangle> triangles, std::size_t vertices) {
    std::vector<int> root(vertices), part(vertices, -1);
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const auto& [a, b, c] : triangles) {
        root[find(b)] = find(a);
        root[find(c)] = find(a);
    }
    std::vector<std::vector<int>> parts;
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        int& place = part[find(triangles[t][0])];
        if (place < 0) {
            place = static_cast<int>(parts.size());
            parts.emplace_back();
        }
        parts[place].push_back(t);
    }
    return parts;
}

bool flat(std::span<const Vec<double>> positions, std::span<const Triangle> triangles) {
    constexpr double least = 1e-9;  // of the volume that its area could hold
    const double size = area(positions, triangles);
    return std::fabs(volume(positions, triangles)) <= least * size * std::sqrt(size);
}

// One part, faced, and closed where asked.
struct Closed {
    std::vector<Triangle> triangles;
    Openings left;
};

Closed closed(std::span<const Vec<double>> positions, const std::vector<Triangle>& given,
              bool cap) {
    Closed part{given, {}};
    faceOutward(positions, part.triangles);
    if (cap && openingsOf(part.triangles).twisted.empty()) {
        for (const auto& fan : fansOver(part.triangles))
            part.triangles.insert(part.triangles.end(), fan.begin(), fan.end());
        faceOutward(positions, part.triangles);
    }
    std::size_t turned = 0;
    for (std::size_t t = 0; t < given.size(); ++t) turned += part.triangles[t] != given[t];
    if (flat(positions, part.triangles) && 2 * turned > given.size())
        for (Triangle& t : part.triangles) std::swap(t[1], t[2]);
    part.left = openingsOf(part.triangles);
    return part;
}

void checkIndices(const std::string& name, std::span<const Triangle> triangles,
                  std::size_t vertices) {
    if (triangles.empty()) throw std::invalid_argument(name + ": no triangles, no volume");
    for (const Triangle& t : triangles)
        for (const int v : t)
            if (v < 0 || v >= static_cast<int>(vertices))
                throw std::invalid_argument(name + ": no vertex " + std::to_string(v));
}

}  // namespace

Enclosure enclose(std::span<const Vec<double>> positions, std::vector<Triangle> triangles,
                  const EnclosureOptions& options) {
    checkIndices(options.name, triangles, positions.size());
    Enclosure enclosure{std::move(triangles), 0};
    enclosure.skin = enclosure.triangles.size();
    std::vector<Triangle> caps;
    Openings left;
    for (const std::vector<int>& places : partsOf(enclosure.triangles, positions.size())) {
        std::vector<Triangle> given;
        for (const int t : places) given.push_back(enclosure.triangles[t]);
        const Closed part = closed(positions, given, options.cap);
        for (std::size_t i = 0; i < places.size(); ++i)
            enclosure.triangles[places[i]] = part.triangles[i];
        caps.insert(caps.end(), part.triangles.begin() + static_cast<long>(places.size()),
                    part.triangles.end());
        left.open.insert(left.open.end(), part.left.open.begin(), part.left.open.end());
        left.twisted.insert(left.twisted.end(), part.left.twisted.begin(), part.left.twisted.end());
    }
    if (!left.twisted.empty())
        throw std::invalid_argument(options.name + ": the triangles at " + edgesOf(left.twisted) +
                                    " cannot all face outward: " + listed(left.twisted));
    if (!left.open.empty())
        throw std::invalid_argument(options.name + ": not closed along " + edgesOf(left.open) +
                                    ": " + listed(left.open) + "; " +
                                    remedy(positions, enclosure.triangles));
    enclosure.triangles.insert(enclosure.triangles.end(), caps.begin(), caps.end());
    return enclosure;
}

Enclosure enclose(const World& world, const std::vector<Range>& objects,
                  const EnclosureOptions& options) {
    std::vector<Triangle> triangles;
    for (const Range& object : objects) {
        const std::vector<int> ids = triangleStencils(world.complex, object);
        for (std::size_t i = 0; i < ids.size(); i += 3)
            triangles.push_back({ids[i], ids[i + 1], ids[i + 2]});
    }
    return enclose(world.rest, std::move(triangles), options);
}

std::vector<std::vector<Triangle>> fansOver(std::span<const Triangle> triangles) {
    std::vector<std::vector<Triangle>> fans;
    for (const std::vector<int>& loop : loopsOf(openingsOf(triangles).open)) {
        std::vector<Triangle>& fan = fans.emplace_back();
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            fan.push_back({loop[0], loop[i + 1], loop[i]});
    }
    return fans;
}

double volume(const Enclosure& enclosure, std::span<const Vec<double>> positions) {
    return volume(positions, enclosure.triangles);
}

}  // namespace plait
