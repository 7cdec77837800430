#include "failures.h"

#include "../../world.h"

#include <algorithm>

namespace plait {

bool Failures::needed(const std::vector<Surface>& surfaces, const ContactOptions& options) {
    return options.trapped || options.selfTrapped || options.disableFailed ||
           std::ranges::any_of(surfaces, [](const Surface& s) {
               return !s.disableSelf.empty() || !s.disableExternal.empty();
           });
}

Failures::Failures(const World& world, const std::vector<Surface>& surfaces,
                   const ContactOptions& options)
    : options_(options),
      surface_(world.start.size(), -1),
      pinned_(world.pinned),
      flags_(world.start.size(), 0),
      neighbours_(world.complex.oneRing()),
      tangles_(world.complex, surfaces, world.pinned) {
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (int v = surfaces[s].vertices.first; v < surfaces[s].vertices.last; ++v) {
            const auto i = std::size_t(v - surfaces[s].vertices.first);
            surface_[v] = static_cast<int>(s);
            const auto flagOf = [&](const std::vector<std::uint8_t>& flags) {
                return flags.empty() ? 0 : int{flags[i]};
            };
            flags_[v] = flagOf(surfaces[s].disableExternal) | flagOf(surfaces[s].disableSelf)
                                                                  << Disabled::ownShift;
        }
    connect(world);
}

// By flooding from the lowest vertex of each island.
void Failures::connect(const World& world) {
    island_.assign(world.start.size(), -1);
    std::vector<int> open;
    for (int root = 0; root < std::ssize(island_); ++root) {
        if (island_[root] >= 0) continue;
        island_[root] = root;
        open.assign(1, root);
        while (!open.empty()) {
            const int v = open.back();
            open.pop_back();
            for (const int u : neighbours_[v])
                if (island_[u] < 0) {
                    island_[u] = root;
                    open.push_back(u);
                }
        }
    }
}

void Failures::begin(std::span<const Vec<double>> start, std::span<const std::int32_t> flags,
                     ContactCounts& counts, Workers& workers) {
    flags_.assign(flags.begin(), flags.end());
    if (!options_.trapped && !options_.selfTrapped && !options_.disableFailed) return;
    tangles_.find(start, tangled_, workers);
    long tangled = 0;
    for (std::size_t v = 0; v < flags_.size(); ++v) tangled += tangled_.own[v] || tangled_.other[v];
    counts.tangled = std::max(counts.tangled, tangled);
    if (!options_.disableFailed) return;
    for (const bool own : {false, true}) {
        const auto& marks = own ? tangled_.own : tangled_.other;
        for (int v = 0; v < std::ssize(flags_); ++v)
            if (marks[v]) disable(v, own, counts);
        release(own, counts);
    }
}

void Failures::set(int vertex, bool own, int flag) {
    const int shift = own ? Disabled::ownShift : 0;
    flags_[vertex] = (flags_[vertex] & ~(3 << shift)) | flag << shift;
}

void Failures::disable(int vertex, bool own, ContactCounts& counts) {
    if (surface_[vertex] < 0 || pinned_[vertex] || flag(vertex, own) & Disabled::asFailed) return;
    set(vertex, own, Disabled::fail(flag(vertex, own)));
    ++counts.disabled;
}

// What is tangled no longer and next to what is not disabled; or all of an island that is disabled
// and nowhere tangled, since it is on one side. One ring a substep: what has gone through is not
// taken back before all that is between it and the rest.
void Failures::release(bool own, ContactCounts& counts) {
    const auto& marks = own ? tangled_.own : tangled_.other;
    const auto failed = [&](int v) { return (flag(v, own) & Disabled::asFailed) != 0; };
    stuck_.assign(flags_.size(), 0);
    for (std::size_t v = 0; v < flags_.size(); ++v)
        if (marks[v] || (surface_[v] >= 0 && !failed(static_cast<int>(v)))) stuck_[island_[v]] = 1;
    freed_.clear();
    for (int v = 0; v < std::ssize(flags_); ++v) {
        if (!failed(v) || marks[v]) continue;
        const auto beside = neighbours_[v];
        if (!stuck_[island_[v]] || std::ranges::any_of(beside, [&](int u) { return !failed(u); }))
            freed_.push_back(v);
    }
    for (const int v : freed_) set(v, own, Disabled::free(flag(v, own)));
    counts.enabled += static_cast<long>(freed_.size());
}

bool Failures::leavesOut(const Pairing& pair) const {
    const bool within = own(pair);
    const bool trapped = within ? options_.selfTrapped : options_.trapped;
    const auto& marks = within ? tangled_.own : tangled_.other;
    return std::ranges::any_of(
        pair.vertices, [&](int v) { return flag(v, within) != 0 || (trapped && marks[v]); });
}

void Failures::fail(const Pairing& pair, ContactCounts& counts) {
    if (!options_.disableFailed) return;
    for (const int v : pair.vertices) disable(v, own(pair), counts);
}

}  // namespace plait
