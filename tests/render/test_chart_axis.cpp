#include "render/charts/axis.h"
#include "tests/catch.h"
#include "tests/random.h"

#include <cmath>
#include <set>

using namespace plait;
using namespace plait::test;

namespace {

std::vector<std::string> texts(AxisRange range, bool logarithmic, int steps) {
    std::vector<std::string> result;
    for (const Tick& tick : axisTicks(range, logarithmic, steps))
        if (!tick.text.empty()) result.push_back(tick.text);
    return result;
}

const Axis logarithmic{.logarithmic = true};

}  // namespace

TEST_CASE("Ticks of linear axes are 1, 2 or 5 times a power of ten", "[chart]") {
    using Texts = std::vector<std::string>;
    CHECK(texts({-1, 1}, false, 4) == Texts{"−1.0", "−0.5", "0.0", "0.5", "1.0"});
    CHECK(texts({0.3, 10.2}, false, 5) == Texts{"2", "4", "6", "8", "10"});
    CHECK(texts({-0.004, 0.031}, false, 4) == Texts{"0.00", "0.01", "0.02", "0.03"});
    CHECK(texts({0, 2.5e7}, false, 3) == Texts{"0", "1·10⁷", "2·10⁷"});
    CHECK(texts({-3e-7, 1e-7}, false, 4) == Texts{"−3·10⁻⁷", "−2·10⁻⁷", "−1·10⁻⁷", "0", "1·10⁻⁷"});
    CHECK(texts({5, 5}, false, 4) == Texts{"5"});

    Random random(11);
    for (int i = 0; i < 300; ++i) {
        const double size = std::pow(10, random.uniform(-6, 6));
        const double low = random.uniform(-size, size), high = low + random.uniform(0, size);
        const int steps = 1 + random.below(9);
        const auto ticks = axisTicks({low, high}, false, steps);
        CAPTURE(low, high, steps);
        REQUIRE(static_cast<int>(ticks.size()) <= steps + 1);
        // The next finer step would have been too many: 2.5 times as many at most.
        REQUIRE(static_cast<double>(ticks.size()) + 1 >= steps / 2.5);
        const double slack = 1e-5 * (high - low);
        for (const Tick& tick : ticks)
            REQUIRE((tick.value >= low - slack && tick.value <= high + slack));
        std::set<std::string> once;
        for (const Tick& tick : ticks) REQUIRE(once.insert(tick.text).second);
    }
}

TEST_CASE("Ticks of logarithmic axes are powers of ten", "[chart]") {
    using Texts = std::vector<std::string>;
    CHECK(texts({0.02, 150}, true, 9) == Texts{"0.1", "1", "10", "100"});
    CHECK(texts({2e-6, 0.3}, true, 9) == Texts{"10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹"});
    CHECK(texts({1e-9, 1}, true, 3) == Texts{"10⁻⁹", "10⁻⁶", "10⁻³", "10⁰"});
    CHECK(texts({1e-12, 1e12}, true, 5) == Texts{"10⁻¹⁰", "10⁻⁵", "10⁰", "10⁵", "10¹⁰"});
    CHECK(texts({9e-5, 0.02}, true, 9) == Texts{"0.0001", "0.001", "0.01"});
    CHECK(texts({0.9, 21}, true, 9) == Texts{"1", "2", "5", "10", "20"});
    CHECK(texts({3.2, 4.1}, true, 4) == Texts{"3.5", "4.0"});
    const auto ticks = axisTicks({1, 1000}, true, 9);
    REQUIRE(ticks.size() == 28);
    CHECK(ticks[1].value == Approx(2));
    CHECK(ticks[1].text.empty());
    CHECK(ticks[9].value == Approx(10));
    CHECK(axisTicks({1, 1e8}, true, 9).size() == 9);  // no room for lines between
}

TEST_CASE("An axis without a range holds its data", "[chart]") {
    const auto range = [](const Axis& axis, std::vector<double> data) {
        return axisRange(axis, data);
    };
    CHECK(range({}, {3, -1}).low == Approx(-1.2));
    CHECK(range({}, {3, -1}).high == Approx(3.2));
    CHECK(range(logarithmic, {1, 100}).high == Approx(100 * std::pow(10, 0.1)));
    CHECK(range({.low = 0}, {3, 1}).low == 0);
    for (const double value : {0.0, -2.0, 7.0, 1e-200, 1e200}) {
        const AxisRange around = range({}, {value, value});
        CAPTURE(value);
        CHECK((around.low < value && value < around.high));
        CHECK(!axisTicks(around, false, 5).empty());
    }
    CHECK(range(logarithmic, {}).low > 0);
}
