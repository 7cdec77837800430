#include "inextensible.h"

#include "stencils.h"
#include "strands.h"
#include "tethers.h"

#include <algorithm>

namespace plait {
namespace {

// Tied to pins wherever they move.
Rows<Tether> tethersIn(const World& world, Range sheet) {
    std::vector<int> pinned;
    for (int v = sheet.first; v < sheet.last; ++v)
        if (world.pinned[static_cast<std::size_t>(v)]) pinned.push_back(v);
    Tethers tethers = tethersOf(world.complex, sheet, world.rest, pinned);
    for (std::size_t i = 0; i < tethers.anchors.size(); ++i)
        tethers.set.rows[i].anchor = world.start[static_cast<std::size_t>(tethers.anchors[i])];
    std::vector<World::Pins> moving;
    for (const World::Pins& pins : world.pins)
        if (pins.animation) moving.push_back(pins);
    if (moving.empty()) return std::move(tethers.set);
    tethers.set.animate = [moving, anchors = tethers.anchors, start = world.start, at = world.start,
                           some = std::vector<Vec<double>>()](
                              double t, std::span<Tether::Row<double>> rows) mutable {
        for (const World::Pins& pins : moving) {
            some.clear();
            for (const int v : pins.vertices) some.push_back(start[static_cast<std::size_t>(v)]);
            pins.animation(t, some);
            for (std::size_t i = 0; i < some.size(); ++i)
                at[static_cast<std::size_t>(pins.vertices[i])] = some[i];
        }
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].anchor = at[static_cast<std::size_t>(anchors[i])];
    };
    return std::move(tethers.set);
}

// Strand by strand, so that colours are of one direction each. In the order of the complex, where
// directions mix, the same work leaves half as much strain again.
Rows<Stretch> edgesOf(std::span<const Strand> strands, const Rows<Stretch>& edges) {
    Rows<Stretch> set;
    for (const Strand& strand : strands)
        for (const int l : strand.links) {
            const auto i = static_cast<std::size_t>(l);
            set.ids.insert(set.ids.end(), {edges.ids[2 * i], edges.ids[2 * i + 1]});
            set.rows.push_back(edges.rows[i]);
        }
    return set;
}

// Puts those that hold the sheet first and returns how many they are: the longest, while one has a
// vertex that is not yet in two. On a grid they are its rows and columns. A diagonal left to the
// sweeps keeps its length better than one that is solved whole, too, where the sheet folds.
std::size_t putThreadsFirst(std::vector<Strand>& strands, std::size_t vertices) {
    std::vector<int> count(vertices, 0);
    const auto holds = [&](const Strand& strand) {
        const auto open = [&](int v) { return count[static_cast<std::size_t>(v)] < 2; };
        const bool any = std::any_of(strand.vertices.begin(), strand.vertices.end(), open);
        for (const int v : strand.vertices) count[static_cast<std::size_t>(v)] += any;
        return any;
    };
    std::vector<Strand> threads, others;
    for (Strand& strand : strands) (holds(strand) ? threads : others).push_back(std::move(strand));
    strands = threads;
    strands.insert(strands.end(), others.begin(), others.end());
    return threads.size();
}

}  // namespace

void holdSheet(World& world, Range sheet, const SheetOptions& options) {
    Rows<Stretch> edges =
        restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest, options.compliance);
    const bool rigid = options.compliance == 0;
    if (options.mending > 0 && rigid)
        world.mend(edges, {.name = "mending", .order = options.order},
                   {.tolerance = options.mending});
    Rows<Stretch> threads;
    if (options.strands) {
        std::vector<Strand> strands = strandsOf(edges.ids, world.rest);
        const std::size_t count = putThreadsFirst(strands, world.rest.size());
        threads = edgesOf(std::span(strands).first(count), edges);
        edges = edgesOf(std::span(strands).subspan(count), edges);
    }
    world.constrain(edges, {.name = "stretch", .order = options.order + 1});
    if (options.strands) world.strand(threads, {.name = "strands", .order = options.order + 2});
    if (options.tethers && rigid)
        world.constrain(tethersIn(world, sheet), {.name = "tethers", .order = options.order + 3});
    if (options.aggregates && rigid)
        world.aggregate(edges, {.name = "aggregates", .order = options.order + 4});
}

}  // namespace plait
