#include "axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plait {
namespace {

const std::string minus = "\u2212";  // as wide as a digit

std::string decimal(double value, int decimals) {
    char text[400];
    std::snprintf(text, sizeof text, "%.*f", decimals, value == 0 ? 0.0 : value);
    return value < 0 ? minus + (text + 1) : text;
}

std::string powerOfTen(int exponent) {
    static constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string result = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent))) result += raised[digit - '0'];
    return result;
}

std::vector<Tick> linearTicks(AxisRange range, int steps) {
    if (!(range.high > range.low) || !std::isfinite(range.high - range.low))
        return {{range.low, decimal(range.low, 0)}};
    const double rough = (range.high - range.low) / steps;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {5, 2, 1})
        if (rough <= factor * power) step = factor * power;
    const int exponent = static_cast<int>(std::floor(std::log10(step) + 1e-9));
    const bool plain = exponent >= -5 && std::max(-range.low, range.high) < 1e6;
    const double unit = plain ? 1 : std::pow(10, exponent);
    const double slack = 1e-6 * (range.high - range.low);
    std::vector<Tick> result;
    for (double i = std::ceil((range.low - slack) / step); i * step <= range.high + slack; ++i)
        result.push_back(
            {i * step, plain || i == 0 ? decimal(i * step, std::max(0, plain ? -exponent : 0))
                                       : decimal(i * step / unit, 0) + "·" + powerOfTen(exponent)});
    return result;
}

std::vector<Tick> logarithmicTicks(AxisRange range, int steps) {
    const double low = std::log10(range.low), high = std::log10(range.high);
    const double slack = 1e-6 * (high - low);
    const int first = static_cast<int>(std::floor(low + slack));
    const int last = static_cast<int>(std::floor(high + slack));
    const int stride = std::max(1, static_cast<int>(std::ceil((high - low) / steps)));
    const bool few = high - low < 2 && 3 * (high - low) <= steps;
    const bool plain = std::ceil(low - slack) >= -4 && last <= 4;
    const auto text = [&](int mantissa, int exponent) {
        if (plain) return decimal(mantissa * std::pow(10, exponent), std::max(0, -exponent));
        return (mantissa == 1 ? "" : decimal(mantissa, 0) + "·") + powerOfTen(exponent);
    };
    std::vector<Tick> result;
    for (int exponent = first; exponent <= last; ++exponent)
        for (int mantissa = 1; mantissa <= 9; ++mantissa) {
            const double at = exponent + std::log10(mantissa);
            if (at < low - slack || at > high + slack) continue;
            // Every third power of ten, say, is counted from 1, whatever the range.
            const bool named =
                mantissa == 1 ? exponent % stride == 0 : few && (mantissa == 2 || mantissa == 5);
            if (named || 2 * (high - low) <= steps)
                result.push_back({mantissa * std::pow(10, exponent),
                                  named ? text(mantissa, exponent) : std::string()});
        }
    return result;
}

}  // namespace

double AxisScale::operator()(double value) const {
    const double s = logarithmic ? std::log(value / range.low) / std::log(range.high / range.low)
                                 : (value - range.low) / (range.high - range.low);
    return from + s * (to - from);
}

AxisRange axisRange(const Axis& axis, std::span<const double> data) {
    const auto in = [&](double v) { return axis.logarithmic ? std::log10(v) : v; };
    const auto out = [&](double v) { return axis.logarithmic ? std::pow(10, v) : v; };
    double low = axis.logarithmic ? -1 : 0, high = axis.logarithmic ? 0 : 1;
    if (!data.empty()) {
        low = in(*std::min_element(data.begin(), data.end()));
        high = in(*std::max_element(data.begin(), data.end()));
    }
    double margin = (high - low) / 20;
    if (high == low) margin = axis.logarithmic ? 0.3 : low == 0 ? 1 : std::abs(low) / 10;
    AxisRange range{out(low - margin), out(high + margin)};
    if (axis.low) range.low = *axis.low;
    if (axis.high) range.high = *axis.high;
    return range;
}

std::vector<Tick> axisTicks(AxisRange range, bool logarithmic, int steps) {
    if (!logarithmic) return linearTicks(range, steps);
    std::vector<Tick> ticks = logarithmicTicks(range, steps);
    const auto named = std::count_if(ticks.begin(), ticks.end(),
                                     [](const Tick& tick) { return !tick.text.empty(); });
    // Too short for powers of ten.
    return named < 2 && range.high < 100 * range.low ? linearTicks(range, steps) : ticks;
}

}  // namespace plait
