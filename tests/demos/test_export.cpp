// Exported runs, read back.
#include "demos/output/export.h"
#include "program.h"
#include "tests/catch.h"

#include <plait/files/mesh_file.h>
#include <plait/files/mesh_sequence.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace plait;
using namespace plait::test;

namespace {

// A short run of the curtain and the wire, exported.
void exportTo(const TemporaryFolder& folder, const std::string& format) {
    REQUIRE(
        plait::test::plait(folder, {"run", "sampler", "--no-render", "--quiet", "--seconds", "0.2",
                                    "--out", (folder / "run").string(), "--export", format})
            .status == 0);
}

std::vector<std::array<int, 3>> triangles(const SimplicialComplex& complex) {
    std::vector<std::array<int, 3>> all;
    for (int i = 0; i < complex.count(2); ++i) all.push_back(complex.triangle(i));
    return all;
}

// The same numbers, as float.
bool same(const std::vector<Vec<double>>& a, const std::vector<Vec<double>>& b) {
    bool equal = a.size() == b.size();
    for (std::size_t i = 0; equal && i < a.size(); ++i)
        equal = float(a[i].x) == float(b[i].x) && float(a[i].y) == float(b[i].y) &&
                float(a[i].z) == float(b[i].z);
    return equal;
}

}  // namespace

TEST_CASE("OBJ and PLY sequences hold the run", "[program][SH7]") {
    for (const std::string format : {"obj", "ply"}) {
        const TemporaryFolder folder;
        exportTo(folder, format);
        const RunFolder run(folder / "run");
        const World world = run.run().scene.world;
        for (int i = 0; i <= 5; ++i) {
            const Shape shape = readMesh(run.exportPath(numbered(i, "." + format)));
            CHECK(same(shape.positions, run.frame(i).positions));
            CHECK(triangles(shape.complex) == triangles(world.complex));
            CHECK(shape.complex.count(1) == world.complex.count(1));
        }
        CHECK_FALSE(std::filesystem::exists(run.exportPath(numbered(6, "." + format))));
        CHECK(contains(contents(run.exportPath(numbered(3, "." + format))),
                       "plait sampler, frame 3 at 0.125 s, 24 frames/s, metres, y up"));
    }
}

TEST_CASE("PC2 holds every point of every frame", "[program]") {
    const TemporaryFolder folder;
    exportTo(folder, "pc2");
    const RunFolder run(folder / "run");
    const std::string bytes = contents(run.exportPath("points.pc2"));
    const int count = run.run().scene.world.complex.count(0);
    REQUIRE(bytes.size() == 32 + 6 * 12 * static_cast<std::size_t>(count));
    struct Header {
        char magic[12];
        std::int32_t version, points;
        float start, rate;
        std::int32_t samples;
    } header;
    std::memcpy(&header, bytes.data(), sizeof header);
    CHECK(std::string(header.magic) == "POINTCACHE2");
    CHECK(header.version == 1);
    CHECK(header.points == count);
    CHECK(header.start == 0);
    CHECK(header.rate == 1);
    CHECK(header.samples == 6);
    const RunFrame last = run.frame(5);
    std::vector<float> points(3 * static_cast<std::size_t>(count));
    std::memcpy(points.data(), bytes.data() + 32 + 5 * 12 * static_cast<std::size_t>(count),
                points.size() * sizeof(float));
    for (std::size_t i = 0; i < last.positions.size(); ++i) {
        CHECK(points[3 * i] == float(last.positions[i].x));
        CHECK(points[3 * i + 1] == float(last.positions[i].y));
        CHECK(points[3 * i + 2] == float(last.positions[i].z));
    }
    CHECK(same(readMesh(run.exportPath("points.obj")).positions, run.frame(0).positions));
}

TEST_CASE("an exported run moves a world again", "[program][sequence]") {
    for (const std::string format : {"obj", "ply", "pc2"}) {
        const TemporaryFolder folder;
        exportTo(folder, format);
        const RunFolder run(folder / "run");
        const MeshSequence sequence(run.exportPath(format == "pc2" ? "points.pc2" : "*." + format),
                                    {.smooth = false});
        REQUIRE(sequence.count() == 6);
        const SimplicialComplex complex = run.run().scene.world.complex;
        CHECK(triangles(sequence.first().complex) == triangles(complex));
        for (int i = 0; i <= 5; ++i) {
            const std::vector<Vec<double>> expected = run.frame(i).positions;
            std::vector<Vec<double>> x(expected.size());
            sequence(i / 24.0, x);
            double most = 0;
            for (std::size_t v = 0; v < x.size(); ++v)
                most = std::max(most, length(x[v] - expected[v]));
            // Floats of up to 2 m, in three coordinates.
            CHECK(most <= 0x1p-23);
        }
    }
}

TEST_CASE("a run that is done is exported without being simulated again", "[program][CA10]") {
    const TemporaryFolder folder;
    exportTo(folder, "obj");
    const auto written = std::filesystem::last_write_time(folder / "run/cache/checkpoint");
    const Outcome outcome = plait::test::plait(
        folder, {"run", "sampler", "--no-render", "--quiet", "--seconds", "0.2", "--out",
                 (folder / "run").string(), "--export", "ply", "--resume"});
    CHECK(outcome.status == 0);
    CHECK(std::filesystem::exists(folder / "run/export/00005.ply"));
    CHECK(std::filesystem::exists(folder / "run/export/00005.obj"));
    CHECK(std::filesystem::last_write_time(folder / "run/cache/checkpoint") == written);
}
