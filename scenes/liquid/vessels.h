// A jug, a wine glass and a tray: walls of revolution, as thick as water of a spacing needs them.
#pragma once

#include <plait/contacts/solids/profile.h>

#include <array>
#include <vector>

namespace plait {

using Outline = std::vector<std::array<double, 2>>;  // {radius, height}, m

// What is inside of `cavity` may be full; it goes from the axis up to the rim. `wall` is closed.
struct Vessel {
    Outline cavity, wall;

    double rim() const { return cavity.back()[1]; }
    // m^3, of the cavity up to this height (m), and the height of that volume's centre (m).
    double volume(double level) const;
    double centre(double level) const;
    // m, of the cavity there; 0 above and below.
    double radius(double height) const;
    bool holds(double radius, double height) const;
    // m, up to which what has its centre there fills it.
    double levelOf(double middle) const;
};

// Each stands on y = 0; `thick` (m) is its wall.
Vessel wineGlass(double thick);
Vessel carafe(double thick);
// A ring that stands on a table.
Outline trayRim(double thick);

}  // namespace plait
