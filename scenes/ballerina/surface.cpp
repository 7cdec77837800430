#include "surface.h"

#include <cstdlib>

namespace plait::dancer {
namespace {

using Triangle = std::array<int, 3>;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// How long an edge should be here: short at the neckline, fingers, face and shoes.
double edgeLength(const Point& p) {
    const double x = p.x < 0 ? -p.x : p.x;
    double l = 0.0165;
    l += (0.0115 - l) * step(p.y, 1.21, 1.25) * (1 - step(x, 0.14, 0.20));
    l += (0.0078 - l) * step(x, 0.55, 0.66);
    l += (0.0078 - l) * step(p.y, 1.40, 1.52);
    return l + (0.0105 - l) * step(-p.y, -0.22, -0.10);
}

Point projected(const Point& p) {
    const Point g = slope(p);
    return p - (field(p) / dot(g, g)) * g;
}

// Triangles with the vertices' own lists of them; the dead have a negative vertex.
class Mesh {
public:
    explicit Mesh(Surface& surface)
        : x_(surface.positions), triangles_(surface.triangles), around_(x_.size()) {
        for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
            for (const int v : triangles_[index(t)]) around_[index(v)].push_back(t);
    }

    bool collapse() {
        bool any = false;
        for (int a = 0; a < static_cast<int>(x_.size()); ++a)
            for (bool again = true; again;) {
                again = false;
                for (const int b : neighbours(a)) {
                    const Point middle = 0.5 * (x_[index(a)] + x_[index(b)]);
                    if (length(x_[index(a)] - x_[index(b)]) > 0.75 * edgeLength(middle)) continue;
                    if (!collapseEdge(a, b, middle)) continue;
                    any = again = true;
                    break;
                }
            }
        return any;
    }

    // Edges turned so that vertices have six neighbours.
    void flip() {
        for (int a = 0; a < static_cast<int>(x_.size()); ++a)
            for (const int b : neighbours(a))
                if (a < b) flipEdge(a, b);
    }

    // Each vertex towards the middle of its neighbours, along the surface.
    void relax() {
        std::vector<Point> moved = x_;
        for (int a = 0; a < static_cast<int>(x_.size()); ++a) {
            const std::vector<int> near = neighbours(a);
            if (near.empty()) continue;
            Point sum{0, 0, 0};
            for (const int b : near) sum += x_[index(b)];
            const Point d = (1.0 / static_cast<double>(near.size())) * sum - x_[index(a)];
            Point n{0, 0, 0};
            for (const int t : around_[index(a)]) n += normal(triangles_[index(t)]);
            n = unit(n);
            moved[index(a)] = projected(x_[index(a)] + 0.6 * (d - dot(d, n) * n));
        }
        x_ = moved;
    }

    // Vertices close to where hair or clothes end come to lie there.
    void sew() {
        for (std::size_t v = 0; v < x_.size(); ++v) {
            if (around_[v].empty()) continue;
            const bool right = x_[v].x < 0;
            Point p = right ? mirrored(x_[v]) : x_[v];
            const auto edge = p.y > 1.49 ? hair : p.y > 1.2 && p.x < 0.2 ? bodice : shoe;
            if (edge == shoe && p.y > 0.2) continue;
            for (int i = 0; i < 3; ++i) {
                constexpr double h = 1e-5;
                const double here = edge(p);
                Point g = (1 / h) * Point{edge(p + Point{h, 0, 0}) - here,
                                          edge(p + Point{0, h, 0}) - here,
                                          edge(p + Point{0, 0, h}) - here};
                const Point n = unit(slope(p));
                g -= dot(g, n) * n;
                const Point d = -(here / dot(g, g)) * g;
                if (!(length(d) < 0.42 * edgeLength(p))) break;
                p = projected(p + d);
            }
            if (right) p = mirrored(p);
            const bool kept = std::all_of(around_[v].begin(), around_[v].end(),
                                          [&](int t) { return keeps(t, static_cast<int>(v), p); });
            if (kept) x_[v] = p;
        }
    }

    // Drops the dead.
    void pack() {
        std::vector<int> names(x_.size(), -1);
        std::vector<Point> kept;
        for (std::size_t v = 0; v < x_.size(); ++v) {
            if (around_[v].empty()) continue;
            names[v] = static_cast<int>(kept.size());
            kept.push_back(x_[v]);
        }
        std::erase_if(triangles_, [](const Triangle& t) { return t[0] < 0; });
        for (Triangle& t : triangles_)
            for (int& v : t) v = names[index(v)];
        x_ = kept;
    }

private:
    std::vector<int> neighbours(int a) const {
        std::vector<int> near;
        for (const int t : around_[index(a)])
            for (const int v : triangles_[index(t)])
                if (v != a) near.push_back(v);
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        return near;
    }

    std::vector<int> shared(int a, int b) const {
        std::vector<int> both;
        for (const int t : around_[index(a)])
            if (std::count(triangles_[index(t)].begin(), triangles_[index(t)].end(), b) > 0)
                both.push_back(t);
        return both;
    }

    Point normal(const Triangle& t) const {
        const Point& a = x_[index(t[0])];
        return cross(x_[index(t[1])] - a, x_[index(t[2])] - a);
    }

    // Whether triangle t keeps its side, and stays small, with a vertex of it moved.
    bool keeps(int t, int v, const Point& to) const {
        const Triangle& old = triangles_[index(t)];
        std::array<Point, 3> p{x_[index(old[0])], x_[index(old[1])], x_[index(old[2])]};
        for (std::size_t k = 0; k < 3; ++k)
            if (old[k] == v) p[k] = to;
        for (std::size_t k = 0; k < 3; ++k)
            if (length(p[k] - p[(k + 1) % 3]) > 1.35 * edgeLength(to)) return false;
        const Point n = cross(p[1] - p[0], p[2] - p[0]), before = normal(old);
        return dot(n, before) > 0.7 * length(n) * length(before);
    }

    bool collapseEdge(int a, int b, const Point& middle) {
        const std::vector<int> both = shared(a, b);
        const std::vector<int> nearA = neighbours(a), nearB = neighbours(b);
        std::vector<int> common;
        std::set_intersection(nearA.begin(), nearA.end(), nearB.begin(), nearB.end(),
                              std::back_inserter(common));
        if (both.size() != 2 || common.size() != 2) return false;
        for (const int v : common)
            if (around_[index(v)].size() < 5) return false;
        if (nearA.size() + nearB.size() > 13) return false;
        const Point to = projected(middle);
        for (const int v : {a, b})
            for (const int t : around_[index(v)])
                if (std::count(both.begin(), both.end(), t) == 0 && !keeps(t, v, to)) return false;
        for (const int t : both) {
            for (const int v : triangles_[index(t)]) std::erase(around_[index(v)], t);
            triangles_[index(t)] = {-1, -1, -1};
        }
        for (const int t : around_[index(b)]) {
            std::replace(triangles_[index(t)].begin(), triangles_[index(t)].end(), b, a);
            around_[index(a)].push_back(t);
        }
        around_[index(b)].clear();
        x_[index(a)] = to;
        return true;
    }

    void flipEdge(int a, int b) {
        const std::vector<int> both = shared(a, b);
        if (both.size() != 2) return;
        // Along the first triangle the edge runs from `from` to `to`.
        const Triangle first = triangles_[index(both[0])], second = triangles_[index(both[1])];
        std::size_t k = 0;
        while (first[k] == a || first[k] == b) ++k;
        const int c = first[k], from = first[(k + 1) % 3], to = first[(k + 2) % 3];
        k = 0;
        while (second[k] == a || second[k] == b) ++k;
        const int d = second[k];
        if (!shared(c, d).empty()) return;
        const auto over = [&](int v) { return static_cast<int>(around_[index(v)].size()) - 6; };
        const int now =
            std::abs(over(a)) + std::abs(over(b)) + std::abs(over(c)) + std::abs(over(d));
        const int then = std::abs(over(a) - 1) + std::abs(over(b) - 1) + std::abs(over(c) + 1) +
                         std::abs(over(d) + 1);
        if (then >= now) return;
        const Triangle one{c, from, d}, other{d, to, c};
        const Point n1 = normal(one), n2 = normal(other);
        const Point before = normal(first) + normal(second);
        for (const Point& n : {n1, n2})
            if (dot(n, before) < 0.8 * length(n) * length(before)) return;
        triangles_[index(both[0])] = one;
        triangles_[index(both[1])] = other;
        std::erase(around_[index(to)], both[0]);
        std::erase(around_[index(from)], both[1]);
        around_[index(d)].push_back(both[0]);
        around_[index(c)].push_back(both[1]);
    }

    std::vector<Point>& x_;
    std::vector<Triangle>& triangles_;
    std::vector<std::vector<int>> around_;
};

}  // namespace

void coarsen(Surface& surface) {
    Mesh mesh(surface);
    for (int pass = 0; pass < 6; ++pass) {
        mesh.collapse();
        mesh.flip();
        mesh.relax();
    }
    for (int pass = 0; pass < 4; ++pass) {
        mesh.flip();
        mesh.relax();
    }
    mesh.sew();
    mesh.pack();
}

}  // namespace plait::dancer
