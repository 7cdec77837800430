// Which triangles enclose a volume.
#pragma once

#include "../world.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace plait {

// The boundary of a volume: every edge has as many triangles one way as the other.
struct Enclosure {
    std::vector<std::array<int, 3>> triangles;  // counter-clockwise from outside; caps last
    std::size_t skin = 0;                       // how many are matter, in the order given

    std::span<const std::array<int, 3>> caps() const { return std::span(triangles).subspan(skin); }
};

struct EnclosureOptions {
    bool cap = false;  // openings are closed by fans over their own vertices, without matter
    std::string name = "gas";  // in messages
};

// Parts that share no vertex are turned by themselves so that each has its volume inside where its
// vertices are at `positions` (m). What is flat there, as a Mylar balloon is cut, faces as most of
// its triangles do as given. Throws std::invalid_argument, one line that names edges, for what is
// not closed, has an edge of three triangles or has one side only; doubled vertices are named, to
// be welded by inspect().
Enclosure enclose(std::span<const Vec<double>> positions, std::vector<std::array<int, 3>> triangles,
                  const EnclosureOptions& options = {});
// The triangles of these objects, at rest: one volume, whether they are joined or not.
Enclosure enclose(const World& world, const std::vector<Range>& objects,
                  const EnclosureOptions& options = {});

// What closes the openings of triangles that face outward: for each a fan over its rim.
std::vector<std::vector<std::array<int, 3>>> fansOver(
    std::span<const std::array<int, 3>> triangles);

// m^3, above 0 unless it is inside out. Loses nothing far from the origin.
double volume(const Enclosure& enclosure, std::span<const Vec<double>> positions);

}  // namespace plait
