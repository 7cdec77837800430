// Flags and bodies as strangers bring them: what the scene makes of them, and what it says.
#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/report.h"
#include "tests/scratch_folder.h"

#include <plait/solver.h>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace plait;
using plait::test::report;
using plait::test::ScratchFolder;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// Quads of `columns` x `rows` vertices, counted from `first`.
void writeQuads(std::ostream& out, int columns, int rows, int first = 1) {
    for (int r = 0; r + 1 < rows; ++r)
        for (int c = 0; c + 1 < columns; ++c) {
            const int v = first + r * columns + c;
            out << "f " << v << ' ' << v + 1 << ' ' << v + columns + 1 << ' ' << v + columns
                << '\n';
        }
}

void writeSheet(std::ostream& out, int columns, int rows, double width, double height,
                double left = 0) {
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            out << "v " << left + width * c / (columns - 1) << ' ' << height * r / (rows - 1)
                << " 0\n";
}

Scene sceneOf(const std::string& name, const std::string& knob, const std::string& value,
              const std::map<std::string, double>& numbers = {}) {
    const SceneEntry& entry = findScene(name);
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    knobs.texts[knob] = value;
    for (const auto& [number, is] : numbers) knobs.numbers[number] = is;
    return entry.build(knobs);
}

std::string refusal(const std::string& name, const std::string& knob, const std::string& value,
                    const std::map<std::string, double>& numbers = {}) {
    try {
        sceneOf(name, knob, value, numbers);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "accepted";
}

double atStart(const Scene& scene, const std::string& metric) {
    const Snapshot start{scene.world.start, scene.world.velocity, 0, 0};
    const auto found = std::ranges::find(scene.metrics, metric, &Metric::name);
    return found->measure(start);
}

int pinned(const Scene& scene) {
    return static_cast<int>(std::ranges::count(scene.world.pinned, 1));
}

// A figure turned on a lathe, closed, on the floor.
struct Figure {
    double height = 1.7, scale = 1;
    bool inward = false, split = false;  // facing inward; with a seam from head to foot
    Vec<double> at{0, 0, 0};

    void write(std::ostream& out) const {
        constexpr int sides = 16, rings = 18;
        const int columns = split ? sides + 1 : sides;
        out.precision(9);
        const auto point = [&](double x, double y, double z) {
            out << "v " << scale * (at.x + x) << ' ' << scale * (at.y + y) << ' '
                << scale * (at.z + z) << '\n';
        };
        const auto face = [&](int a, int b, int c) {
            out << "f " << a + 1 << ' ' << (inward ? c : b) + 1 << ' ' << (inward ? b : c) + 1
                << '\n';
        };
        for (int r = 0; r <= rings; ++r)
            for (int s = 0; s < columns; ++s) {
                const double y = height * r / rings, turn = 2 * 3.14159265358979 * s / sides;
                const double radius = 0.08 * height * std::sin(3.14159 * (r + 0.5) / (rings + 1));
                point(radius * std::cos(turn), y, -radius * std::sin(turn));
            }
        const int foot = columns * (rings + 1), head = foot + 1;
        point(0, 0, 0);
        point(0, height, 0);
        for (int s = 0; s < sides; ++s) {
            const int next = split ? s + 1 : (s + 1) % sides;
            for (int r = 0; r < rings; ++r) {
                const int a = r * columns + s, b = r * columns + next;
                face(a, b, b + columns);
                face(a, b + columns, a + columns);
            }
            face(foot, next, s);
            face(head, rings * columns + s, rings * columns + next);
        }
    }
};

Scene dressed(const ScratchFolder& folder, const Figure& figure,
              const std::map<std::string, double>& numbers = {}) {
    for (const char* name : {"body1.obj", "body2.obj"}) {
        std::ofstream out(folder / name);
        figure.write(out);
    }
    return sceneOf("dress", "body", (folder / "body*.obj").string(), numbers);
}

}  // namespace

TEST_CASE("flag: stray vertices neither hold it nor hide it", "[flag][strangers]") {
    const ScratchFolder folder;
    const std::string file = (folder / "flag.obj").string();
    for (const char* stray : {"v -3 0 0\n", "v 0.5 9 0\n", "v 0 0 -40\n"}) {
        {
            std::ofstream out(file);
            out << stray;
            writeSheet(out, 20, 12, 1.9, 1.2);
            writeQuads(out, 20, 12, 2);
        }
        const Scene scene = sceneOf("flag", "mesh", file);
        CHECK(scene.world.rest.size() == 240);
        CHECK(pinned(scene) == 12);
        REQUIRE(scene.world.warnings.size() == 1);
        CHECK(scene.world.warnings[0] ==
              file + ": vertex 1 is on no triangle or edge and left out");
    }
}

TEST_CASE("flag: halves that touch are one, and parts that do not are told", "[flag][strangers]") {
    const ScratchFolder folder;
    const std::string file = (folder / "flag.obj").string();
    const auto write = [&](double gap) {
        std::ofstream out(file);
        writeSheet(out, 10, 12, 0.9, 1.2);
        writeSheet(out, 10, 12, 0.9, 1.2, 0.9 + gap);
        writeQuads(out, 10, 12);
        writeQuads(out, 10, 12, 121);
    };
    write(0);
    const Scene welded = sceneOf("flag", "mesh", file);
    CHECK(welded.world.rest.size() == 228);
    REQUIRE(welded.world.warnings.size() == 1);
    CHECK(has(welded.world.warnings[0], "12 vertices, the first 121, are where others are (10)"));
    write(0.3);
    const Scene apart = sceneOf("flag", "mesh", file);
    REQUIRE(apart.world.warnings.size() == 1);
    CHECK(has(apart.world.warnings[0], "fly off: 1, the first that of vertex 121"));
}

TEST_CASE("flag: of any size it begins free of itself", "[flag][strangers]") {
    const ScratchFolder folder;
    const std::string file = (folder / "flag.obj").string();
    const auto write = [&](double width, double height) {
        std::ofstream out(file);
        writeSheet(out, 40, 20, width, height);
        writeQuads(out, 40, 20);
    };
    for (const auto& [width, height] :
         {std::pair{8.0, 5.0}, {25.0, 2.0}, {0.3, 2.5}, {0.1, 0.06}}) {
        write(width, height);
        const Scene scene = sceneOf("flag", "mesh", file);
        CHECK(atStart(scene, "crossings") == 0);
        CHECK(scene.world.warnings.empty());
    }
    write(192, 120);
    CHECK(refusal("flag", "mesh", file) ==
          file + ": 192 m across, where 0.05 to 30 m are of use: is it in centimetres?");
}

TEST_CASE("flag: a mesh that crosses itself is refused where it would be held",
          "[flag][strangers]") {
    const ScratchFolder folder;
    const std::string file = (folder / "flag.obj").string();
    {
        std::ofstream out(file);
        writeSheet(out, 20, 12, 1.9, 1.2);
        out << "v 0.75 0.4 -0.2\nv 0.8 0.62 0.3\nv 0.85 0.4 0.3\n";
        writeQuads(out, 20, 12);
        out << "f 241 242 243\n";
    }
    CHECK(has(refusal("flag", "mesh", file), file + ": it crosses itself at the start"));
    const SceneEntry& entry = findScene("flag");
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    knobs.texts["mesh"] = file;
    knobs.texts["self-collision"] = "off";
    CHECK(entry.build(knobs).world.rest.size() == 243);
}

TEST_CASE("dress: a body as exporters leave it is worn", "[dress][strangers]") {
    const ScratchFolder folder;
    const Scene whole = dressed(folder, {});
    CHECK(whole.world.warnings.empty());
    const auto sameBody = [&](const Scene& scene) {
        return scene.world.start.size() == whole.world.start.size() &&
               atStart(scene, "inside") == 0;
    };
    const Scene inward = dressed(folder, {.inward = true});
    CHECK(sameBody(inward));
    REQUIRE(inward.world.warnings.size() == 1);
    CHECK(has(inward.world.warnings[0], "body1.obj: 608 of its 608 triangles faced inward"));
    const Scene split = dressed(folder, {.split = true});
    CHECK(sameBody(split));
    REQUIRE(split.world.warnings.size() == 1);
    CHECK(has(split.world.warnings[0], "19 vertices, the first 17, are where others are (1)"));
    const Scene floating = dressed(folder, {.at = {0, 0.4, 0}}, {{"waist", 1.4}});
    REQUIRE(floating.world.warnings.size() == 1);
    CHECK(has(floating.world.warnings[0], "it stands on y = 0.4"));
}

TEST_CASE("dress: a body that cannot be worn is told why", "[dress][strangers]") {
    const ScratchFolder folder;
    const auto told = [&](const Figure& figure) -> std::string {
        try {
            dressed(folder, figure);
        } catch (const std::exception& error) {
            return error.what();
        }
        return "accepted";
    };
    CHECK(has(told({.scale = 100}), "body1.obj: 170 m tall"));
    CHECK(has(told({.scale = 1000}), "is it in millimetres?"));
    {
        const Figure figure;
        std::ofstream out(folder / "open1.obj");
        figure.write(out);
        out << "v 3 0 0\nv 3 1 0\nv 4 0 0\nf 307 308 309\n";
    }
    CHECK(has(refusal("dress", "body", (folder / "open*.obj").string()),
              "open1.obj: not closed: open at 3 edges, the first from vertex 307 to 308"));
}
