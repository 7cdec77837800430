#include "analysis.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

constexpr int perVertex = 3;
constexpr double shareOfSubtree = 1.0 / 24;  // of the work, at most: enough for threads to share

int stripsFor(std::size_t vertices) {
    return (perVertex * static_cast<int>(vertices) + stripRows - 1) / stripRows;
}

void check(std::span<const Vec<double>> rest, std::span<const int> edges,
           std::span<const unsigned char> pinned) {
    if (pinned.size() != rest.size())
        throw std::invalid_argument("as many marks of pinned vertices as vertices are wanted");
    if (edges.size() % 2) throw std::invalid_argument("edges come in pairs of vertices");
    for (const int v : edges)
        if (v < 0 || v >= static_cast<int>(rest.size()))
            throw std::invalid_argument("an edge names vertex " + std::to_string(v) + " of " +
                                        std::to_string(rest.size()));
    for (const Vec<double>& x : rest)
        if (!std::isfinite(x.x + x.y + x.z))
            throw std::invalid_argument("a rest position is not finite");
}

// Edges at each vertex that is not pinned.
Csr edgesAt(std::span<const int> edges, std::span<const unsigned char> pinned) {
    Csr at;
    at.start.assign(pinned.size() + 1, 0);
    const auto eachEnd = [&](auto visit) {
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (edges[i] != edges[i ^ 1] && !pinned[edges[i]])
                visit(edges[i], static_cast<int>(i / 2));
    };
    eachEnd([&](int v, int) { ++at.start[v + 1]; });
    std::partial_sum(at.start.begin(), at.start.end(), at.start.begin());
    at.item.resize(at.start.back());
    std::vector<int> next(at.start.begin(), at.start.end() - 1);
    eachEnd([&](int v, int edge) { at.item[next[v]++] = edge; });
    return at;
}

class Analysis {
public:
    Analysis(std::span<const Vec<double>> rest, std::span<const int> edges,
             std::span<const unsigned char> pinned, int leaf)
        : edges_(edges), edgesAt_(edgesAt(edges, pinned)) {
        Csr neighbours = edgesAt_;
        std::vector<int> vertices;
        for (int v = 0; v < neighbours.size(); ++v) {
            if (!pinned[v]) vertices.push_back(v);
            for (int i = neighbours.start[v]; i < neighbours.start[v + 1]; ++i)
                neighbours.item[i] = other(neighbours.item[i], v);
        }
        Dissection dissection = dissect(rest, neighbours, std::move(vertices), leaf);
        out.order = std::move(dissection.order);
        position_.assign(rest.size(), -1);
        for (std::size_t p = 0; p < out.order.size(); ++p)
            position_[out.order[p]] = static_cast<int>(p);
        out.children.resize(dissection.parts.size());
        for (const Part& part : dissection.parts) addFront(part);
        for (Front& front : out.fronts) placeInParent(front);
        placeIncidences();
        cutTree();
        placeComplements();
    }

    Fronts out;

private:
    int other(int edge, int v) const {
        return edges_[2 * edge] == v ? edges_[2 * edge + 1] : edges_[2 * edge];
    }

    void addFront(const Part& part) {
        const int index = static_cast<int>(out.fronts.size());
        Front front{};
        front.begin = part.begin, front.end = part.end, front.parent = part.parent;
        if (part.parent >= 0) out.children[part.parent].push_back(index);
        std::vector<int>& boundary = front.boundary;
        for (int p = part.begin; p < part.end; ++p)
            for (const int edge : edgesAt_[out.order[p]])
                boundary.push_back(position_[other(edge, out.order[p])]);
        for (const int child : out.children[index])
            boundary.insert(boundary.end(), out.fronts[child].boundary.begin(),
                            out.fronts[child].boundary.end());
        std::erase_if(boundary, [&](int p) { return p < part.end; });
        std::sort(boundary.begin(), boundary.end());
        boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());

        front.pivotStrips = stripsFor(static_cast<std::size_t>(part.end - part.begin));
        front.boundaryStrips = stripsFor(boundary.size());
        const int strips = front.pivotStrips + front.boundaryStrips;
        front.panel = out.panelColumns;
        front.rows = out.rows;
        out.panelColumns += columnsBefore(front.pivotStrips, strips);
        out.rows += static_cast<long>(strips) * stripRows;
        const double k = front.pivotStrips, b = front.boundaryStrips;
        front.work = k * k * k / 6 + k * k * b / 2 + k * b * b / 2;
        for (const int child : out.children[index]) front.work += out.fronts[child].work;
        out.fronts.push_back(std::move(front));
    }

    // First row of a vertex in a front that has it.
    static int rowIn(const Front& front, int position) {
        if (position < front.end) return perVertex * (position - front.begin);
        const auto at = std::lower_bound(front.boundary.begin(), front.boundary.end(), position);
        return front.pivotStrips * stripRows +
               perVertex * static_cast<int>(at - front.boundary.begin());
    }

    void placeInParent(Front& front) {
        if (front.parent < 0) return;
        const Front& parent = out.fronts[front.parent];
        const int parentPivotRows = parent.pivotStrips * stripRows;
        for (const int p : front.boundary)
            for (int r = 0; r < perVertex; ++r) front.inParent.push_back(rowIn(parent, p) + r);
        const auto columnsBelow = [&](int row) {
            return static_cast<int>(
                std::lower_bound(front.inParent.begin(), front.inParent.end(), row) -
                front.inParent.begin());
        };
        front.parentPivots = columnsBelow(parentPivotRows);
        const int rows = static_cast<int>(front.inParent.size());
        for (int row = 0; row < rows; ++row) {
            const int strip = front.inParent[row] / stripRows,
                      lane = front.inParent[row] % stripRows;
            const bool begins = row % stripRows == 0;
            if (begins) front.firstOverlap.push_back(static_cast<int>(front.overlaps.size()));
            if (begins || front.overlaps.back().strip != strip) {
                const int kept = std::min(rows, (row / stripRows + 1) * stripRows);
                front.overlaps.push_back(
                    {strip, std::min(kept, columnsBelow((strip + 1) * stripRows)), 0, {}});
            }
            Overlap& overlap = front.overlaps.back();
            overlap.mask = static_cast<unsigned short>(overlap.mask | 1U << lane);
            overlap.lane[lane] = static_cast<unsigned char>(row % stripRows);
        }
        front.firstOverlap.push_back(static_cast<int>(front.overlaps.size()));
    }

    void placeIncidences() {
        out.firstIncidence.push_back(0);
        for (const Front& front : out.fronts)
            for (int p = front.begin; p < front.end; ++p) {
                for (const int edge : edgesAt_[out.order[p]]) {
                    const int q = position_[other(edge, out.order[p])];
                    out.incidences.push_back({edge, q > p ? rowIn(front, q) : -1});
                }
                out.firstIncidence.push_back(static_cast<int>(out.incidences.size()));
            }
    }

    // What is larger than its share of the work is solved by all threads together, from the leaves
    // up.
    void cutTree() {
        double work = 0;
        for (const Front& front : out.fronts)
            if (front.parent < 0) work += front.work;
        const auto together = [&](int f) { return out.fronts[f].work > shareOfSubtree * work; };
        level_.assign(out.fronts.size(), -1);
        int begin = 0;
        for (int f = 0; f < static_cast<int>(out.fronts.size()); ++f) {
            if (together(f)) {
                for (const int child : out.children[f])
                    level_[f] = std::max(level_[f], level_[child]);
                ++level_[f];
                out.levels.resize(std::max<std::size_t>(out.levels.size(), level_[f] + 1));
                out.levels[level_[f]].push_back(f);
                begin = f + 1;
            } else if (const int parent = out.fronts[f].parent; parent < 0 || together(parent)) {
                out.subtrees.push_back({begin, f + 1});
                begin = f + 1;
            }
        }
    }

    // A Schur complement lives until its parent is done. Within a subtree those of one family lie
    // side by side and every generation has its own place, which the next family takes over.
    void placeComplements() {
        for (const Subtree& subtree : out.subtrees) {
            std::vector<long> sizes;  // by generation
            measureFamilies(subtree.end - 1, 0, sizes);
            std::vector<long> starts(sizes.size() + 1, 0);
            std::partial_sum(sizes.begin(), sizes.end(), starts.begin() + 1);
            placeFamilies(subtree.end - 1, 0, starts);
            out.threadColumns = std::max(out.threadColumns, starts.back());
            placeOwn(out.fronts[subtree.end - 1]);
        }
        for (const auto& level : out.levels)
            for (const int f : level) placeOwn(out.fronts[f]);
    }

    void placeOwn(Front& front) {
        front.ownMemory = true;
        front.schur = out.ownColumns;
        out.ownColumns += columnsBefore(front.boundaryStrips);
    }

    void measureFamilies(int parent, std::size_t generation, std::vector<long>& sizes) const {
        if (out.children[parent].empty()) return;
        if (sizes.size() <= generation) sizes.push_back(0);
        long size = 0;
        for (const int child : out.children[parent]) {
            size += columnsBefore(out.fronts[child].boundaryStrips);
            measureFamilies(child, generation + 1, sizes);
        }
        sizes[generation] = std::max(sizes[generation], size);
    }

    void placeFamilies(int parent, std::size_t generation, const std::vector<long>& starts) {
        long at = starts[generation];
        for (const int child : out.children[parent]) {
            out.fronts[child].schur = at;
            at += columnsBefore(out.fronts[child].boundaryStrips);
            placeFamilies(child, generation + 1, starts);
        }
    }

    std::span<const int> edges_;
    Csr edgesAt_;
    std::vector<int> position_;  // in the order of elimination, by vertex; -1 if pinned
    std::vector<int> level_;     // by front; -1 within a subtree
};

}  // namespace

Fronts analyse(std::span<const Vec<double>> rest, std::span<const int> edges,
               std::span<const unsigned char> pinned, int leaf) {
    check(rest, edges, pinned);
    Analysis analysis(rest, edges, pinned, std::max(leaf, 1));
    return std::move(analysis.out);
}

}  // namespace plait
