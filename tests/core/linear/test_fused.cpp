// The fused multiply-add of processors that have none.
#include "tests/catch.h"
#include "tests/random.h"

#include <plait/kernels/workers.h>
#include <plait/linear/fronts/fused.h>

#include <cmath>

using namespace plait;
using namespace plait::test;

TEST_CASE("fused: the imitation is libm's fused multiply-add", "[multifrontal]") {
    Random random(1);
    const FlushDenormals flush;
    for (int i = 0; i < 200'000; ++i) {
        const auto number = [&] {
            // Few bits often: sums that lie just beside the middle between two floats.
            const int bits = 1 + random.below(24);
            const auto mantissa = static_cast<float>(random.below(1 << bits) - (1 << (bits - 1)));
            return std::ldexp(mantissa, random.below(40) - bits);
        };
        const float a = number(), b = number(), c = number();
        Pack<4>::V sum = fused(Pack<4>(a), Pack<4>(b), Pack<4>(c)).v;
        REQUIRE(sum[i % 4] == std::fma(a, b, c));
    }
}
