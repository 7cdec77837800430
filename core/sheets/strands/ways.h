// Shortest ways along the links of a graph: in an inextensible sheet, how far apart two vertices
// can ever be.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace plait {

struct Link {
    int a, b;
    double length;  // m, or any bound on the distance of its ends
};

class Ways {
public:
    Ways(int nodes, std::span<const Link> links);

    // Calls visit(node, distance, nearest source) in the order of distance, ties by node, until it
    // returns false or nothing is left.
    void from(std::span<const int> sources,
              const std::function<bool(int node, double distance, int source)>& visit);

    struct Neighbour {
        int node;
        double length;
    };
    std::span<const Neighbour> around(int node) const { return neighbours_[node]; }

    // Infinity where no link joins them.
    double link(int a, int b) const;
    // Gives the link a length; with infinity there is none.
    void change(const Link& link);
    void addNode();

private:
    std::vector<std::vector<Neighbour>> neighbours_;
    std::vector<double> distance_;
    std::vector<int> source_, touched_;
};

}  // namespace plait
