// Stability maps: where in a plane of two parameters a method is ok, and where theory says that it
// stops being so (validation C7, D).
#pragma once

#include "outcome.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plait {

// A parameter, on a logarithmic axis.
struct StabilityAxis {
    std::string label;  // with its unit
    double low, high;
    bool whole = false;  // a count
};

// One method on one map.
struct StabilityPanel {
    std::string name;
    std::function<Outcome(double x, double y)> cell;
    // y of the boundary that theory has at x; none: theory knows of none.
    std::function<double(double x)> theory = {};
    // Known to be bad: beyond theory's boundary, by 10 %, it must fail.
    bool mustFail = false;
};

struct StabilityMap {
    std::string name, title;
    std::string words;  // what a cell is, for the page
    std::string note;   // the same in a line, for the chart
    std::string theoryWords;
    StabilityAxis x, y;
    bool goodAtLowY = true;             // on which side the methods are ok
    Outcome fails = Outcome::exploded;  // the least outcome that counts as beyond the boundary
    std::vector<double> boundaryAt;     // x at which the boundary is found; none: cells are all
    std::vector<StabilityPanel> panels;
    // What outcomes are called where they have nothing to do with energy, and what that means.
    std::vector<std::string> outcomes = {"ok", "drifting", "exploded", "not finite"};
    std::string outcomeWords =
        "ok: none of what follows. Drifting: E > 1.01 E0 + work, or what is said above. Exploded: "
        "E > 1.05 E0 + work, or a strain beyond 200 %. Not finite: a number is not.";
};

// All of them; and the one of that name. Throws UsageError with the nearest name.
const std::vector<StabilityMap>& stabilityMaps();
const StabilityMap& stabilityMapNamed(const std::string& name);

// One file each; stabilityMaps() lists them.
StabilityMap stepStiffnessMap();
StabilityMap massRatioMap();
StabilityMap stiffnessRatioMap();
StabilityMap chainLengthMap();
StabilityMap resolutionMap();
StabilityMap rodSegmentsMap();
StabilityMap stairsMap();
StabilityMap rotationMap();
StabilityMap bdf2SweepsMap();
StabilityMap bulletMap();
StabilityMap layersMap();

// `count` values from one end to the other, evenly in ratio; whole ones rounded, each once.
std::vector<double> valuesOf(const StabilityAxis& axis, int count);

// Where a panel ends at x: the last y that is good, at the first change from the low end of the
// axis, where runs are short. It is searched by factors of 2, and the pair found is halved to
// within 1 %, or to neighbours where y is whole. No y: nothing is good. Open: everything is, and y
// is the far end.
struct Boundary {
    std::string panel;
    double x;
    std::optional<double> y;
    bool open = false;

    bool operator==(const Boundary&) const = default;
};
Boundary traceBoundary(const StabilityMap& map, const StabilityPanel& panel, double x);

// What is stored of a map, and is held to it: "panel,x,y,open".
std::string csvOf(const std::vector<Boundary>& boundaries);
// Throws FileError that begins with `name`.
std::vector<Boundary> boundariesFrom(const std::string& csv, const std::string& name);

// What a boundary is not allowed to do, one line each: to be pulled in by more than 5 % against
// what is `stored`, to be not stored at all, or, where the panel must fail, to lie beyond theory's.
std::vector<std::string> complaints(const StabilityMap& map, const std::vector<Boundary>& stored,
                                    const std::vector<Boundary>& found);

}  // namespace plait
