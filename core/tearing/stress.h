// What the triangles of a sheet bear, and what drives the end of a tear.
#pragma once

#include "../membranes/elements.h"
#include "../membranes/membrane.h"
#include "../numbers/symmetric.h"
#include "sites.h"

#include <array>
#include <span>
#include <vector>

namespace plait {

class SheetStress {
public:
    // `rest` by vertex, m.
    SheetStress(const Cuts& cuts, const std::vector<Membrane::Rubber>& rubber,
                std::span<const Vec<double>> rest);

    // What a triangle bears in its principal directions.
    struct Borne {
        double energy;                         // J/m^3
        std::array<double, 2> stretch;         // the larger first
        std::array<double, 2> force;           // Pa, on areas at rest
        std::array<Vec<double>, 2> direction;  // of unit length, at rest
        std::array<Vec<double>, 2> pull;       // of unit length, where these forces point now
    };
    // `positions`: of its corners (m), in the order of Cuts::corners.
    Borne borne(int triangle, const std::array<Vec<double>, 3>& positions) const;
    // N, on each corner.
    std::array<Vec<double>, 3> forces(int triangle,
                                      const std::array<Vec<double>, 3>& positions) const;
    bool has(int triangle) const { return place_[static_cast<std::size_t>(triangle)] >= 0; }
    double area(int triangle) const { return elementOf(triangle).area; }            // m^2, at rest
    double thickness(int triangle) const { return elementOf(triangle).thickness; }  // m
    double volume(int triangle) const { return elementOf(triangle).patch.volume; }  // m^3
    double shearModulus(int triangle) const;                                        // Pa

    // The gradient at rest of what is `q` at the corners, 1/m.
    Vec<double> gradient(int triangle, const std::array<double, 3>& q) const;

private:
    struct Element {
        Patch patch;
        int law;
        double area, thickness;
        Vec<double> along, across;          // at rest: the axes in which the patch has its edges
        std::array<Vec<double>, 3> slopes;  // 1/m, of what is 1 at a corner
    };
    const Element& elementOf(int triangle) const {
        return elements_[static_cast<std::size_t>(place_[static_cast<std::size_t>(triangle)])];
    }

    struct Law {
        Ogden ogden;
        bool relaxed;
    };
    std::vector<int> place_;  // by triangle of the complex: of its element, -1: not of the sheet
    std::vector<Element> elements_;
    std::vector<Law> laws_;
};

}  // namespace plait
