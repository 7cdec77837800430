#include "solid_pattern.h"

#include "polyhedron.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace plait {
namespace {

constexpr double widest = 10;  // m

// The nearest first, until none that is left can reach.
Polyhedron cellOf(std::span<const Lump> lumps, int i, double kerf) {
    const Lump& own = lumps[i];
    const std::string name = "lump " + std::to_string(i);
    Polyhedron cell(own.site, widest);
    // A plane that takes less would leave a sliver of a face: seven eighths of the kerf stay free.
    const double slack = kerf / 16;
    for (const HalfSpace& plane : own.within) {
        if (dot(plane.normal, own.site) >= plane.offset)
            throw std::invalid_argument(name + " lacks its site");
        cell.cutOff(plane, -1, slack);
    }
    std::vector<std::pair<double, int>> others;
    for (int j = 0; j < std::ssize(lumps); ++j)
        if (j != i) others.emplace_back(length(lumps[j].site - own.site), j);
    std::ranges::sort(others);
    for (const auto& [away, j] : others) {
        if (cell.empty() || away > 2 * cell.reach(own.site)) break;
        if (away <= kerf) throw std::invalid_argument(name + " has the site of another");
        const Vec<double> normal = (1 / away) * (lumps[j].site - own.site);
        cell.cutOff({normal, dot(normal, own.site) + (away - kerf) / 2}, j, slack);
    }
    if (cell.empty() || cell.reach(own.site) >= widest)
        throw std::invalid_argument(name + " is empty or open");
    return cell;
}

SolidSeam seamOf(const Polyhedron& cell, const Polyhedron::Face& face, int first) {
    const auto corner = [&](std::size_t i) {
        return cell.corners()[face.corners[i % face.corners.size()]];
    };
    Vec<double> area{}, along{};
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const Vec<double> side = corner(i + 1) - corner(i);
        area += 0.5 * cross(corner(i) - corner(0), side);
        if (length(side) > length(along)) along = side;
    }
    along = (1 / length(along)) * along;
    double least = dot(along, corner(0)), most = least;
    for (std::size_t i = 1; i < face.corners.size(); ++i) {
        least = std::min(least, dot(along, corner(i)));
        most = std::max(most, dot(along, corner(i)));
    }
    return {first, face.plane, along, most - least, length(area) / (most - least)};
}

}  // namespace

SolidPattern cut(std::span<const Lump> lumps, double kerf) {
    if (!(kerf > 0)) throw std::invalid_argument("the kerf must be positive");
    SolidPattern pattern;
    std::vector<Polyhedron> cells;
    for (int i = 0; i < std::ssize(lumps); ++i) {
        pattern.sites.push_back(lumps[i].site);
        cells.push_back(cellOf(lumps, i, kerf));
        pattern.cells.push_back(cells.back().shape());
    }
    for (int i = 0; i < std::ssize(lumps); ++i)
        for (const Polyhedron::Face& face : cells[i].faces()) {
            // What either has lost to the other's own planes holds nothing.
            if (face.plane > i &&
                std::ranges::find(cells[face.plane].faces(), i, &Polyhedron::Face::plane) !=
                    cells[face.plane].faces().end())
                pattern.seams.push_back(seamOf(cells[i], face, i));
        }
    return pattern;
}

}  // namespace plait
