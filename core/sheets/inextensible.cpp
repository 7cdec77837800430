#include "inextensible.h"

#include "../stencils.h"
#include "aggregates/aggregate_set.h"
#include "mend_set.h"
#include "strands/strand_set.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

// Of mending, at most: where the lower edge of 128 x 128 cracks, 60 leave 0.24 % of a tolerance of
// 0.09 %. All are taken in few frames.
constexpr int rounds = 400;

// Tied to pins wherever they move.
Rows<Tether> tethersIn(const World& world, Tethers tethers) {
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

std::vector<int> pinsIn(const World& world, Range sheet) {
    std::vector<int> pins;
    for (int v = sheet.first; v < sheet.last; ++v)
        if (world.pinned[static_cast<std::size_t>(v)]) pins.push_back(v);
    return pins;
}

// Strand by strand, so that colours are of one direction each. In the order of the complex, where
// directions mix, the same work leaves half as much strain again.
std::vector<int> linksIn(std::span<const Strand> strands) {
    std::vector<int> links;
    for (const Strand& strand : strands)
        links.insert(links.end(), strand.links.begin(), strand.links.end());
    return links;
}

Rows<Stretch> chosen(const Rows<Stretch>& edges, std::span<const int> places,
                     const std::vector<bool>& without) {
    Rows<Stretch> set;
    for (const int place : places) {
        const auto i = static_cast<std::size_t>(place);
        if (without[i]) continue;
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
    SheetPlan(world, sheet, options).hold(world);
}

SheetPlan::SheetPlan(const World& world, Range sheet, const SheetOptions& options)
    : options_(options),
      edges_(restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest, options.compliance)),
      isCut_(edges_.rows.size(), false),
      swept_(edges_.rows.size()) {
    for (int e = 0, next = 0; e < world.complex.count(1); ++e) {
        const auto [a, b] = world.complex.edge(e);
        const bool inside = std::min(a, b) >= sheet.first && std::max(a, b) < sheet.last;
        place_.push_back(inside ? next++ : -1);
    }
    std::iota(swept_.begin(), swept_.end(), 0);
    if (options.strands) {
        std::vector<Strand> strands = strandsOf(edges_.ids, world.rest);
        const std::size_t count = putThreadsFirst(strands, world.rest.size());
        threads_ = linksIn(std::span(strands).first(count));
        swept_ = linksIn(std::span(strands).subspan(count));
        strands_ = strandsOf(chosen(edges_, threads_, isCut_).ids, world.rest);
    }
    if (options.compliance != 0) return;
    if (options.tethers) tethers_.emplace(world.complex, sheet, world.rest, pinsIn(world, sheet));
    if (options.aggregates)
        aggregates_.emplace(world.effectiveMass(), world.rest,
                            linksOf(chosen(edges_, swept_, isCut_)), 16);
}

void SheetPlan::cut(std::span<const int> edges) {
    for (const int e : edges)
        if (e < 0 || e >= static_cast<int>(place_.size()) || place_[e] < 0)
            throw std::invalid_argument("cut: the sheet has no edge " + std::to_string(e));
    std::vector<std::array<int, 2>> links;
    for (const int e : edges) {
        isCut_[place_[e]] = true;
        links.push_back({edges_.ids[2 * place_[e]], edges_.ids[2 * place_[e] + 1]});
    }
    if (tethers_) tethers_->cut(edges);
    if (aggregates_) aggregates_->cut(links);
}

void SheetPlan::hold(World& world) const {
    std::vector<int> all(isCut_.size());
    std::iota(all.begin(), all.end(), 0);
    const bool rigid = options_.compliance == 0;
    const int order = options_.order;
    if (options_.mending > 0 && rigid)
        mend(world, chosen(edges_, all, isCut_), {.name = "mending", .order = order},
             {.tolerance = options_.mending, .rounds = rounds});
    world.constrain(chosen(edges_, swept_, isCut_), {.name = "stretch", .order = order + 1});
    if (options_.strands) {
        std::vector<bool> gone;
        for (const int place : threads_) gone.push_back(isCut_[place]);
        strand(world, chosen(edges_, threads_, isCut_), partsOf(strands_, gone),
               {.name = "strands", .order = order + 2}, options_.geometricStiffness);
    }
    if (tethers_)
        world.constrain(tethersIn(world, tethers_->tethers()),
                        {.name = "tethers", .order = order + 3});
    if (aggregates_)
        aggregate(world, aggregates_->levels(), {.name = "aggregates", .order = order + 4});
}

long SheetPlan::visited() const {
    return (tethers_ ? tethers_->visited() : 0) + (aggregates_ ? aggregates_->visited() : 0);
}

}  // namespace plait
