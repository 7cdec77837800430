#include "../../kernels/copies.h"
#include "front_kernels.h"

namespace plait {

Single<FrontTable> fronts_v2, fronts_v3, fronts_v4;

const FrontTable& frontKernels(KernelChoice choice) {
    return *copyFor(choice, fronts_v2, fronts_v3, fronts_v4)();
}

}  // namespace plait
