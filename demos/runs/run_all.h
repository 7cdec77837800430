// Tasks on threads of their own.
#pragma once

#include "demos/tools/progress.h"

#include <functional>

namespace plait {

// task(i, job) for each i below `count`, once, by `jobs` threads numbered from 0, or as many as the
// system starts; shows that `begun` and those that are done are done. The first that throws ends
// all, and it is thrown on. Throws Interrupted.
void runAll(int count, int jobs, int begun, Progress& progress,
            const std::function<void(int i, int job)>& task);

}  // namespace plait
