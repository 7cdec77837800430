#include "flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plait {
namespace {

using std::numbers::pi;
using Channels = std::array<double, 3>;
using Plane = std::vector<double>;
using Planes = std::array<Plane, 3>;

// sRGB's primaries and white to XYZ, in exact fractions; `white` is the image of (1, 1, 1).
constexpr double toXyz[3][3] = {
    {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
    {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
    {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
constexpr Channels white{0.950428545, 1, 1.088900371};
constexpr double fromXyz[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                  {-0.969224334, 1.875930071, 0.041554224},
                                  {0.055639423, -0.204011202, 1.057148933}};

Channels times(const double (&m)[3][3], const Channels& c) {
    Channels result;
    for (int i = 0; i < 3; ++i) result[i] = m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2];
    return result;
}

double decode(double s) { return s > 0.04045 ? std::pow((s + 0.055) / 1.055, 2.4) : s / 12.92; }

// Section 4.1.1: L*a*b* without its cube roots, which keeps filtering linear in light.
Channels toOpponent(const Channels& linear) {
    const Channels c = times(toXyz, linear);
    const double x = c[0] / white[0], y = c[1] / white[1], z = c[2] / white[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Channels fromOpponent(const Channels& c) {
    const double y = (c[0] + 16) / 116, x = y + c[1] / 500, z = y - c[2] / 200;
    return times(fromXyz, {x * white[0], y * white[1], z * white[2]});
}

// Section 4.1.2: L*a*b*, its chroma scaled by lightness (Hunt's effect).
Channels toHuntLab(const Channels& linear) {
    Channels f = times(toXyz, linear);
    constexpr double delta = 6.0 / 29;
    for (int i = 0; i < 3; ++i) {
        const double v = f[i] / white[i];
        f[i] = v > delta * delta * delta ? std::cbrt(v) : v / (3 * delta * delta) + 4.0 / 29;
    }
    const double L = 116 * f[1] - 16;
    return {L, 0.01 * L * 500 * (f[0] - f[1]), 0.01 * L * 200 * (f[1] - f[2])};
}

double hyab(const Channels& a, const Channels& b) {
    return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// Rows by `across`, columns by `down`, both centred.
Plane convolve(const Plane& plane, int width, int height, const std::vector<double>& across,
               const std::vector<double>& down) {
    const int r = static_cast<int>(across.size()) / 2;
    Plane rows(plane.size()), result(plane.size());
    std::vector<double> row(width + 2 * r);
    for (int y = 0; y < height; ++y) {
        for (int x = -r; x < width + r; ++x)
            row[x + r] = plane[y * width + std::clamp(x, 0, width - 1)];
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int k = 0; k <= 2 * r; ++k) sum += across[k] * row[x + k];
            rows[y * width + x] = sum;
        }
    }
    for (int y = 0; y < height; ++y)
        for (int k = -r; k <= r; ++k) {
            const double* from = &rows[std::clamp(y + k, 0, height - 1) * width];
            for (int x = 0; x < width; ++x) result[y * width + x] += down[k + r] * from[x];
        }
    return result;
}

template <class Function>
std::vector<double> sample(int r, Function f) {
    std::vector<double> values;
    for (int i = -r; i <= r; ++i) values.push_back(f(static_cast<double>(i)));
    return values;
}

double sum(const std::vector<double>& values) {
    double total = 0;
    for (const double v : values) total += v;
    return total;
}

// Section 4.1.1, table 1: what an eye resolves of a channel, as Gaussians a sqrt(pi/b)
// exp(-pi² x²/b), x in degrees. Each is a product of one along rows and one along columns.
struct Gaussian {
    double a, b;
};

Plane blur(const Plane& plane, int width, int height, const std::vector<Gaussian>& gaussians,
           double pixelsPerDegree) {
    const int r =
        static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixelsPerDegree));
    Plane result(plane.size());
    double total = 0;
    for (const Gaussian& gaussian : gaussians) {
        const double scale = gaussian.a * std::sqrt(pi / gaussian.b);
        auto down = sample(r, [&](double i) {
            const double x = i / pixelsPerDegree;
            return std::exp(-pi * pi * x * x / gaussian.b);
        });
        auto across = down;
        for (double& v : across) v *= scale;
        total += sum(across) * sum(down);
        const Plane part = convolve(plane, width, height, across, down);
        for (std::size_t i = 0; i < part.size(); ++i) result[i] += part[i];
    }
    for (double& v : result) v /= total;
    return result;
}

// Section 4.2: the strength of edges (order 1) or points (order 2), from derivatives of a Gaussian
// whose positive and negative weights sum to 1 and -1.
Plane features(const Plane& y, int width, int height, int order, double pixelsPerDegree) {
    const double sd = 0.5 * 0.082 * pixelsPerDegree;
    const int r = static_cast<int>(std::ceil(3 * sd));
    const auto gauss = sample(r, [&](double i) { return std::exp(-i * i / (2 * sd * sd)); });
    auto derivative = sample(r, [&](double i) {
        const double factor = order == 1 ? -i : i * i / (sd * sd) - 1;
        return factor * std::exp(-i * i / (2 * sd * sd));
    });
    double positive = 0, negative = 0;
    for (const double v : derivative) (v > 0 ? positive : negative) += std::abs(v);
    for (double& v : derivative) v /= (v > 0 ? positive : negative) * sum(gauss);
    Plane result = convolve(y, width, height, derivative, gauss);
    const Plane down = convolve(y, width, height, gauss, derivative);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::hypot(result[i], down[i]);
    return result;
}

struct Seen {
    std::vector<Channels> colors;  // filtered, in Hunt-adjusted L*a*b*
    Plane edges, points;
};

Seen see(const Picture& picture, double pixelsPerDegree) {
    const int width = picture.width, height = picture.height, n = width * height;
    std::array<double, 256> linear;
    for (int i = 0; i < 256; ++i) linear[i] = decode(i / 255.0);
    Planes planes;
    for (int i = 0; i < n; ++i) {
        const std::uint8_t* rgb = &picture.rgb[3 * i];
        const Channels c = toOpponent({linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]});
        for (int k = 0; k < 3; ++k) planes[k].push_back(c[k]);
    }
    const Planes filtered{
        blur(planes[0], width, height, {{1, 0.0047}}, pixelsPerDegree),
        blur(planes[1], width, height, {{1, 0.0053}}, pixelsPerDegree),
        blur(planes[2], width, height, {{34.1, 0.04}, {13.5, 0.025}}, pixelsPerDegree)};
    Seen seen;
    for (int i = 0; i < n; ++i) {
        Channels c = fromOpponent({filtered[0][i], filtered[1][i], filtered[2][i]});
        for (double& v : c) v = std::clamp(v, 0.0, 1.0);
        seen.colors.push_back(toHuntLab(c));
    }
    for (double& v : planes[0]) v = (v + 16) / 116;
    seen.edges = features(planes[0], width, height, 1, pixelsPerDegree);
    seen.points = features(planes[0], width, height, 2, pixelsPerDegree);
    return seen;
}

// Section 4.1.3: q_c = 0.7; differences below p_c = 0.4 of the largest that sRGB has, green to
// blue, fill p_t = 0.95 of the range.
double colorError(double distance) {
    static const double largest = std::pow(hyab(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1})), 0.7);
    const double e = std::pow(distance, 0.7), knee = 0.4 * largest;
    return e < knee ? 0.95 * e / knee : 0.95 + 0.05 * (e - knee) / (largest - knee);
}

}  // namespace

FlipMap flip(const Picture& a, const Picture& b, double pixelsPerDegree) {
    if (a.width != b.width || a.height != b.height || a.rgb.empty())
        throw std::invalid_argument("FLIP compares two pictures of the same size");
    const Seen seenA = see(a, pixelsPerDegree), seenB = see(b, pixelsPerDegree);
    FlipMap map{.width = a.width, .height = a.height};
    for (std::size_t i = 0; i < seenA.colors.size(); ++i) {
        const double color = colorError(hyab(seenA.colors[i], seenB.colors[i]));
        const double change = std::max(std::abs(seenA.edges[i] - seenB.edges[i]),
                                       std::abs(seenA.points[i] - seenB.points[i]));
        const double feature = std::sqrt(change / std::numbers::sqrt2);  // q_f = 0.5
        map.errors.push_back(std::pow(color, 1 - feature));              // section 4.3
    }
    map.mean = sum(map.errors) / static_cast<double>(map.errors.size());
    return map;
}

}  // namespace plait
