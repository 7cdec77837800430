// Pictures of any shape hold their subject, whatever flag or body a user brings, and their words.
#include "render/camera.h"
#include "render/pictures/caption.h"
#include "render/pictures/contact_sheet.h"
#include "render/pictures/legend.h"
#include "render/pictures/paint.h"
#include "render/renderer.h"
#include "scenes/ballerina/ballerina.h"
#include "scenes/scene.h"
#include "studio.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/scratch_folder.h"

#include <plait/solver.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

using namespace plait;
using namespace plait::test;

namespace {

using Positions = std::vector<Vec<double>>;

constexpr std::array aspects{9.0f / 21, 9.0f / 16, 0.8f, 1.0f, 4.0f / 3, 16.0f / 9, 21.0f / 9};

// Where points are seen, in half pictures from the middle.
struct Seen {
    glm::vec2 low{1e9f}, high{-1e9f};

    float outermost() const { return std::max({-low.x, -low.y, high.x, high.y}); }
};

Seen seen(const View& view, std::span<const Vec<double>> points, double t, float aspect) {
    const glm::mat4 camera = poseOf(view, t).framed(aspect).matrix(aspect);
    Seen result;
    for (const Vec<double>& x : points) {
        const glm::vec4 p = camera * glm::vec4(x.x, x.y, x.z, 1);
        const glm::vec2 place = p.w > 0 ? glm::vec2(p) / p.w : glm::vec2(1e9f);
        result.low = glm::min(result.low, place);
        result.high = glm::max(result.high, place);
    }
    return result;
}

// How far out the outermost point is in the worst of all shapes of pictures.
float outermost(const View& view, std::span<const Vec<double>> points, double t) {
    float worst = 0;
    for (const float aspect : aspects)
        worst = std::max(worst, seen(view, points, t, aspect).outermost());
    return worst;
}

Scene sceneWith(const std::string& name, const std::string& knob = "", const std::string& text = "",
                double waist = 1.05) {
    const SceneEntry& entry = findScene(name);
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    if (!knob.empty()) knobs.texts[knob] = text;
    if (knob == "body") knobs.numbers["waist"] = waist, knobs.numbers["rate"] = 1;
    return entry.build(knobs);
}

void writeObj(const std::filesystem::path& path, const Positions& positions,
              const std::vector<std::array<int, 3>>& triangles) {
    std::ofstream out(path);
    for (const Vec<double>& x : positions) out << "v " << x.x << ' ' << x.y << ' ' << x.z << '\n';
    for (const auto& [a, b, c] : triangles)
        out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
}

struct Body {
    const char* name;
    double height;
    Vec<double> place;
    Vec<double> way{0, 0, 0};
    double across = 1;  // as wide as a figure of its height, times this
};

// Like a chess pawn, closed.
void writeBody(const ScratchFolder& folder, const Body& body) {
    constexpr int sides = 24, rings = 40, poses = 5;
    std::vector<std::array<int, 3>> triangles;
    const auto vertex = [](int ring, int side) { return 1 + ring * sides + side % sides; };
    for (int k = 0; k < sides; ++k) {
        triangles.push_back({0, vertex(0, k + 1), vertex(0, k)});
        for (int r = 0; r + 1 < rings; ++r) {
            triangles.push_back({vertex(r, k), vertex(r, k + 1), vertex(r + 1, k + 1)});
            triangles.push_back({vertex(r, k), vertex(r + 1, k + 1), vertex(r + 1, k)});
        }
        triangles.push_back({vertex(rings - 1, k), vertex(rings - 1, k + 1), 1 + rings * sides});
    }
    for (int pose = 0; pose < poses; ++pose) {
        const Vec<double> foot = body.place + (pose / (poses - 1.0)) * body.way;
        Positions x{foot};
        for (int r = 0; r < rings; ++r)
            for (int k = 0; k < sides; ++k) {
                const double s = (r + 0.5) / rings, a = 2 * std::numbers::pi * k / sides;
                const double radius = body.height * (0.07 + 0.025 * std::cos(12 * s));
                x.push_back(foot + Vec<double>{body.across * radius * std::cos(a), s * body.height,
                                               -radius * std::sin(a)});
            }
        x.push_back(foot + Vec<double>{0, body.height, 0});
        writeObj(folder / (std::string(body.name) + std::to_string(pose) + ".obj"), x, triangles);
    }
}

// A cloth that hangs in the plane of the pole, turned down by so much from where it streams.
Positions drooped(const Positions& rest, double angle) {
    double left = 1e9;
    for (const Vec<double>& x : rest) left = std::min(left, x.x);
    Positions result;
    for (const Vec<double>& x : rest) {
        const double along = x.x - left;
        result.push_back({left + along * std::cos(angle), x.y - along * std::sin(angle), x.z});
    }
    return result;
}

// Rows in which something is much brighter than the strip.
int linesOfText(const Picture& picture, int from) {
    int lines = 0;
    bool before = false;
    for (int y = from; y < picture.height; ++y) {
        const auto row = picture.rgb.begin() + 3 * y * picture.width;
        const bool text = *std::max_element(row, row + 3 * picture.width) > 0x90;
        lines += text && !before;
        before = text;
    }
    return lines;
}

}  // namespace

TEST_CASE("a picture of any shape holds what its scene is about", "[render][strangers]") {
    for (const char* name : {"flag", "dress", "pendulum", "strip-in-wind", "band"}) {
        INFO(name);
        const Scene scene = sceneWith(name);
        Solver<float> solver(scene.world, scene.options);
        const int frames = scene.lead > 0 ? 0 : 2;
        for (int frame = 0; frame <= frames; ++frame) {
            if (frame > 0) solver.frame();
            CHECK(report(std::string(name) + ": outermost, of half the picture",
                         outermost(scene.view, solver.positions(), solver.time()), 0.97));
        }
    }
}

TEST_CASE("a picture of any shape holds the dancer through her dance", "[render][strangers]") {
    const Scene scene = sceneWith("dress");
    const Ballerina dancer;
    float worst = 0, least = 2;
    for (double t = 0; t <= Ballerina::seconds; t += 0.25) {
        const Positions x = dancer.positions(t);
        worst = std::max(worst, outermost(scene.view, x, t));
        const Seen upright = seen(scene.view, x, t, 9.0f / 16);
        least = std::min(least,
                         std::max(upright.high.x - upright.low.x, upright.high.y - upright.low.y));
    }
    CHECK(report("outermost, of half the picture", worst, 0.99));
    // She is no dwarf in it.
    CHECK(report("of a picture of 9:16 empty at most", 1 - least / 2, 0.7));
}

TEST_CASE("a picture of 16:9 or wider is seen as high as ever", "[render][strangers]") {
    const CameraPose pose = poseOf(sceneWith("pendulum").view, 0);
    for (const float aspect : {16.0f / 9, 1280.0f / 720, 21.0f / 9, 4.0f, 480.0f})
        CHECK(pose.framed(aspect).fieldOfView == pose.fieldOfView);
    // A camera that says nothing of its subject keeps its whole width.
    const CameraPose plain{{0, 0, 5}, {0, 0, 0}, 0.5f};
    for (const float aspect : {16.0f / 9, 1.0f, 0.1f})
        CHECK(plain.framed(aspect).matrix(aspect)[0][0] ==
              Approx(plain.matrix(16.0f / 9)[0][0]).epsilon(1e-5));
}

TEST_CASE("the camera finds a body of the user's own", "[render][strangers]") {
    const ScratchFolder folder;
    for (const Body& body :
         {Body{"away", 1.7, {5, 0, 3}}, Body{"child", 1.2, {-2, 0, 1}},
          Body{"giant", 2.3, {3, 0.5, -40}}, Body{"broad", 1.7, {0, 0, 0}, {0, 0, 0}, 4},
          Body{"walks", 1.7, {-1, 0, 2}, {8, 0, -3}}, Body{"nears", 1.7, {0, 0, 0}, {0, 0, 8}}}) {
        INFO(body.name);
        writeBody(folder, body);
        const Scene scene =
            sceneWith("dress", "body", (folder / (std::string(body.name) + "*.obj")).string(),
                      0.6 * body.height);
        const Range skin = scene.view.looks[2].object;
        float worst = outermost(scene.view, scene.world.start, 0);
        for (int pose = 0; pose < 5; ++pose) {
            const double t = scene.seconds * pose / 4;
            Positions x(scene.world.start.begin() + skin.first,
                        scene.world.start.begin() + skin.last);
            for (Vec<double>& p : x) p += (pose / 4.0) * body.way;
            worst = std::max(worst, outermost(scene.view, x, t));
            const Seen wide = seen(scene.view, x, t, 16.0f / 9);
            CHECK(std::abs(wide.low.x + wide.high.x) / 2 < 0.2f);
            CHECK(wide.high.y - wide.low.y > 0.9f);
        }
        CHECK(report(std::string(body.name) + ": outermost, of half the picture", worst, 0.99));
        CHECK(scene.view.groundHeight == Approx(body.place.y));
    }
}

TEST_CASE("the camera finds a flag of any size", "[render][strangers]") {
    const ScratchFolder folder;
    struct Cloth {
        const char* name;
        double width, height;
    };
    for (const Cloth& c :
         {Cloth{"banner", 0.5, 3}, {"streamer", 6, 0.4}, {"sail", 8, 5}, {"pennon", 0.1, 0.06}}) {
        INFO(c.name);
        const Shape sheet = grid({.columns = 13, .rows = 9, .width = c.width, .height = c.height});
        std::vector<std::array<int, 3>> triangles;
        for (int t = 0; t < sheet.complex.count(2); ++t)
            triangles.push_back(sheet.complex.triangle(t));
        writeObj(folder / "flag.obj", sheet.positions, triangles);
        const Scene scene = sceneWith("flag", "mesh", (folder / "flag.obj").string());
        float worst = 0;
        for (const double t : {0.0, scene.seconds}) {
            worst = std::max(worst, outermost(scene.view, scene.world.start, t));
            for (const double angle : {0.0, 0.15, 0.3})  // as its own does
                worst = std::max(worst, outermost(scene.view, drooped(scene.world.rest, angle), t));
        }
        CHECK(report(std::string(c.name) + ": outermost, of half the picture", worst, 0.99));
        for (const float aspect : {9.0f / 16, 16.0f / 9}) {
            const Seen place = seen(scene.view, scene.world.rest, 0, aspect);
            CHECK(std::max(place.high.x - place.low.x, place.high.y - place.low.y) > 0.6f);
        }
        // The pole suits it, and has no end.
        const Positions& ball = scene.view.props[2].shape.positions;
        CHECK(outermost(scene.view, ball, scene.seconds) < 1);
        const Seen knob = seen(scene.view, ball, 0, 16.0f / 9),
                   cloth = seen(scene.view, scene.world.rest, 0, 16.0f / 9);
        CHECK(knob.high.y - knob.low.y < 0.7f * std::max(cloth.high.y - cloth.low.y, 0.1f));
        double lowest = 0;
        for (const Prop& prop : scene.view.props)
            for (const Vec<double>& x : prop.shape.positions) lowest = std::min(lowest, x.y);
        CHECK(lowest < -10 * std::max(c.width, c.height));
    }
}

TEST_CASE("an upright picture of the flag shows it from pole to free end", "[render][strangers]") {
    const Scene scene = sceneWith("flag");
    const Picture picture =
        Renderer(scene, {.width = 90, .height = 160}).draw(scene.world.start, 0);
    int red = 0, atEdge = 0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 90; ++x) {
            const std::uint8_t* rgb = &picture.rgb[3 * (y * 90 + x)];
            if (rgb[0] < 130 || rgb[1] > 70 || rgb[2] > 60) continue;
            ++red;
            atEdge += x == 0 || x == 89;
        }
    CHECK(atEdge == 0);
    CHECK(red > 1000);
}

TEST_CASE("pictures of the most extreme shapes are drawn", "[render][strangers]") {
    const Scene scene = sceneWith("pendulum");
    for (const auto& [width, height] : {std::array{16, 2048}, {2048, 16}, {16, 16}}) {
        const Picture picture = Renderer(scene, {.width = width, .height = height, .samples = 1})
                                    .draw(scene.world.start, 0);
        const auto [low, high] = std::ranges::minmax(picture.rgb);
        CHECK(low < 60);
        CHECK(high > 120);
    }
}

TEST_CASE("a caption too long for an upright picture stands in lines", "[image][strangers]") {
    const Caption caption{
        "Ballerina's dress",
        "xpbd · 24 substeps · strain 1.84 % · crossings 0.00 · 1033.3 ms a frame"};
    for (const auto& [width, height] : {std::array{360, 640}, {640, 640}, {411, 960}}) {
        Picture picture = filled(width, height, {0, 0, 0});
        drawCaption(picture, caption);
        const int top = static_cast<int>(std::find_if(picture.rgb.begin(), picture.rgb.end(),
                                                      [](int c) { return c > 0; }) -
                                         picture.rgb.begin()) /
                        (3 * width);
        CHECK(linesOfText(picture, top + 4) >= 2);
        CHECK(height - top < height / 6);
        const int margin = static_cast<int>(0.05 * width);
        for (int y = top + 4; y < height; ++y)
            for (int x = 0; x < margin; ++x) {
                REQUIRE(picture.rgb[3 * (y * width + x)] < 0x20);
                REQUIRE(picture.rgb[3 * (y * width + width - 1 - x)] < 0x20);
            }
    }
}

TEST_CASE("a legend lies within a picture of any shape", "[image][strangers]") {
    for (const auto& [width, height] : {std::array{274, 640}, {120, 640}, {1280, 80}}) {
        Picture picture = filled(width, height, {0, 0, 0});
        drawLegend(picture, {"Stretch", "%", 0, 4});
        int left = width, low = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (picture.rgb[3 * (y * width + x)] > 0) left = std::min(left, x), low = y;
        CHECK(left > 0);
        CHECK(left < width);
        CHECK(low < height - 1);
    }
}

TEST_CASE("a contact sheet of upright pictures is one glance", "[image][strangers]") {
    for (const auto& [width, height] :
         {std::array{45, 80}, {60, 60}, {80, 45}, {105, 45}, {160, 40}, {320, 20}}) {
        const std::vector<SheetFrame> frames(12, {studio(width, height), 0.5});
        const Picture sheet = contactSheet(frames, "Flag", 480);
        CHECK(sheet.height < 1.1 * 480);
        CHECK(sheet.height > 160);
    }
}
