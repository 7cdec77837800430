// Pieces that welds join, as one body each.
#pragma once

#include "../constraint.h"
#include "../numbers/rotation.h"
#include "../world.h"
#include "welds.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plait {

struct Cluster {
    std::vector<int> pieces;    // in their order; the first leads
    std::vector<int> welds;     // that hold
    Vec<double> centre{};       // m, where all starts
    std::array<int, 3> base{};  // vertices far apart, for a first guess of the turn
    bool pinned = false;        // a vertex is
    double firm = 0;            // kg that a pinned vertex counts for
};

// Where a cluster is: what started at x is at `to` + turn * (x - centre).
struct ClusterPose {
    Vec<double> to;
    Rotation turn;
};

class Clusters {
public:
    explicit Clusters(const World& world);

    // By which welds hold, 1 or 0 each.
    void join(std::span<const Weld> welds, std::span<const std::int32_t> holds);

    std::span<const Cluster> all() const { return all_; }
    std::span<const std::int32_t> leaders() const { return leaders_; }  // by piece

    // The nearest by mass to where its vertices are, and what puts them there but for pinned ones.
    template <class Real>
    ClusterPose poseOf(const Sweep<Real>& sweep, const Cluster& cluster) const;
    template <class Real>
    void put(const Sweep<Real>& sweep, const Cluster& cluster, const ClusterPose& pose) const;

    const Range& verticesOf(int piece) const { return pieces_[static_cast<std::size_t>(piece)]; }
    const Vec<double>& startOf(int vertex) const {
        return start_[static_cast<std::size_t>(vertex)];
    }
    double massOf(int vertex) const { return mass_[static_cast<std::size_t>(vertex)]; }

private:
    void describe(Cluster& cluster) const;
    template <class Visit>
    void forVertices(const Cluster& cluster, const Visit& visit) const;

    std::vector<Range> pieces_;
    std::vector<Vec<double>> start_;     // m, by vertex
    std::vector<double> mass_;           // kg, by vertex
    std::vector<unsigned char> pinned_;  // by vertex
    std::vector<std::int32_t> leaders_;
    std::vector<Cluster> all_;
};

}  // namespace plait
