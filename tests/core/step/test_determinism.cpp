// The same bits on every scene, whatever runs it. What compilers and levels add is compared by
// tests/run --long, through plait_hash.
#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "scenes/scene.h"
#include "tests/blessed_hashes.h"
#include "tests/catch.h"
#include "tests/small_scenes.h"

#include <plait/solver.h>
#include <plait/stencils.h>

using namespace plait;
using namespace plait::test;

namespace {

template <class Real>
std::uint64_t hashAfter(const Scene& scene, int threads, KernelChoice kernels) {
    SolverOptions options = scene.options;
    options.threads = threads;
    options.kernels = kernels;
    Solver<Real> solver(scene.world, options);
    for (int i = 0; i < blessedFrames; ++i) solver.frame();
    return solver.hash();
}

std::vector<KernelChoice> everyChoice() {
    std::vector<KernelChoice> choices;
    for (const Isa isa : {Isa::v2, Isa::v3, Isa::v4})
        for (const int lanes : {1, 4, 8, 16})
            if (available({isa, lanes})) choices.push_back({isa, lanes});
    return choices;
}

void holdTo(const SceneEntry& entry, const Scene& scene, KernelChoice choice) {
    INFO(entry.name << ", v" << static_cast<int>(choice.isa) + 2 << " x" << choice.lanes);
    REQUIRE(hashAfter<float>(scene, 1, choice) == blessedHash<float>(entry.name));
    REQUIRE(hashAfter<double>(scene, 1, choice) == blessedHash<double>(entry.name));
}

void holdToThreads(std::initializer_list<int> counts) {
    for (const SceneEntry& entry : smallScenes()) {
        const Scene scene = build(entry, Quality::draft);
        for (const int threads : counts) {
            INFO(entry.name << ", " << threads << " threads");
            REQUIRE(hashAfter<float>(scene, threads, bestKernels()) ==
                    blessedHash<float>(entry.name));
        }
    }
}

}  // namespace

// Of each scene another: most kinds are in several.
TEST_CASE("determinism: lanes and instruction sets", "[determinism][figures]") {
    const std::vector<KernelChoice> choices = everyChoice();
    std::size_t next = 0;
    for (const SceneEntry& entry : smallScenes())
        holdTo(entry, build(entry, Quality::draft), choices[next++ % choices.size()]);
}

TEST_CASE("determinism: all lanes and instruction sets", "[determinism][long]") {
    for (const SceneEntry& entry : smallScenes()) {
        const Scene scene = build(entry, Quality::draft);
        for (const KernelChoice choice : everyChoice()) holdTo(entry, scene, choice);
    }
}

TEST_CASE("determinism: threads", "[determinism][threads]") { holdToThreads({3}); }

TEST_CASE("determinism: more and fewer threads", "[determinism][long]") {
    holdToThreads({1, 2, 8});
}

// Large enough that the colours of every kind are cut between the threads, which the scenes' are
// not.
TEMPLATE_TEST_CASE("determinism: threads on a large sheet", "[determinism][threads][AR14][PD1]",
                   float, double) {
    Scene scene = build(findScene("sampler"));
    World& world = scene.world;
    const Range sheet =
        world.add(grid({.columns = 60, .rows = 60}, {.origin = {2, -0.5, 0}}), {.density = 0.1});
    world.pin({sheet.first});
    world.constrain(restRows<Stretch>(edgeStencils(world.complex, sheet), world.rest),
                    {.name = "large", .damping = 0.1});
    world.constrain(restRows<Shear>(triangleStencils(world.complex, sheet), world.rest, 1e-2),
                    {.name = "large shear", .damping = 0.1});
    world.constrain(bendRows(world.complex, sheet, world.rest, 1e-4), {.name = "large bend"});
    auto floor = restRows<PlaneContact>(pointStencils(sheet), world.rest);
    for (auto& row : floor.rows) row = {{0, -0.5, 0}, {0, 1, 0}, 0};
    world.constrain(floor, {.name = "large floor"});
    scene.options.schedule.substeps = 1;
    const std::uint64_t expected = hashAfter<TestType>(scene, 1, bestKernels());
    for (const int threads : {2, 3, 8}) {
        INFO(threads << " threads");
        REQUIRE(hashAfter<TestType>(scene, threads, bestKernels()) == expected);
    }
}

TEST_CASE("determinism: a run that is rewound is the run again", "[determinism][figures][AR11]") {
    for (const SceneEntry& entry : smallScenes()) {
        const Scene scene = build(entry, Quality::draft);
        Solver<float> solver(scene.world, scene.options);
        const std::uint64_t start = solver.hash();
        solver.frame();
        const std::uint64_t end = solver.hash();
        solver.frame();
        solver.rewind();
        INFO(entry.name);
        REQUIRE(solver.hash() == start);
        solver.frame();
        REQUIRE(solver.hash() == end);
        REQUIRE(end != start);
    }
}

// The lines of plait_hash, so that a change of bits is seen where it is made.
TEST_CASE("determinism: the hashes of all scenes are those that were blessed", "[determinism]") {
    const std::string golden = std::string(PLAIT_ROOT) + "/golden/hashes.txt";
    std::ifstream file(golden);
    REQUIRE(file.good());
    std::string expected((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::string actual;
    FILE* pipe = popen(PLAIT_HASH, "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 256> line{};
    while (std::fgets(line.data(), line.size(), pipe)) actual += line.data();
    REQUIRE(pclose(pipe) == 0);
    INFO("if the change is meant: build/plait_hash > golden/hashes.txt");
    REQUIRE(actual == expected);
}
