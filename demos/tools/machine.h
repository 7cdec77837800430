// What a run ran on: figures of time mean nothing without it.
#pragma once

#include <string>

namespace plait {

struct Machine {
    std::string processor;  // as the system names it
    int cores;              // that this program may use
    double memory;          // bytes
    std::string system;     // kernel and architecture
    std::string kernels;    // "x86-64-v3": the inner loops in use
    int lanes;              // floats side by side in them
};
Machine thisMachine();

// Cores that this program may use.
int usableCores();

// Bytes of memory that this program had in use at most, so far.
long peakMemory();

}  // namespace plait
