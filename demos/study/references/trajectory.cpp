#include "trajectory.h"

#include "demos/tools/errors.h"
#include "demos/tools/words.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plait {
namespace {

double squareAt(const Trajectory& a, const Trajectory& b, int frame, int moving) {
    const auto f = static_cast<std::size_t>(frame);
    if (f >= a.size() || f >= b.size() || a[f].size() != b[f].size())
        throw std::invalid_argument("trajectories: frame " + std::to_string(frame + 1) +
                                    " is missing or has other vertices");
    double sum = 0;
    for (std::size_t i = 0; i < a[f].size(); ++i) {
        const Vec<double> apart = a[f][i] - b[f][i];
        sum += dot(apart, apart);
    }
    return sum / moving;
}

double rootOf(double square) {
    return std::isfinite(square) ? std::sqrt(square) : std::numeric_limits<double>::infinity();
}

}  // namespace

double rmsDistance(const Trajectory& a, const Trajectory& b, int frames, int moving) {
    double sum = 0;
    for (int f = 0; f < frames; ++f) sum += squareAt(a, b, f, moving);
    return rootOf(sum / frames);
}

double rmsDistanceAt(const Trajectory& a, const Trajectory& b, int frame, int moving) {
    return rootOf(squareAt(a, b, frame, moving));
}

std::string csvOf(const Trajectory& trajectory) {
    std::string csv;
    for (std::size_t f = 0; f < trajectory.size(); ++f)
        for (std::size_t i = 0; i < trajectory[f].size(); ++i) {
            const Vec<double>& x = trajectory[f][i];
            csv += std::to_string(f + 1) + "," + std::to_string(i) + "," + text(x.x) + "," +
                   text(x.y) + "," + text(x.z) + "\n";
        }
    return csv;
}

Trajectory trajectoryFrom(const std::string& csv, const std::string& name) {
    Trajectory trajectory;
    const char *at = csv.data(), *const end = csv.data() + csv.size();
    const auto number = [&](auto& value, char after) {
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc{} || next == end || *next != after)
            throw FileError(name + ": not a trajectory");
        at = next + 1;
    };
    while (at != end) {
        std::size_t frame = 0, vertex = 0;
        Vec<double> x;
        number(frame, ','), number(vertex, ',');
        number(x.x, ','), number(x.y, ','), number(x.z, '\n');
        if (frame == trajectory.size() + 1) trajectory.emplace_back();
        if (frame != trajectory.size() || vertex != trajectory.back().size())
            throw FileError(name + ": a frame or a vertex is missing");
        trajectory.back().push_back(x);
    }
    return trajectory;
}

}  // namespace plait
