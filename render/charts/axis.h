// From numbers to places along an axis, and the round numbers beside it.
#pragma once

#include "chart.h"

#include <span>

namespace plait {

struct AxisRange {
    double low, high;
};

// Places from `from` (at range.low) to `to` (at range.high), px.
struct AxisScale {
    AxisRange range;
    bool logarithmic;
    double from, to;

    double operator()(double value) const;
};

// What the axis is given, and else the data with a margin of a twentieth; round the middle where
// all data are one number. Finite, low < high, positive on a logarithmic axis.
AxisRange axisRange(const Axis& axis, std::span<const double> data);

struct Tick {
    double value;
    std::string text;  // empty: a line without a number
};

// Round numbers within the range, at most `steps` >= 1 steps from one number to the next: 1, 2 or 5
// times a power of ten; on a logarithmic axis powers of ten, with lines at 2 ... 9 of each where
// all powers are shown, and with the numbers 2 and 5 where the range is less than two decades.
// {low} for a range that is empty or not finite.
std::vector<Tick> axisTicks(AxisRange range, bool logarithmic, int steps);

}  // namespace plait
