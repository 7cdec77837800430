#pragma once

#include <time.h>

namespace plait {

// s that the calling thread has run, which others on its core do not lengthen.
inline double threadTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

}  // namespace plait
