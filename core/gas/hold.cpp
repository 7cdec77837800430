#include "hold.h"

#include "../constraints/volume.h"
#include "../measure/surfaces/geometry.h"
#include "../numbers/elementary.h"
#include "../sets/sum_set.h"

#include <cmath>
#include <stdexcept>

namespace plait {
namespace {

Sums<Volume> volumeOf(const Enclosure& enclosure, const SumLaw& law) {
    Rows<Volume> rows;
    for (const auto& triangle : enclosure.triangles) {
        rows.ids.insert(rows.ids.end(), triangle.begin(), triangle.end());
        rows.rows.push_back({});
    }
    Sums<Volume> sums;
    sums.add(rows, law);
    return sums;
}

void check(const std::string& name, const char* what, double value, bool sound) {
    if (!sound || !std::isfinite(value))
        throw std::invalid_argument(name + ": " + what + " is " + std::to_string(value));
}

void check(const std::string& name, const Gas& gas) {
    check(name, "the amount of gas", gas.amount, gas.amount >= 0);
    check(name, "the gas's reference volume", gas.reference, gas.reference > 0);
    check(name, "the pressure outside", gas.outside, gas.outside >= 0);
    check(name, "the gas's exponent", gas.exponent, gas.exponent > 1);
}

// Of a ball of as much area.
double mostVolume(const World& world, const Enclosure& enclosure) {
    const double size = area(world.rest, enclosure.triangles);
    return size * squareRoot(size / (36 * pi));
}

}  // namespace

void holdGas(World& world, const Enclosure& enclosure, const Gas& gas, SetOptions options) {
    check(options.name, gas);
    holdGas(world, enclosure, [gas](double) { return gas; }, std::move(options));
}

void holdGas(World& world, const Enclosure& enclosure, std::function<Gas(double t)> gasAt,
             SetOptions options) {
    Sums<Volume> sums = volumeOf(enclosure, {});
    const double least = 1e-6 * mostVolume(world, enclosure);
    sums.law = [least, gasAt = std::move(gasAt), name = options.name](int, double value, double t) {
        const Gas gas = gasAt(t);
        check(name, gas);
        const double v = value > least ? value : least;
        return SumLaw{
            .rest = v, .load = gas.gauge(v), .softness = 1, .stiffness = gas.stiffness(v)};
    };
    constrainSums(world, std::move(sums), std::move(options));
}

void holdVolume(World& world, const Enclosure& enclosure, double volume, SetOptions options) {
    check(options.name, "the volume to hold", volume, volume >= 0);
    constrainSums(world, volumeOf(enclosure, {.rest = volume}), std::move(options));
}

}  // namespace plait
