#include "inspect.h"

#include "../measure/surfaces/box_tree.h"
#include "../measure/surfaces/gap.h"
#include "../measure/surfaces/intersections.h"
#include "facing.h"
#include "weld.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace plait {
namespace {

using Edge = std::array<int, 2>;
using Triangle = std::array<int, 3>;

std::string shortly(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number);
    return text;
}

// "vertex 7 is", "12 vertices, the first 7, are".
std::string counted(std::size_t count, const std::string& first) {
    return count == 1 ? "vertex " + first + " is"
                      : std::to_string(count) + " vertices, the first " + first + ", are";
}

std::vector<Triangle> trianglesOf(const SimplicialComplex& complex) {
    std::vector<Triangle> triangles;
    for (int t = 0; t < complex.count(2); ++t) triangles.push_back(complex.triangle(t));
    return triangles;
}

double doubleArea(const std::vector<Vec<double>>& x, std::span<const int> v) {
    return length(cross(x[v[1]] - x[v[0]], x[v[2]] - x[v[0]]));
}

// As good as none, of its longest side.
bool hasNoArea(const std::vector<Vec<double>>& x, std::span<const int> v) {
    const double side =
        std::max({length(x[v[1]] - x[v[0]]), length(x[v[2]] - x[v[1]]), length(x[v[0]] - x[v[2]])});
    return !(doubleArea(x, v) > 1e-9 * side * side);
}

class Inspection {
public:
    Inspection(Shape mesh, const std::filesystem::path& file, const MeshWanted& wanted)
        : wanted_(wanted) {
        mesh_.file = file;
        mesh_.vertices.resize(mesh.positions.size());
        std::iota(mesh_.vertices.begin(), mesh_.vertices.end(), 0);
        mesh_.shape = std::move(mesh);
    }

    InspectedMesh all() {
        leaveOutUnused();
        checkSize();
        weld();
        checkEdges();
        checkAreas();
        if (wanted_.solid) checkSolid();
        return std::move(mesh_);
    }

private:
    const SimplicialComplex& complex() const { return mesh_.shape.complex; }
    std::string name(int v) const { return mesh_.name(v); }
    std::string edgeName(const Edge& edge) const {
        return "from vertex " + name(edge[0]) + " to " + name(edge[1]);
    }
    void warn(const std::string& cause) { mesh_.warnings.push_back(mesh_.told(cause)); }
    [[noreturn]] void refuse(const std::string& cause) const {
        throw std::invalid_argument(mesh_.told(cause));
    }

    // Keeps the vertices that stand for themselves, and what is left of the simplices: none that
    // has a vertex twice.
    void keep(const std::vector<int>& into) {
        std::vector<int> place(into.size(), -1), vertices;
        std::vector<Vec<double>> positions;
        for (int v = 0; v < static_cast<int>(into.size()); ++v) {
            if (into[v] != v) continue;
            place[v] = static_cast<int>(vertices.size());
            vertices.push_back(mesh_.vertices[v]);
            positions.push_back(mesh_.shape.positions[v]);
        }
        const auto placeOf = [&](int v) { return place[into[v]]; };
        Simplices simplices;
        for (const auto& [a, b, c] : trianglesOf(complex())) {
            const Triangle t{placeOf(a), placeOf(b), placeOf(c)};
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) simplices.triangles.push_back(t);
        }
        const std::vector<int> valences = complex().valences(1);
        for (int e = 0; e < complex().count(1); ++e) {
            const auto [a, b] = complex().edge(e);
            if (valences[e] == 0 && placeOf(a) != placeOf(b))
                simplices.edges.push_back({placeOf(a), placeOf(b)});
        }
        mesh_.shape = {SimplicialComplex(static_cast<int>(vertices.size()), simplices),
                       std::move(positions)};
        mesh_.vertices = std::move(vertices);
    }

    void leaveOutUnused() {
        const std::vector<int> valences = complex().valences(0);
        std::vector<int> into(valences.size(), -1), unused;
        for (int v = 0; v < static_cast<int>(valences.size()); ++v)
            if (valences[v] > 0)
                into[v] = v;
            else
                unused.push_back(v);
        if (complex().count(2) == 0) refuse("no triangles in it");
        if (unused.empty()) return;
        warn(counted(unused.size(), name(unused[0])) + " on no triangle or edge and left out");
        keep(into);
    }

    void checkSize() const {
        if (wanted_.most == 0) return;
        const auto [low, high] = boxOf(mesh_.shape.positions);
        const Vec<double> box = high - low;
        const double size = wanted_.solid ? box.y : std::max({box.x, box.y, box.z});
        if (size >= wanted_.least && size <= wanted_.most) return;
        const std::string found = shortly(size) + (wanted_.solid ? " m tall" : " m across") +
                                  ", where " + shortly(wanted_.least) + " to " +
                                  shortly(wanted_.most) + " m are of use";
        if (wanted_.solid && box.z > box.y && box.z >= wanted_.least && box.z <= wanted_.most)
            refuse(found + ": is z up?");
        refuse(found + unitOf(size));
    }

    // In which it would be most nearly of the usual size.
    std::string unitOf(double size) const {
        constexpr std::pair<double, const char*> units[] = {{0.001, "millimetres"},
                                                            {0.01, "centimetres"},
                                                            {0.0254, "inches"},
                                                            {0.3048, "feet"},
                                                            {1000, "kilometres"}};
        const auto off = [&](const auto& unit) {
            return std::fabs(std::log(size * unit.first / wanted_.usual));
        };
        const auto& best = *std::ranges::min_element(units, {}, off);
        const double there = size * best.first;
        return there >= wanted_.least && there <= wanted_.most
                   ? std::string(": is it in ") + best.second + "?"
                   : "";
    }

    void weld() {
        const Weld weld = weldOf(mesh_.shape);
        if (!weld.apart.empty()) {
            const auto [a, b] = weld.apart[0];
            warn(counted(weld.apart.size(), name(a)) + " nearly where others are (" + name(b) +
                 ", " +
                 shortly(1000 * length(mesh_.shape.positions[a] - mesh_.shape.positions[b])) +
                 " mm off) and not welded");
        }
        int count = 0, first = -1;
        for (int v = static_cast<int>(weld.into.size()) - 1; v >= 0; --v)
            if (weld.into[v] != v) ++count, first = v;
        if (count == 0) return;
        warn(counted(static_cast<std::size_t>(count), name(first)) + " where others are (" +
             name(weld.into[first]) + ") and welded");
        keep(weld.into);
    }

    void checkEdges() {
        const std::vector<int> valences = complex().valences(1);
        const auto isMany = [](int triangles) { return triangles > 2; };
        const auto first = std::ranges::find_if(valences, isMany);
        if (first == valences.end()) return;
        const int e = static_cast<int>(first - valences.begin());
        warn(std::to_string(std::ranges::count_if(valences, isMany)) +
             " edges of more than two triangles, the first " + edgeName(complex().edge(e)));
    }

    void checkAreas() {
        const std::vector<Vec<double>>& x = mesh_.shape.positions;
        std::vector<bool> weighs(x.size(), false);
        int count = 0, first = -1;
        for (int t = complex().count(2) - 1; t >= 0; --t) {
            const auto v = complex().vertices(2, t);
            if (hasNoArea(x, v))
                ++count, first = t;
            else
                for (const int corner : v) weighs[corner] = true;
        }
        if (count == 0) return;
        const auto v = complex().vertices(2, first);
        warn((count == 1 ? "a triangle" : std::to_string(count) + " triangles") +
             " without area, " + (count == 1 ? "of" : "the first of") + " vertices " + name(v[0]) +
             ", " + name(v[1]) + " and " + name(v[2]));
        if (wanted_.solid) return;
        const std::vector<int> valences = complex().valences(1);
        for (int e = 0; e < complex().count(1); ++e)
            if (valences[e] == 0)
                for (const int end : complex().vertices(1, e)) weighs[end] = true;
        const auto none = std::ranges::find(weighs, false);
        if (none != weighs.end())
            refuse("vertex " + name(static_cast<int>(none - weighs.begin())) +
                   " has no mass: its triangles have no area");
    }

    void checkSolid() {
        std::vector<Triangle> triangles = trianglesOf(complex());
        const int turned = faceOutward(mesh_.shape.positions, triangles);
        if (const auto opening = openingOf(triangles)) {
            const std::string where =
                std::to_string(opening->count) + " edges, the first " + edgeName(opening->edge);
            refuse(opening->open ? "not closed: open at " + where
                                 : "its triangles cannot all face outward: they meet the wrong way "
                                   "round at " +
                                       where);
        }
        if (turned == 0) return;
        warn(std::to_string(turned) + " of its " + std::to_string(triangles.size()) +
             " triangles faced inward and were turned");
        mesh_.shape.complex = SimplicialComplex(complex().count(0), {{}, triangles, {}});
    }

    MeshWanted wanted_;
    InspectedMesh mesh_;
};

}  // namespace

std::string InspectedMesh::told(const std::string& cause) const {
    return file.string() + ": " + cause;
}

std::string InspectedMesh::name(int vertex) const {
    const std::string extension = file.extension().string();
    const bool fromOne = extension.size() == 4 && (extension[1] == 'o' || extension[1] == 'O');
    return std::to_string(vertices[vertex] + (fromOne ? 1 : 0));
}

InspectedMesh inspect(Shape mesh, const std::filesystem::path& file, const MeshWanted& wanted) {
    return Inspection(std::move(mesh), file, wanted).all();
}

void refuseCrossing(const InspectedMesh& mesh, std::span<const Vec<double>> positions) {
    const SimplicialComplex& complex = mesh.shape.complex;
    const std::vector<Triangle> triangles = trianglesOf(complex);
    std::vector<Edge> edges;
    for (int e = 0; e < complex.count(1); ++e) edges.push_back(complex.edge(e));
    const auto name = [&](int v) { return mesh.name(v); };
    const auto crossings = findIntersections(positions, edges, triangles);
    if (!crossings.empty()) {
        const auto [e, t] = crossings[0];
        const auto& [a, b] = edges[e];
        const auto& [i, j, k] = triangles[t];
        throw std::invalid_argument(
            mesh.told("it crosses itself at the start, in " + std::to_string(crossings.size()) +
                      " places, the first the edge from vertex " + name(a) + " to " + name(b) +
                      " through the triangle of " + name(i) + ", " + name(j) + " and " + name(k)));
    }
    const auto [low, high] = boxOf(positions);
    const double nothing = 1e-7 * length(high - low);
    const Gap gap = nearest(positions, triangles, nothing);
    if (gap.distance < nothing)
        throw std::invalid_argument(mesh.told("it lies on itself at the start, at vertices " +
                                              name(gap.vertices[0]) + " and " +
                                              name(gap.vertices[1])));
}

}  // namespace plait
