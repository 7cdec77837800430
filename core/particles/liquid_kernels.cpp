// Compiled once for each of x86-64-v2, -v3 and -v4, as kernels.cpp is.
#include "liquid_kernels.h"

#include "liquid_loop.h"

#define PLAIT_JOIN2(a, b) a##_##b
#define PLAIT_JOIN(a, b) PLAIT_JOIN2(a, b)

namespace plait {
namespace {

template <class Real>
const LiquidTable<Real>* liquidTable() {
    static constexpr LiquidTable<Real> table{weighCells<Real>, moveCells<Real>};
    return &table;
}

}  // namespace

const LiquidTable<float>* PLAIT_JOIN(floatLiquid, PLAIT_ISA)() { return liquidTable<float>(); }
const LiquidTable<double>* PLAIT_JOIN(doubleLiquid, PLAIT_ISA)() { return liquidTable<double>(); }

}  // namespace plait
