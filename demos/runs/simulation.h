// A run that moves from frame to frame, in either precision.
#pragma once

#include "run_frame.h"
#include "settings.h"

#include <cstdint>
#include <memory>

namespace plait {

class Simulation {
public:
    virtual ~Simulation() = default;

    // Solver frames that pass before the first (Scene::lead), and one of them. All of them must
    // have passed before anything else is asked, unless it was restored.
    virtual int lead() const = 0;
    virtual void settle() = 0;

    // Advances by one frame. Throws Diverged and stays at the frame before.
    virtual void advance() = 0;
    // Where the run is: positions and velocities as the cache keeps them, metrics of exact ones.
    virtual RunFrame frame() const = 0;
    virtual std::uint64_t hash() const = 0;
    // Of all states that the solver holds.
    virtual std::size_t stateBytes() const = 0;
    // That take part, at most those asked for.
    virtual int threads() const = 0;

    // Everything that decides the future, as bytes of cache/checkpoint.
    virtual std::string checkpoint() const = 0;
    // Goes on from it. Throws FileError that begins with `name`.
    virtual void restore(const std::string& checkpoint, const std::string& name) = 0;
};

// `run` must live as long. Warns where the system starts fewer threads. Throws SceneError where the
// world or its options are at fault.
std::unique_ptr<Simulation> makeSimulation(const Run& run, int threads);

// All of its lead, with progress. Throws Interrupted.
void settle(Simulation& simulation, const Run& run, bool quiet = true);

// Bytes of a number of the cache.
int numberSize(const Run& run);

}  // namespace plait
