// What definitions of studies are put together from, and the studies of curves, cloth and pieces.
#pragma once

#include "demos/study/study.h"

namespace plait {

inline constexpr Vec<double> down{0, -9.81, 0};  // m/s^2

// xpbd in either order and precision.
extern const Settings firstOrder, secondOrder, firstOrderFloat, secondOrderFloat;

// Substeps doubling from `first` to `last`.
std::vector<int> doubling(int first, int last);

Settings with(Settings settings, const std::string& name, const std::string& value);

// A curve of these substeps in a frame, `iterations` each.
StudyCurve curve(const std::string& name, const Settings& settings,
                 const std::vector<int>& substeps, int iterations = 1);

// All `work` sweeps of a frame in this many substeps, or a sweep each for 0.
StudyCurve sharedOut(const std::string& name, const Settings& settings, int substeps,
                     const std::vector<int>& work);

// Settings of a method other than xpbd, in double.
Settings by(const std::string& method, const std::string& integrator = "first");

// The program's own solver with these settings: a reference only where it is checked by halving.
// Throws SceneError if it diverges.
Trajectory fine(const Study& study, Settings settings, int substeps);

Study cantileverStudy();
Study cantileverStripStudy();
Study slinkyStudy();
Study stripStudy();
Study sheetStudy(int n);   // n x n vertices against a reference
Study sheetStrain(int n);  // the work of peers
Study sheetStep(int n);    // against the converged solution of one step
Study flagStudy();
Study sphereStudy();
Study dressStudy();
Study pileStudy();

}  // namespace plait
