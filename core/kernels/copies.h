// Inner loops are compiled once for each level of x86-64, in a namespace of its own (kernels.cpp),
// and each room chooses among its own copies of them at run time.
#pragma once

#include "kernels.h"

#include <stdexcept>
#include <string>

namespace plait {

// The three copies of a table: of those in lanes, null for widths that a level does not have.
template <class Table>
using ByLanes = const Table*(int lanes);
template <class Table>
using Single = const Table*();

// That of the level chosen. Throws std::invalid_argument if this processor cannot run it.
template <class Copy>
Copy* copyFor(KernelChoice choice, Copy* v2, Copy* v3, Copy* v4) {
    if (!available(choice))
        throw std::invalid_argument("no kernels for x86-64-v" +
                                    std::to_string(static_cast<int>(choice.isa) + 2) + " with " +
                                    std::to_string(choice.lanes) + " lanes on this machine");
    return choice.isa == Isa::v2 ? v2 : choice.isa == Isa::v3 ? v3 : v4;
}

}  // namespace plait
