#include "render/pictures/flip.h"
#include "slow_flip.h"
#include "studio.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

using namespace plait;
using namespace plait::test;

namespace {

Picture plain(int width, int height, int r, int g, int b) {
    Picture picture{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        for (const int c : {r, g, b}) picture.rgb.push_back(static_cast<std::uint8_t>(c));
    return picture;
}

double flipOf(const Picture& a, const Picture& b) {
    const FlipMap map = flip(a, b);
    // Plain colours differ alike everywhere, the border included.
    for (const double e : map.errors) REQUIRE(e == Approx(map.mean).epsilon(1e-9));
    return map.mean;
}

double worstAgainstSlow(const Picture& a, const Picture& b, double pixelsPerDegree) {
    const FlipMap map = flip(a, b, pixelsPerDegree);
    const auto slow = SlowFlip(pixelsPerDegree)(a, b);
    REQUIRE(map.errors.size() == slow.size());
    double worst = 0, mean = 0;
    for (std::size_t i = 0; i < slow.size(); ++i) {
        worst = std::max(worst, std::abs(map.errors[i] - slow[i]));
        mean += slow[i] / static_cast<double>(slow.size());
    }
    CHECK(map.mean == Approx(mean).epsilon(1e-6));
    return worst;
}

}  // namespace

TEST_CASE("FLIP of a picture and itself is 0, and its two sides are equal", "[flip]") {
    const Picture a = studio(64, 36), b = studio(64, 36, {.shift = 3});
    CHECK(flip(a, a).mean == 0);
    const FlipMap ab = flip(a, b), ba = flip(b, a);
    CHECK(ab.errors == ba.errors);
    CHECK(ab.mean > 0.01);
    for (const double e : ab.errors) REQUIRE((e >= 0 && e <= 1));
    CHECK_THROWS_AS(flip(a, studio(36, 64)), std::invalid_argument);
    CHECK_THROWS_AS(flip(Picture{}, Picture{}), std::invalid_argument);
}

TEST_CASE("FLIP of plain colours is what pencil and paper give", "[flip]") {
    const Picture black = plain(9, 7, 0, 0, 0), white = plain(9, 7, 255, 255, 255);
    // The largest difference, green to blue. L*a*b* of the two: (87.7362, -86.1787, 83.1826) and
    // (32.2982, 79.1936, -107.8586); chroma times L/100, then
    // |87.7362 - 32.2982| + |(-75.6099 - 25.5781, 72.9812 + 34.8364)|
    //   = 55.4380 + 147.8637 = 203.3017, and 203.3017^0.7 = 41.2761.
    REQUIRE(report("green to blue, against 1",
                   std::abs(flipOf(plain(9, 7, 0, 255, 0), plain(9, 7, 0, 0, 255)) - 1), 1e-8));
    // Black to white: L* from 0 to 100, 100^0.7 = 25.1189; beyond the knee at 0.4 of the largest:
    // 0.95 + 0.05 (25.1189 - 16.5104) / (41.2761 - 16.5104) = 0.967380.
    REQUIRE(report("black to white, against 0.967380", std::abs(flipOf(black, white) - 0.967380),
                   1e-6));
    // Grey 119 is 0.184475 of white's light: L* = 116 cbrt(0.184475) - 16 = 50.0344; from black,
    // 50.0344^0.7 = 15.46993, below the knee: 0.95 * 15.46993 / 16.51044 = 0.890130.
    REQUIRE(report("black to grey 119, against 0.890130",
                   std::abs(flipOf(black, plain(9, 7, 119, 119, 119)) - 0.890130), 1e-6));
    // Any two greys, by the same formulas.
    double worst = 0;
    for (const auto& [a, b] : {std::pair{0, 1}, {3, 8}, {100, 103}, {128, 136}, {250, 255}}) {
        const auto lightness = [](int grey) {
            const double y = slowDecode(grey / 255.0);
            return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : 24389.0 / 27 * y;
        };
        const double e = slowColorError(std::abs(lightness(a) - lightness(b)));
        worst = std::max(worst, std::abs(flipOf(plain(5, 5, a, a, a), plain(5, 5, b, b, b)) - e));
    }
    REQUIRE(report("greys, against the formula", worst, 1e-6));
}

TEST_CASE("FLIP agrees with the paper's formulas written out", "[flip]") {
    Random random(11);
    Picture noise{24, 20, {}}, other;
    for (int i = 0; i < 3 * 24 * 20; ++i)
        noise.rgb.push_back(static_cast<std::uint8_t>(random.below(256)));
    other = noise;
    for (auto& c : other.rgb)
        c = static_cast<std::uint8_t>(std::clamp(c + random.below(60) - 30, 0, 255));
    REQUIRE(report("noise, 67 pixels a degree", worstAgainstSlow(noise, other, flipPixelsPerDegree),
                   1e-6));
    const Picture a = studio(40, 24);
    REQUIRE(report("cloth moved by a pixel, 67 pixels a degree",
                   worstAgainstSlow(a, studio(40, 24, {.shift = 1}), flipPixelsPerDegree), 1e-6));
    REQUIRE(
        report("cloth mirrored, 30 pixels a degree", worstAgainstSlow(a, mirrored(a), 30), 1e-6));
    REQUIRE(report("cloth against black, 100 pixels a degree",
                   worstAgainstSlow(a, plain(40, 24, 0, 0, 0), 100), 1e-6));
    // Pure colours side by side: what the filters mix of them no screen can show.
    Picture pure = plain(40, 24, 0, 0, 0);
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 24; ++y)
            for (int k = 0; k < 3; ++k)
                pure.rgb[3 * (40 * y + x) + k] = ((x / 5 + 3 * (y / 6)) >> k) & 1 ? 255 : 0;
    REQUIRE(report("pure colours", worstAgainstSlow(pure, a, flipPixelsPerDegree), 1e-6));
}
