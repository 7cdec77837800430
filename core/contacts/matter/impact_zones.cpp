#include "impact_zones.h"

#include "../../numbers/convert.h"
#include "reals.h"

namespace plait {

void ImpactZones::clear() {
    for (const int v : members_) parent_[v] = -1;
    members_.clear();
}

int ImpactZones::rootOf(int vertex) {
    while (parent_[vertex] != vertex) {
        parent_[vertex] = parent_[parent_[vertex]];
        vertex = parent_[vertex];
    }
    return vertex;
}

void ImpactZones::join(std::span<const int> vertices, std::span<const unsigned char> pinned,
                       bool held) {
    int root = -1;
    for (const int v : vertices) {
        held |= pinned[v] != 0;
        if (pinned[v]) continue;
        if (parent_[v] < 0) {
            parent_[v] = v;
            zones_[v] = {};
            members_.push_back(v);
        }
        const int other = rootOf(v);
        if (root >= 0 && other != root) {
            zones_[root].members += zones_[other].members;
            zones_[root].held |= zones_[other].held;
            parent_[other] = root;
        } else {
            root = other;
        }
    }
    if (root < 0) return;
    zones_[root].held |= held;
    zones_[root].crosses = true;
}

template <class Real>
int ImpactZones::put(const Sweep<Real>& sweep) {
    for (const int v : members_) {
        if (parent_[v] != v) continue;
        Zone& zone = zones_[v];
        zone.held |= zone.crosses && zone.put == zone.members;
        zone.mass = 0;
        zone.way = {};
    }
    for (const int v : members_) {
        const Real* const p = sweep.particles + 8 * v;
        const double mass = 1 / double(p[3]);
        Zone& zone = zoneOf(v);
        zone.mass += mass;
        zone.way += mass * (three(p + 4) - three(sweep.before + 4 * v));
    }
    int moved = 0;
    for (const int v : members_) {
        const Zone& zone = zoneOf(v);
        if (!zone.crosses) continue;
        if (zone.held) {
            moved += putBack(sweep, v);
            continue;
        }
        plait::put(sweep.particles + 8 * v + 4,
                   three(sweep.before + 4 * v) + (1 / zone.mass) * zone.way);
        ++moved;
    }
    for (const int v : members_) {
        zones_[v].put = zones_[v].members;
        zones_[v].crosses = false;
    }
    return moved;
}

template int ImpactZones::put(const Sweep<float>&);
template int ImpactZones::put(const Sweep<double>&);

}  // namespace plait
