// Sequences of meshes: what lies between them, what is held, and what is refused.
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"
#include "tests/scratch_folder.h"
#include "tests/worlds.h"

#include <plait/files/mesh_sequence.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

using namespace plait;
using namespace plait::test;

namespace {

void write(const std::filesystem::path& path, const std::string& content) {
    std::filesystem::remove(path);
    std::ofstream(path, std::ios::binary) << content;
}

std::string vertices(const Points& positions) {
    std::string text;
    for (const Vec<double>& p : positions) {
        char line[96];
        std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
        text += line;
    }
    return text;
}

// A tetrahedron on its way, each corner along a parabola.
Points tetrahedron(double t) {
    Points x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += Vec<double>{t, (0.5 - 0.25 * double(i)) * t * t, -0.3 * t * t};
    return x;
}

const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

// Its meshes, 8 in a second.
void writeTetrahedra(const ScratchFolder& folder, int count, int first = 0) {
    for (int i = 0; i < count; ++i)
        write(folder / ("t" + std::to_string(first + i) + ".obj"),
              vertices(tetrahedron(i / 8.0)) + faces);
}

template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string pc2(int points, int samples, float spacing, const std::vector<float>& coordinates) {
    std::string bytes("POINTCACHE2\0", 12);
    for (const std::int32_t n : {1, points}) put(bytes, n);
    for (const float f : {0.0F, spacing}) put(bytes, f);
    put(bytes, std::int32_t{samples});
    for (const float x : coordinates) put(bytes, x);
    return bytes;
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::vector<float> twoSamples{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};

Points at(const MeshSequence& sequence, double t) {
    Points x = sequence.first().positions;
    sequence(t, x);
    return x;
}

double apart(const Points& a, const Points& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
    return most;
}

// The refusal's message without the folder.
std::string refusal(const ScratchFolder& folder, const std::string& path) {
    try {
        MeshSequence sequence(folder / path);
    } catch (const MeshFileError& error) {
        std::string message = error.what();
        REQUIRE(message.find('\n') == std::string::npos);
        const std::string place = (folder / "").string();
        for (std::size_t i; (i = message.find(place)) != std::string::npos;)
            message.erase(i, place.size());
        return message;
    }
    return "accepted";
}

}  // namespace

TEST_CASE("sequence: through its meshes, smoothly or straight", "[sequence]") {
    const ScratchFolder folder;
    writeTetrahedra(folder, 9);
    const MeshSequence smooth(folder / "t*.obj", {.frameRate = 8}),
        straight(folder / "t*.obj", {.frameRate = 8, .smooth = false});
    REQUIRE(smooth.count() == 9);
    CHECK(smooth.end() == 1);
    CHECK(smooth.first().complex.count(2) == 4);
    double atMeshes = 0, between = 0, chord = 0;
    for (int i = 0; i <= 8; ++i)
        for (const MeshSequence* sequence : {&smooth, &straight})
            atMeshes = std::max(atMeshes, apart(at(*sequence, i / 8.0), tetrahedron(i / 8.0)));
    for (int i = 1; i < 7; ++i)
        for (const double s : {0.125, 0.5, 0.8}) {
            const double t = (i + s) / 8;
            between = std::max(between, apart(at(smooth, t), tetrahedron(t)));
            const Points a = tetrahedron(i / 8.0), b = tetrahedron((i + 1) / 8.0);
            Points mix = a;
            for (std::size_t v = 0; v < a.size(); ++v) mix[v] += s * (b[v] - a[v]);
            chord = std::max(chord, apart(at(straight, t), mix));
        }
    // A cubic through central differences is exact for parabolas.
    CHECK(report("at the meshes, m", atMeshes, 1e-15));
    CHECK(report("smooth between them, off the parabola, m", between, 1e-15));
    CHECK(report("straight between them, off the chord, m", chord, 1e-15));
}

// What goes round and is shown at half its speed: straight between its meshes it moves by jerks,
// two frames alike and then a turn.
TEST_CASE("sequence: retimed, what is smooth stays smooth", "[sequence][CA11]") {
    const ScratchFolder folder;
    const auto turned = [](double angle) {
        Points x = tetrahedron(0);
        for (auto& p : x)
            p = {p.x * std::cos(angle) - p.y * std::sin(angle),
                 p.x * std::sin(angle) + p.y * std::cos(angle), p.z};
        return x;
    };
    constexpr double step = 0.2;  // rad from mesh to mesh
    for (int i = 0; i < 13; ++i)
        write(folder / ("t" + std::to_string(i) + ".obj"), vertices(turned(step * i)) + faces);
    for (const bool smooth : {true, false}) {
        const MeshSequence slow(folder / "t*.obj", {.frameRate = 12, .smooth = smooth});
        double least = 1e9, most = 0;
        for (int frame = 4; frame < 20; ++frame) {
            const auto corner = [&](int f) { return at(slow, f / 24.0)[1]; };
            const double turn = length(corner(frame + 1) - 2 * corner(frame) + corner(frame - 1));
            least = std::min(least, turn), most = std::max(most, turn);
        }
        note(smooth ? "smooth: least of the greatest change of speed"
                    : "straight: least of the greatest change of speed",
             least / most);
        CHECK((least > 0.5 * most) == smooth);
    }
}

TEST_CASE("sequence: holds before and behind, without a jolt", "[sequence]") {
    const ScratchFolder folder;
    writeTetrahedra(folder, 5, 98);  // from 98 to 102: sorted as numbers
    const MeshSequence sequence(folder / "*.obj", {.frameRate = 8, .start = 0.25});
    CHECK(sequence.end() == 0.75);
    for (const double t : {-1e9, 0.0, 0.25}) CHECK(apart(at(sequence, t), tetrahedron(0)) == 0);
    for (const double t : {0.75, 5.0, 1e9}) CHECK(apart(at(sequence, t), tetrahedron(0.5)) < 1e-15);
    // One-sided differences over e differ by at most e times the greatest acceleration, 30 m/s^2.
    constexpr double e = 1e-6;
    double jolt = 0;
    for (int i = 0; i <= 4; ++i) {
        const double t = 0.25 + i / 8.0;
        const Points before = at(sequence, t - e), here = at(sequence, t),
                     after = at(sequence, t + e);
        for (std::size_t v = 0; v < here.size(); ++v)
            jolt = std::max(jolt, length(after[v] - 2 * here[v] + before[v]) / e);
    }
    CHECK(report("velocity jumps by, m/s", jolt, 60 * e));

    const ScratchFolder alone;
    writeTetrahedra(alone, 1);
    CHECK(apart(at(MeshSequence(alone / "*.obj"), 3), tetrahedron(0)) == 0);
}

TEST_CASE("sequence: PC2 with its mesh, at its own spacing", "[sequence]") {
    const ScratchFolder folder;
    write(folder / "body.pc2", pc2(3, 2, 2, twoSamples));
    write(folder / "body.obj", triangle);
    const MeshSequence sequence(folder / "body.pc2", {.frameRate = 24, .smooth = false});
    CHECK(sequence.count() == 2);
    CHECK(sequence.end() == Approx(2 / 24.0));
    CHECK(sequence.first().complex.count(2) == 1);
    CHECK(at(sequence, 0.5 / 24)[1] == Vec<double>{1, 0, 0.25});
}

TEST_CASE("sequence: it moves pinned vertices", "[sequence][solver]") {
    const ScratchFolder folder;
    writeTetrahedra(folder, 9);
    const MeshSequence sequence(folder / "*.obj", {.frameRate = 8});
    World world;
    const Range body = world.add(sequence.first());
    world.pin(pointStencils(body), sequence);
    Solver<double> solver(world, {});
    for (int frame = 1; frame <= 30; ++frame) {
        solver.frame();
        CHECK(apart(solver.positions(), at(sequence, solver.time())) < 1e-15);
    }
    CHECK_THROWS_AS(sequence(0, std::span(world.start).first(3)), std::invalid_argument);
}

TEST_CASE("sequence: what is wrong is refused with file and cause", "[sequence]") {
    const ScratchFolder folder;
    CHECK(refusal(folder, "*.obj") == "*.obj:0: no file matches");
    CHECK(refusal(folder, "none/*.obj") == "none/*.obj:0: the folder cannot be read");
    CHECK(refusal(folder, "*_*.obj") == "*_*.obj:0: more than one *");
    CHECK(refusal(folder, "a.obj") == "a.obj:0: neither a pattern with a * nor a .pc2");
    CHECK(refusal(folder, "a.pc2") == "a.pc2:0: no such file");
    writeTetrahedra(folder, 8);
    CHECK(refusal(folder, "*.obj") == "accepted");
    write(folder / "t7.obj", vertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) + "f 1 2 3\n");
    CHECK(refusal(folder, "*.obj") ==
          "t7.obj:0: 3 vertices, 3 edges and 1 triangles, but t0.obj has 4 vertices, 6 edges and 4 "
          "triangles");
    write(folder / "t7.obj", vertices(tetrahedron(0)) + "f 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    CHECK(refusal(folder, "*.obj") == "t7.obj:0: its faces differ from those of t0.obj");
    write(folder / "t7.obj", "v 0 0\n");
    CHECK(refusal(folder, "*.obj") == "t7.obj:1: a vertex with fewer than 3 coordinates");
    write(folder / "t007.obj", "");
    CHECK(refusal(folder, "*.obj") == "t7.obj:0: the same number as t007.obj");
    std::filesystem::remove(folder / "t7.obj");
    std::filesystem::rename(folder / "t007.obj", folder / "t9.obj");
    CHECK(refusal(folder, "*.obj") == "t9.obj:0: no file of number 7 before this one");
    write(folder / "tx.obj", "");
    CHECK(refusal(folder, "*.obj") == "tx.obj:0: no number where the * is");

    const auto cache = [&](const std::string& bytes) {
        write(folder / "c.pc2", bytes);
        return refusal(folder, "c.pc2");
    };
    const std::string good = pc2(3, 2, 1, twoSamples);
    CHECK(cache(good) == "c.pc2:0: neither an .obj nor a .ply of its name beside it");
    write(folder / "c.obj", triangle);
    CHECK(cache(good) == "accepted");
    CHECK(cache(good.substr(0, 31)) == "c.pc2:byte 0: the file ends too early");
    CHECK(cache(good.substr(0, good.size() - 1)) == "c.pc2:byte 103: the file ends too early");
    CHECK(cache(good + "x") == "c.pc2:byte 105: more behind the last sample");
    CHECK(cache("point" + good) == "c.pc2:byte 0: not a PC2 file");
    CHECK(cache(pc2(3, 2, 0, twoSamples)) ==
          "c.pc2:byte 0: its frames between samples must be positive");
    CHECK(cache(pc2(3, 0, 1, {})) == "c.pc2:byte 0: no points or no samples");
    CHECK(cache(pc2(2, 3, 1, twoSamples)) ==
          "c.pc2:byte 16: 2 points, but the mesh has 3 vertices");
    CHECK(cache(pc2(2000000000, 2000000000, 1, twoSamples)) ==
          "c.pc2:byte 104: the file ends too early");
    std::vector<float> bad = twoSamples;
    bad[4] = std::numeric_limits<float>::infinity();
    CHECK(cache(pc2(3, 2, 1, bad)) == "c.pc2:byte 44: a coordinate that is not finite");
    CHECK_THROWS_AS(MeshSequence(folder / "c.pc2", {.frameRate = 0}), std::invalid_argument);
}

TEST_CASE("sequence: caches mutilated at random are read or refused, never worse", "[sequence]") {
    const ScratchFolder folder;
    write(folder / "c.obj", triangle);
    const std::string good = pc2(3, 2, 1, twoSamples);
    Random random(5);
    int read = 0, refused = 0;
    for (int run = 0; run < 2000; ++run) {
        std::string mutant = good;
        for (int change = random.below(3); change >= 0; --change) {
            const auto place = static_cast<std::size_t>(random.below(int(mutant.size())));
            switch (random.below(4)) {
                case 0:
                    mutant[place] = static_cast<char>(random.bits());
                    break;
                case 1:
                    mutant[place] ^= static_cast<char>(1 << random.below(7));
                    break;
                case 2:
                    mutant.insert(place, mutant.substr(0, std::size_t(random.below(20))));
                    break;
                default:
                    mutant.resize(place + 1);
            }
        }
        write(folder / "c.pc2", mutant);
        (refusal(folder, "c.pc2") == "accepted" ? read : refused) += 1;
    }
    CHECK(read > 200);
    CHECK(refused > 200);
}

TEST_CASE("sequence: a blend goes straight from one to the other", "[sequence][CA12]") {
    const ScratchFolder folder, other;
    writeTetrahedra(folder, 9);
    write(other / "body.pc2", pc2(3, 2, 2, twoSamples));
    write(other / "body.obj", triangle);
    const MeshSequence slow(folder / "*.obj", {.frameRate = 4}),
        fast(folder / "*.obj", {.frameRate = 8});
    const auto animation = blend(slow, fast, [](double t) { return t; });
    double worst = 0, apartMost = 0;
    for (const double t : {0.0, 0.25, 0.6, 1.0}) {
        Points x(4), expected = at(slow, t);
        const Points to = at(fast, t);
        apartMost = std::max(apartMost, apart(expected, to));
        for (std::size_t v = 0; v < 4; ++v) expected[v] += t * (to[v] - expected[v]);
        animation(t, x);
        worst = std::max(worst, apart(x, expected));
    }
    CHECK(apartMost > 0.1);
    CHECK(report("off the straight way between both, m", worst, 1e-15));

    World world;
    const Range body = world.add(slow.first());
    world.pin(pointStencils(body), animation);
    Solver<double> solver(world, {});
    for (int frame = 1; frame <= 24; ++frame) {
        solver.frame();
        Points x(4);
        animation(solver.time(), x);
        CHECK(apart(solver.positions(), x) < 1e-15);
    }
    CHECK_THROWS_AS(blend(slow, MeshSequence(other / "body.pc2"), [](double) { return 0; }),
                    std::invalid_argument);
    CHECK_THROWS_AS(blend(slow, fast, nullptr), std::invalid_argument);
}
