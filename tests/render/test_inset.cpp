#include "drawn.h"
#include "render/pictures/inset.h"
#include "render/pictures/paint.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <cmath>
#include <limits>

using namespace plait;
using namespace plait::test;

namespace {

// A hill whose numbers on x are none of those on y.
InsetChart hill(std::vector<ChartPoint> trail) {
    InsetChart inset{.x = "stretch", .y = "pressure [kPa]", .curve = {}, .trail = std::move(trail)};
    for (double x = 10; x <= 50; ++x)
        inset.curve.push_back({x, 3 - std::pow((x - 30) / 20, 2) * 3});
    return inset;
}

// The middle of all that is vermilion, pixels.
PagePoint vermilionMiddle(const Picture& picture, int& count) {
    PagePoint sum{0, 0};
    count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (same(pixel(picture, x, y), vermilion)) {
                sum.x += x + 0.5;
                sum.y += y + 0.5;
                ++count;
            }
    return {sum.x / count, sum.y / count};
}

}  // namespace

TEST_CASE("the inset's dot lands where its axes say", "[image][inset]") {
    const ChartPoint at{37.5, 1.75};
    const InsetChart inset = hill({{12, 0.5}, {20, 1}, at});
    const Drawing drawing = insetDrawing(inset);
    const double x = across(drawing, "20", "40", (at.x - 20) / 20),
                 y = up(drawing, "1", "3", (at.y - 1) / 2);
    for (const double unit : {1.0, 1.5}) {
        Picture picture = filled(static_cast<int>(1280 * unit), static_cast<int>(720 * unit), ink);
        drawInset(picture, inset, 10);
        int count;
        const PagePoint dot = vermilionMiddle(picture, count);
        CHECK(count > 40);
        const double left = picture.width - unit * (40 + drawing.width), top = unit * 50;
        CHECK(report("dot from its place across, pixels", std::abs(dot.x - left - unit * x), 0.5));
        CHECK(report("dot from its place up, pixels", std::abs(dot.y - top - unit * y), 0.5));
    }
    for (const char* label : {"stretch", "pressure [kPa]"}) CHECK_NOTHROW(wordOf(drawing, label));
}

TEST_CASE("the inset's axes stand still while the dot moves, and hide what lies beyond them",
          "[image][inset]") {
    const auto strokes = [](const InsetChart& inset) { return every<Stroke>(insetDrawing(inset)); };
    const auto none = strokes(hill({}));
    const auto some = strokes(hill({{12, 0.5}, {20, 1}, {90, 2}}));
    REQUIRE(some.size() == none.size() + 1);
    for (std::size_t i = 0; i < none.size(); ++i)
        for (std::size_t k = 0; k < none[i].points.size(); ++k) {
            CHECK(some[i].points[k].x == none[i].points[k].x);
            CHECK(some[i].points[k].y == none[i].points[k].y);
        }
    // The way to 90 ends at the right edge, where the grid does, and there is no dot.
    CHECK(some.back().points.back().x == Approx(none[none.size() - 2].points.back().x));
    CHECK(every<Disc>(insetDrawing(hill({{12, 0.5}, {90, 2}}))).empty());
    CHECK(every<Disc>(insetDrawing(hill({}))).empty());

    // What is no number is a gap.
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto gap = strokes(hill({{12, 0.5}, {20, 1}, {nan, 1}, {22, 1}, {24, 2}}));
    CHECK(gap.size() == none.size() + 2);
    CHECK(every<Disc>(insetDrawing(hill({{12, 0.5}, {nan, 1}}))).empty());
}
