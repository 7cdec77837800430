#include "scene.h"

#include "basics.h"
#include "flag.h"

#include <stdexcept>

namespace plait {

std::span<const SceneEntry> scenes() {  // NOLINT(readability-function-size): a table
    static const std::vector<SceneEntry> all = {
        {.name = "band",
         .title = "Band",
         .lesson = "Interleaving spares the ends of a band stretched over two pegs",
         .ingredients = {"stretch", "contact"},
         .omissions = {"friction: the band slides, so that only the schedule decides its strain"},
         .build = band},
        {.name = "bullet",
         .title = "Bullet",
         .lesson = "What moves far in a step is looked for on its way, not where the step ends",
         .ingredients = {"stretch", "tethers", "contact", "gravity"},
         .omissions = {"friction, and the sheet with itself: whether it holds the ball is shown",
                       "air: the ball is slow"},
         .knobs = {{.name = "detection",
                    .meaning = "look for the ball all its way, or where each substep ends",
                    .choices = {"path", "end"},
                    .text = "path"},
                   {.name = "speed",
                    .meaning = "of the ball",
                    .unit = "m/s",
                    .value = 10,
                    .low = 5,
                    .high = 12},
                   {.name = "distance",
                    .meaning = "from ball to sheet at the start",
                    .unit = "m",
                    .value = 1,
                    .low = 0.1,
                    .high = 1}},
         .build = bullet},
        {.name = "cantilever",
         .title = "Cantilever",
         .lesson = "Stiffness in newtons: a strip droops alike by every method that knows it",
         .ingredients = {"stretch", "bend", "gravity"},
         .omissions = {"air, damping: its energy is to stay"},
         .build = cantilever},
        {.name = "chain",
         .title = "Chain",
         .lesson = "A chain is solved at once, not link by link",
         .ingredients = {"stretch", "gravity"},
         .omissions = {"air, bending: the reference has neither"},
         .knobs = {{.name = "solve",
                    .meaning = "all links at once, or sweeps over them",
                    .choices = {"direct", "sweeps"},
                    .text = "direct"},
                   {.name = "tip",
                    .meaning = "mass of the last vertex: half that of the others, as lumped, or as "
                               "theirs",
                    .choices = {"half", "whole"},
                    .text = "half"}},
         .build = hangingChain},
        {.name = "flag",
         .title = "Flag",
         .lesson = "Threads solved whole, warp then weft, keep silk from stretching at any size",
         .ingredients = {"stretch", "gravity", "air"},
         .omissions = {"bending: a large flag of fine silk has next to none",
                       "self-collision: folds may pass through each other",
                       "the wake: the air acts on the flag and not the flag on the air",
                       "the air in two substeps of three: it takes a hundred to change a velocity"},
         .demo = true,
         .knobs = {{.name = "wind",
                    .meaning = "its mean speed",
                    .unit = "m/s",
                    .value = 6,
                    .low = 0,
                    .high = 16},
                   {.name = "weather",
                    .meaning = "wind that calms, freshens and gusts, or always the same",
                    .choices = {"changing", "steady"},
                    .text = "changing"},
                   {.name = "mesh",
                    .meaning =
                        "OBJ or PLY file of a cloth to fly instead, in metres, hoist at its left"}},
         .build = flag},
        {.name = "hanging-sheet",
         .title = "Hanging sheet",
         .lesson = "An inextensible sheet on two pins is the hardest easy scene",
         .ingredients = {"stretch", "gravity"},
         .omissions = {"air, bending, contact: every stretch shown is solver error"},
         .knobs = {{.name = "pins",
                    .meaning = "what holds it",
                    .choices = {"corners", "edge"},
                    .text = "corners"},
                   {.name = "solve",
                    .meaning =
                        "its links alone; with tethers and their strands, solved whole; with "
                        "tethers and coarse levels; or with all three",
                    .choices = {"sweeps", "strands", "aggregates", "all"},
                    .text = "strands"},
                   {.name = "size",
                    .meaning = "vertices along a side; 0: 16, 32 or 64 by quality",
                    .value = 0,
                    .low = 0,
                    .high = 512},
                   {.name = "dent",
                    .meaning = "how deep the start is, so that rounding does not seed its buckling",
                    .unit = "m",
                    .value = 0,
                    .low = 0,
                    .high = 0.01},
                   {.name = "compliance",
                    .meaning = "stretch of a link under 1 N",
                    .unit = "m/N",
                    .value = 0,
                    .low = 0,
                    .high = 1}},
         .build = hangingSheet},
        {.name = "pendulum",
         .title = "Pendulum",
         .lesson = "First order loses energy, second order hardly any",
         .ingredients = {"stretch", "gravity"},
         .omissions = {"air: the exact period is known without it"},
         .knobs = {{.name = "length",
                    .meaning = "of the link",
                    .unit = "m",
                    .value = 1,
                    .low = 0.1,
                    .high = 10}},
         .build = pendulum},
        {.name = "sampler",
         .title = "Sampler",
         .lesson = "Every kind of constraint and force in one world",
         .ingredients = {"stretch", "shear", "angle", "bend", "attach", "contact", "gravity", "air",
                         "field"},
         .omissions = {"nothing: it is a scene for tests"},
         .build = sampler},
        {.name = "soft-pins",
         .title = "Soft pins",
         .lesson = "A soft pin gives way by load over stiffness",
         .ingredients = {"attach", "gravity"},
         .omissions = {"links between the points: one pin, one load"},
         .build = softPins},
        {.name = "strip-in-wind",
         .title = "Strip in wind",
         .lesson = "A strip hangs straight in the wind, at an angle known exactly",
         .ingredients = {"stretch", "gravity", "air"},
         .omissions = {"bending: the balance is local, so a straight strip has none"},
         .knobs = {{.name = "wind",
                    .meaning = "its speed; at 4 the strip hangs at 45 degrees",
                    .unit = "m/s",
                    .value = 4,
                    .low = 0,
                    .high = 6}},
         .build = stripInWind},
        {.name = "unit-spring",
         .title = "Unit spring",
         .lesson = "One spring shows all that a time step does: x'' = -x",
         .ingredients = {"attach"},
         .omissions = {"gravity: it would only shift where the point rests"},
         .build = unitSpring},
        {.name = "wind-gauge",
         .title = "Wind gauge",
         .lesson = "One polygon tells how fast the wind is",
         .ingredients = {"stretch", "air"},
         .omissions = {"gravity: the gauge is to drift with the air, not to fall"},
         .knobs = {{.name = "drag",
                    .meaning = "1/drag is about the time it takes to drift with the air",
                    .unit = "m/s",
                    .value = 1,
                    .low = 0,
                    .high = 100},
                   {.name = "lift",
                    .meaning = "explicit and of the square of speed: it fails when large (M 5.3)",
                    .value = 0,
                    .low = 0,
                    .high = 1e6}},
         .build = windGauge},
    };
    return all;
}

const SceneEntry& findScene(const std::string& name) {
    for (const SceneEntry& entry : scenes())
        if (entry.name == name) return entry;
    throw std::invalid_argument("no scene named " + name);
}

Scene build(const SceneEntry& entry, Quality quality) {
    return entry.build(Knobs::defaults(entry.knobs, quality));
}

Knobs Knobs::defaults(const std::vector<Knob>& knobs, Quality quality) {
    Knobs values{.quality = quality, .numbers = {}, .texts = {}};
    for (const Knob& knob : knobs) {
        if (knob.isNumber())
            values.numbers[knob.name] = knob.value;
        else
            values.texts[knob.name] = knob.text;
    }
    return values;
}

}  // namespace plait
