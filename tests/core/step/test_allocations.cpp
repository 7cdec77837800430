// The solver allocates nothing while it steps, nor does the broad phase. Apart, because this
// replaces operator new: under the thread sanitizer, whose own cannot be replaced, the file is left
// out of the build.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include "scenes/scene.h"
#include "tests/catch.h"
#include "tests/core/collision/soup.h"
#include "tests/core/linear/block_system.h"
#include "tests/small_scenes.h"

#include <plait/collision/hash_grid.h>
#include <plait/collision/kdop_tree.h>
#include <plait/sheets/inextensible.h>
#include <plait/solver.h>

using namespace plait;
using namespace plait::test;

namespace {

std::atomic<bool> counting{false};
std::atomic<long> allocations{0};

void* allocate(std::size_t size, std::size_t alignment) {
    if (counting) ++allocations;
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, whole ? whole : alignment);
    if (!memory) throw std::bad_alloc();
    return memory;
}

// Out of sight: gcc takes free() for a mistake where it sees what delete has become.
[[gnu::noinline]] void release(void* memory) { std::free(memory); }

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
// The address sanitizer has its own of these, which would not go with what delete is here.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return operator new(size); }
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return operator new(size, alignment);
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace {

template <class Real>
long allocationsInFrames(const Scene& scene, int threads) {
    SolverOptions options = scene.options;
    options.threads = threads;
    Solver<Real> solver(scene.world, options);
    solver.frame();
    allocations = 0;
    counting = true;
    solver.frame();
    solver.frame();
    counting = false;
    return allocations;
}

}  // namespace

TEST_CASE("solver: a frame allocates nothing after the first", "[solver][AR10]") {
    for (const SceneEntry& entry : smallScenes()) {
        const Scene scene = build(entry, Quality::draft);
        if (matterMeets(scene) || !scene.world.spare.empty()) continue;
        INFO(entry.name);
        const long shared = allocationsInFrames<float>(scene, 2);
        const long single = allocationsInFrames<double>(scene, 1);
        REQUIRE(shared == 0);
        REQUIRE(single == 0);
    }
    counting = true;
    allocations = 0;
    delete new int(1);
    counting = false;
    REQUIRE(allocations == 1);  // the counter counts
}

TEST_CASE("solver: nor do pins that an animation moves and what is tied to them", "[solver]") {
    Scene scene;
    const Range sheet = scene.world.add(grid({.columns = 9, .rows = 9}), {.density = 0.2});
    scene.world.pin({0, 8}, [](double t, std::span<Vec<double>> positions) {
        for (Vec<double>& x : positions) x.z += t;
    });
    holdSheet(scene.world, sheet);
    scene.options.baseSteps = 3;
    const long found = allocationsInFrames<float>(scene, 1);
    CHECK(found == 0);
}

TEST_CASE("broad phase: a substep like the last one allocates nothing", "[broadphase]") {
    const test::Soup soup = test::soups(4000)[0];
    for (const int threads : {1, 2}) {
        Workers workers(threads);
        Candidates found;
        KDopTree<18> tree(soup.count(), soup.bounds<18>(), workers);
        HashGrid grid;
        const auto substep = [&] {
            tree.refit(soup.bounds<18>(), workers);
            tree.selfPairs(found, workers);
            tree.pairs(tree, found, workers);
            grid.build(soup.count(), soup.bounds<6>(), workers);
            grid.selfPairs(found, workers);
        };
        substep();
        allocations = 0;
        counting = true;
        substep();
        counting = false;
        INFO(threads << " threads");
        CHECK(allocations == 0);
    }
}

TEST_CASE("allocations: none in a second factorisation", "[determinism]") {
    const System system = sheet(40, 40).fill(1, 1);
    Multifrontal factors(system.rest, system.edges, system.pinned);
    for (const int threads : {1, 3}) {
        Workers workers(threads);
        Vectors x = system.b;
        factors.factor(system.vertexBlocks, system.edgeBlocks, workers);
        allocations = 0;
        counting = true;
        factors.factorAndSolve(system.vertexBlocks, system.edgeBlocks, x, workers);
        factors.solve(x, workers);
        counting = false;
        CHECK(allocations == 0);
    }
}
