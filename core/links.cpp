#include "links.h"

#include "numbers/splitmix.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace plait {
namespace {

void check(std::span<const std::vector<int>> components, std::size_t vertices,
           const LinkOptions& options) {
    if (!(options.maxDistance >= 0))
        throw std::invalid_argument("links: the distance is " +
                                    std::to_string(options.maxDistance));
    if (!(options.density >= 0 && options.density <= 1))
        throw std::invalid_argument("links: the density is " + std::to_string(options.density));
    for (const std::vector<int>& component : components)
        for (const int v : component)
            if (v < 0 || static_cast<std::size_t>(v) >= vertices)
                throw std::invalid_argument("links: there is no vertex " + std::to_string(v));
}

bool joins(Relation relation, std::size_t a, std::size_t b) {
    switch (relation) {
        case Relation::allToAll:
            return a < b;
        case Relation::allToFirst:
            return a == 0 && b > 0;
        case Relation::chain:
            return b == a + 1;
        case Relation::within:
            return a == b;
    }
    return false;
}

}  // namespace

std::vector<int> linkStencils(std::span<const std::vector<int>> components,
                              std::span<const Vec<double>> rest, const LinkOptions& options) {
    check(components, rest.size(), options);
    std::vector<int> links;
    std::set<std::pair<int, int>> known;
    Splitmix random(options.seed);
    const auto link = [&](int a, int b) {
        const Vec<double> apart =
            rest[static_cast<std::size_t>(a)] - rest[static_cast<std::size_t>(b)];
        if (a == b || length(apart) > options.maxDistance ||
            !known.insert(std::minmax(a, b)).second)
            return;
        if (random.next() < options.density) links.insert(links.end(), {a, b});
    };
    for (std::size_t a = 0; a < components.size(); ++a)
        for (std::size_t b = a; b < components.size(); ++b)
            if (joins(options.relation, a, b))
                for (const int v : components[a])
                    for (const int u : components[b]) link(v, u);
    return links;
}

}  // namespace plait
