#include "vertex_colors.h"

#include "../../complex/csr.h"

#include <algorithm>

namespace plait {
namespace {

// The constraints at each vertex, of all sets, numbered one after another.
Csr constraintsAt(std::span<const SetStencils> sets, std::size_t vertices) {
    Csr at;
    at.start.assign(vertices + 1, 0);
    for (const SetStencils& set : sets)
        for (const int v : set.ids) ++at.start[v + 1];
    for (std::size_t v = 0; v < vertices; ++v) at.start[v + 1] += at.start[v];
    at.item.resize(at.start.back());
    std::vector<int> end(at.start.begin(), at.start.end() - 1);
    int constraint = 0;
    for (const SetStencils& set : sets)
        for (std::size_t i = 0; i < set.ids.size(); ++i) {
            at.item[end[set.ids[i]]++] = constraint;
            if ((i + 1) % set.arity == 0) ++constraint;
        }
    return at;
}

std::vector<int> colorOfEach(std::span<const SetStencils> sets,
                             std::span<const unsigned char> pinned) {
    const Csr at = constraintsAt(sets, pinned.size());
    std::vector<std::span<const int>> stencils;
    for (const SetStencils& set : sets)
        for (std::size_t i = 0; i < set.ids.size(); i += set.arity)
            stencils.push_back(std::span(set.ids).subspan(i, set.arity));
    std::vector<int> colors(pinned.size(), -1), takenBy;
    for (int v = 0; v < static_cast<int>(pinned.size()); ++v) {
        if (pinned[v] || at[v].empty()) continue;
        for (const int constraint : at[v])
            for (const int neighbour : stencils[constraint])
                if (colors[neighbour] >= 0) takenBy[colors[neighbour]] = v;
        int color = 0;
        while (color < static_cast<int>(takenBy.size()) && takenBy[color] == v) ++color;
        if (color == static_cast<int>(takenBy.size())) takenBy.push_back(-1);
        colors[v] = color;
    }
    return colors;
}

}  // namespace

std::vector<VertexColor> vertexColors(std::span<const SetStencils> sets,
                                      std::span<const unsigned char> pinned) {
    const std::vector<int> colorOf = colorOfEach(sets, pinned);
    std::vector<VertexColor> colors(*std::max_element(colorOf.begin(), colorOf.end()) + 1);
    for (VertexColor& color : colors) color.sets.resize(sets.size());
    for (int v = 0; v < static_cast<int>(colorOf.size()); ++v)
        if (colorOf[v] >= 0) colors[colorOf[v]].vertices.push_back(v);
    for (std::size_t k = 0; k < sets.size(); ++k)
        for (int i = 0; i < static_cast<int>(sets[k].ids.size()); ++i) {
            const int color = colorOf[sets[k].ids[i]];
            if (color < 0) continue;
            colors[color].sets[k].constraints.push_back(i / sets[k].arity);
            colors[color].sets[k].corners.push_back(i % sets[k].arity);
        }
    return colors;
}

}  // namespace plait
