#include "chain_set.h"

#include "../numbers/convert.h"
#include "../sets/tree_solve.h"  // redundant

#include <algorithm>
#include <cmath>
#include <utility>

namespace plait {
namespace {

// The d of both ends together.
template <class Real>
Vec<double> movedBy(const Sweep<Real>& sweep, const std::array<int, 2>& edge) {
    return three(sweep.particles + 8 * edge[0] + 4) + three(sweep.particles + 8 * edge[1] + 4);
}

// How many curves run side by side, or rows of one: doubles where there is room for so many floats.
int lanesOf(KernelChoice choice) { return std::max(choice.lanes / 2, 1); }

// For curves side by side, the most at a time first: in double eight abreast are a fifth faster
// than four, where there are registers for them.
std::vector<KernelChoice> abreast(KernelChoice choice) {
    if (choice.isa == Isa::v4 && choice.lanes < 16) return {{choice.isa, 16}, choice};
    return {choice};
}

}  // namespace

template <class Real>
ChainSet<Real>::ChainSet(Parts parts, std::span<const std::vector<int>> curves,
                         std::span<const unsigned char> pinned, KernelChoice choice,
                         std::vector<ChainRider> riders, std::vector<ChainLink> links)
    : parts_(std::move(parts)),
      riders_(std::move(riders)),
      middles_(riders_.size()),
      links_(std::move(links)) {
    std::vector<ChainStencils> stencils;
    for (const auto& part : parts_) {
        stencils.push_back(part->stencils());
        size_ += static_cast<long>(part->rows()) * part->stencils().values;
    }
    const std::vector<ChainCurve> plans = planChains(stencils, curves, pinned);
    std::vector<std::vector<const ChainCurve*>> alike;
    for (const ChainCurve& plan : plans) {
        const auto group = std::ranges::find_if(
            alike, [&](const auto& others) { return samePlan(*others[0], plan); });
        (group == alike.end() ? alike.emplace_back() : *group).push_back(&plan);
    }
    for (const auto& group : alike) {
        std::span<const ChainCurve* const> left = group;
        for (const KernelChoice& wide : abreast(choice)) {
            const auto lanes = static_cast<std::size_t>(lanesOf(wide));
            const std::size_t count = lanes > 1 ? left.size() / lanes * lanes : 0;
            layOut(left.first(count), wide, false);
            left = left.subspan(count);
        }
        layOut(left, choice, true);
    }
}

template <class Real>
void ChainSet<Real>::layOut(std::span<const ChainCurve* const> curves, KernelChoice choice,
                            bool along) {
    if (curves.empty()) return;
    std::vector<ChainStencils> stencils;
    std::vector<int> members;
    std::vector<ChainRowsKernel> rows;
    for (const auto& part : parts_) {
        stencils.push_back(part->stencils());
        members.push_back(part->members());
        rows.push_back(part->kernel(choice, along));
    }
    const ChainLayout& layout =
        layouts_
            .emplace_back(ChainLayout(*curves[0], stencils, members, lanesOf(choice), along),
                          &chainKernels<Real>(choice), std::move(rows))
            .layout;
    const auto lanes = static_cast<std::size_t>(layout.curves());
    for (std::size_t first = 0; first < curves.size(); first += lanes) {
        Unit unit{static_cast<int>(layouts_.size()) - 1, {}, {}, {}, {}};
        const auto of = curves.subspan(first, lanes);
        for (std::size_t v = 0; v < of[0]->vertices.size(); ++v)
            for (const ChainCurve* curve : of) unit.ids.push_back(curve->vertices[v]);
        for (const auto& part : layout.parts())
            for (std::size_t i = 0; i < of[0]->places.size(); ++i)
                if (of[0]->places[i].part == part.part && of[0]->places[i].value == 0)
                    for (const ChainCurve* curve : of) unit.rows.push_back(curve->places[i].row);
        unit.parameters.resize(static_cast<std::size_t>(layout.parameters()));
        unit.lambda.resize(static_cast<std::size_t>(layout.rows()) * lanes);
        for (const auto& part : layout.parts()) fill(unit, part);
        units_.push_back(std::move(unit));
    }
}

// The parameters of one part as they are now. Blocks are filled up with its last row.
template <class Real>
void ChainSet<Real>::fill(Unit& unit, const ChainLayout::Part& part) const {
    const ChainLayout& layout = layouts_[unit.layout].layout;
    const ChainPart& from = *parts_[part.part];
    const int members = from.members(), width = layout.width(), curves = layout.curves(),
              slots = part.blocks * width / curves;
    int begin = 0;
    for (const auto& other : layout.parts())
        if (other.part < part.part) begin += other.rows * curves;
    for (int r = 0; r < slots; ++r)
        for (int c = 0; c < curves; ++c) {
            const int row = unit.rows[begin + std::min(r, part.rows - 1) * curves + c];
            double* const to = &unit.parameters[part.parameters + layout.slot(r, members) + c];
            for (int m = 0; m < members; ++m) to[m * width] = from.row(row)[m];
        }
}

template <class Real>
void ChainSet<Real>::beginFrame(double t0, double t1) {
    for (const auto& part : parts_) part->beginFrame(t0, t1);
}

template <class Real>
void ChainSet<Real>::begin(const Substep& substep, Workers&) {
    fresh_ = true;
    finished_ = false;
    fall_ = substep.fall;
    for (int p = 0; p < static_cast<int>(parts_.size()); ++p) {
        if (!parts_[p]->begin(substep)) continue;
        for (Unit& unit : units_)
            for (const auto& part : layouts_[unit.layout].layout.parts())
                if (part.part == p) fill(unit, part);
    }
}

// Solves each with what change(system) makes of its system.
template <class Real>
template <class Change>
void ChainSet<Real>::forUnits(const Sweep<Real>& sweep, Workers& workers, const Change& change) {
    if (scratch_.empty()) {
        int most = 0;
        for (const Laid& laid : layouts_) most = std::max(most, laid.layout.scratch());
        scratch_.resize(workers.threads());
        for (auto& scratch : scratch_) scratch.resize(most);
    }
    const long count = std::ssize(units_), shares = std::min<long>(count, std::ssize(scratch_));
    workers.forBlocks(static_cast<int>(shares), 1, [&](int begin, int end) {
        for (long t = begin; t < end; ++t)
            for (long u = count * t / shares; u < count * (t + 1) / shares; ++u) {
                Unit& unit = units_[u];
                ChainSystem system = layouts_[unit.layout].layout.system(
                    unit.ids.data(), unit.lambda.data(), scratch_[t].data());
                system.redundant = redundant;
                change(system);
                solve(unit, sweep, system);
            }
    });
}

template <class Real>
void ChainSet<Real>::solve(Unit& unit, const Sweep<Real>& sweep, ChainSystem system) const {
    const auto& [layout, kernels, rows] = layouts_[unit.layout];
    const int along = layout.along() ? 1 : 0;
    kernels->gather[along](sweep, system);
    for (const auto& part : layout.parts())
        rows[part.part]({.rows = &unit.parameters[part.parameters],
                         .ids = layout.ids() + part.ids,
                         .vertices = system.vertexNumbers,
                         .out = system.out + part.out,
                         .blocks = part.blocks,
                         .width = layout.width(),
                         .rates = system.rates,
                         .falls = system.fall[0] != 0 || system.fall[1] != 0 || system.fall[2] != 0,
                         .fall = system.fall,
                         .inverseH2 = double(sweep.inverseH2)});
    kernels->solve[along](sweep, system);
}

template <class Real>
void ChainSet<Real>::project(const Sweep<Real>& sweep, Direction, Workers& workers) {
    const double keep = fresh_ ? 0 : double(sweep.keep);
    forUnits(sweep, workers, [&](ChainSystem& system) {
        system.keep = keep;
        if (fresh_) std::copy_n(&fall_.x, 3, system.fall);
    });
    fresh_ = false;
}

template <class Real>
void ChainSet<Real>::damp(const Sweep<Real>& sweep, Workers& workers) {
    forUnits(sweep, workers, [&](ChainSystem& system) { system.rates = true; });
}

template <class Real>
void ChainSet<Real>::noteRides(const Sweep<Real>& sweep) {
    for (std::size_t i = 0; i < riders_.size(); ++i) middles_[i] = movedBy(sweep, riders_[i].edge);
}

template <class Real>
void ChainSet<Real>::carryRides(const Sweep<Real>& sweep) {
    for (std::size_t i = 0; i < riders_.size(); ++i) {
        Real* const p = sweep.particles + 8 * riders_[i].vertex;
        if (p[3] == 0) continue;
        put(p + 4, three(p + 4) + 0.5 * (movedBy(sweep, riders_[i].edge) - middles_[i]));
    }
}

template <class Real>
bool ChainSet<Real>::isOff(const Sweep<Real>& sweep) const {
    const auto at = [&](int v) {
        const Real* const p = sweep.particles + 8 * v;
        return three(p) + three(p + 4);
    };
    return std::ranges::any_of(links_, [&](const ChainLink& link) {
        const double now = length(at(link.edge[1]) - at(link.edge[0]));
        return std::fabs(now - link.length) > link.strain * link.length;
    });
}

// What contacts have pulled too long, once a substep: they have the last word, but on what crosses
// only, and where both want it again and again what goes back does not end.
template <class Real>
long ChainSet<Real>::finish(const Sweep<Real>& sweep, Workers& workers) {
    if (finished_ || !isOff(sweep)) return 0;
    finished_ = true;
    project(sweep, Direction::forward, workers);
    return size_;
}

template class ChainSet<float>;
template class ChainSet<double>;

void Chains::constrain(World& world, SetOptions options) const {
    const auto make = [chains = *this, name = options.name]<class Real>(
                          const World& w,
                          KernelChoice kernels) -> std::unique_ptr<Constraint<Real>> {
        typename ChainSet<Real>::Parts parts;
        for (const auto& maker : chains.makers_) parts.push_back(maker(name, w.start.size()));
        return std::make_unique<ChainSet<Real>>(std::move(parts), chains.curves_, w.pinned, kernels,
                                                chains.riders_, chains.links_);
    };
    world.constrain(recipeOf<Constraint>(make), std::move(options));
}

}  // namespace plait
