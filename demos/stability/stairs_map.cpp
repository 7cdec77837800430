// The slinky of the demo on stairs of other sizes: whether it walks.
#include "map.h"
#include "scenes/slinky/landings.h"
#include "watch.h"

#include <algorithm>

namespace plait {
namespace {

enum Gait { walks, stops, tumbles };  // as an Outcome

constexpr std::size_t enough = 5;  // landings, the first of them the hand's
constexpr double patience = 1.2;   // s, that a step may take
constexpr double still = 0.5;      // m/s

// Both ends in turn, each a tread below the other.
bool inOrder(const std::vector<Landing>& landings) {
    for (std::size_t i = 0; i < landings.size(); ++i)
        if (landings[i].tread != static_cast<int>(i) + 1 || landings[i].upper != (i % 2 == 0))
            return false;
    return true;
}

Gait gaitOn(double tread, double rise) {
    const SceneEntry& entry = findScene("slinky");
    Knobs knobs = Knobs::defaults(entry.knobs, Quality::draft);
    knobs.numbers["tread"] = tread;
    knobs.numbers["rise"] = rise;
    const Scene scene = entry.build(knobs);
    const Slinky slinky;
    Landings landings(slinky, rise, tread);
    Solver<float> solver(scene.world, scene.options);
    double last = 0;
    while (landings.all().size() < enough && solver.time() < last + patience) {
        stopIfInterrupted();
        solver.frame();
        if (!landings.see(solver.positions(), solver.time())) continue;
        if (!inOrder(landings.all())) return tumbles;
        last = solver.time();
    }
    if (landings.all().size() >= enough) return walks;
    const auto velocities = solver.velocities();
    return std::ranges::any_of(velocities, [](const auto& v) { return length(v) > still; })
               ? tumbles
               : stops;
}

}  // namespace

StabilityMap stairsMap() {
    return {.name = "stairs",
            .title = "On which stairs a slinky walks",
            .words =
                "The slinky of the demo, laid on the next tread by a hand within 0.5 s, on "
                "stairs of wood. Each cell takes minutes; what is interrupted goes on where "
                "it was.",
            .note = "86 turns of flat steel wire, friction 0.6; four steps by itself are a walk",
            .theoryWords = "",
            .x = {"tread, m", 0.1, 0.22},
            .y = {"rise, m", 0.06, 0.2},
            .boundaryAt = {},
            .panels = {{"slinky",
                        [](double tread, double rise) {
                            return static_cast<Outcome>(gaitOn(tread, rise));
                        }}},
            .outcomes = {"walks", "stops", "tumbles"},
            .outcomeWords =
                "Walks: after the hand's its ends land four times in turn, each on the tread below "
                "the other. Tumbles: an end lands elsewhere, or does not land within 1.2 s and "
                "something still moves at 0.5 m/s. Stops: it does not land, and nothing moves."};
}

}  // namespace plait
