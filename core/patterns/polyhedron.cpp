#include "polyhedron.h"

#include <algorithm>
#include <array>
#include <map>

namespace plait {

Polyhedron::Polyhedron(const Vec<double>& centre, double halfSide) {
    for (int i = 0; i < 8; ++i)
        corners_.push_back(centre + halfSide * Vec<double>{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0,
                                                           i & 4 ? 1.0 : -1.0});
    for (const auto& [a, b, c, d] : {std::array{0, 4, 6, 2},
                                     {1, 3, 7, 5},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 2, 3, 1},
                                     {4, 5, 7, 6}})
        faces_.push_back({{a, b, c, d}, -1});
}

void Polyhedron::cutOff(const HalfSpace& plane, int name, double slack) {
    std::vector<double> out;
    for (const Vec<double>& x : corners_) out.push_back(dot(plane.normal, x) - plane.offset);
    double farthest = 0;
    for (const Face& face : faces_)
        for (const int v : face.corners) farthest = std::max(farthest, out[v]);
    if (farthest <= slack) return;
    // One new corner on each edge that is cut, whichever face asks for it.
    std::map<std::pair<int, int>, int> made;
    const auto between = [&](int a, int b) {
        const auto [at, isNew] = made.try_emplace(std::minmax(a, b), std::ssize(corners_));
        if (isNew) {
            const auto& [low, high] = at->first;
            const double t = out[low] / (out[low] - out[high]);
            corners_.push_back(corners_[low] + t * (corners_[high] - corners_[low]));
        }
        return at->second;
    };
    std::vector<Face> left;
    std::map<int, int> next;  // of the new face, against the way of its neighbours
    for (const Face& face : faces_) {
        Face rest{.corners = {}, .plane = face.plane};
        int leaves = -1, enters = -1;
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const int a = face.corners[i], b = face.corners[(i + 1) % face.corners.size()];
            if (out[a] <= 0) rest.corners.push_back(a);
            if ((out[a] <= 0) == (out[b] <= 0)) continue;
            rest.corners.push_back(between(a, b));
            (out[a] <= 0 ? leaves : enters) = rest.corners.back();
        }
        if (rest.corners.size() > 2) left.push_back(std::move(rest));
        if (leaves >= 0) next[enters] = leaves;
    }
    faces_ = std::move(left);
    if (next.empty()) return;  // nothing is left
    Face face{.corners = {}, .plane = name};
    for (int v = next.begin()->first; face.corners.size() < next.size(); v = next[v])
        face.corners.push_back(v);
    faces_.push_back(std::move(face));
}

double Polyhedron::reach(const Vec<double>& from) const {
    double farthest = 0;
    for (const Face& face : faces_)
        for (const int v : face.corners) farthest = std::max(farthest, length(corners_[v] - from));
    return farthest;
}

Shape Polyhedron::shape() const {
    Shape shape;
    std::vector<int> place(corners_.size(), -1);
    Simplices simplices;
    for (const Face& face : faces_) {
        std::vector<int> own;
        for (const int v : face.corners) {
            if (place[v] < 0) {
                place[v] = static_cast<int>(shape.positions.size());
                shape.positions.push_back(corners_[v]);
            }
            own.push_back(place[v]);
        }
        for (std::size_t i = 2; i < own.size(); ++i)
            simplices.triangles.push_back({own[0], own[i - 1], own[i]});
    }
    shape.complex = SimplicialComplex(static_cast<int>(shape.positions.size()), simplices);
    return shape;
}

}  // namespace plait
