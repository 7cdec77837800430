// Forces: what acts from outside, before constraints are asked.
#include "topics.h"

namespace plait {

std::vector<Topic> forceTopics() {
    constexpr TopicSort sort = TopicSort::force;
    return {
        {.sort = sort,
         .name = "gravity",
         .title = "Gravity",
         .marks = {"gravity"},
         .header = "core/forces/gravity.h",
         .lesson = "Everything falls alike, whatever its mass.",
         .equations = {{R"(\b{v} \gets \b{v} + h \b{g})",
                        R"($\b{g}$ is 9.81 m/s² downward, unless a scene says otherwise.)"}},
         .rows = {"AW9", "AW10", "IN1", "UN1"}},
        {.sort = sort,
         .name = "air",
         .title = "Air and wind",
         .marks = {"air"},
         .header = "core/air/air.h",
         .lesson = "Air slows what moves through it broadside, lets pass what cuts it edge-on, and "
                   "carries what it blows at.",
         .equations =
             {{R"(\b{F} = \frac{\rho A}{2} (c_d (|u_n| u_n \b{n} + \tau \|\b{u}_t\| \b{u}_t) + c_l \b{L}))",
               R"(On each triangle of area $A$ (m²) that meets the air at $\b{u}$ (m/s): $u_n$ is the part of that along its normal $\b{n}$, $\b{u}_t$ the part along the triangle. $\rho$ (kg/m³) is the density of air, $c_d$ the drag, $\tau$ how rough the cloth is along itself, $c_l$ the lift.)"},
              {R"(\b{u} = \text{wind}(\b{x}, t) - \b{v})",
               R"(What counts is how the air goes by, not who of the two moves.)"}},
         .rows = {"AW1", "AW2", "AW4", "AW5", "AW6", "AW8", "FX1"}},
        {.sort = sort,
         .name = "field",
         .title = "Field of acceleration",
         .marks = {"field"},
         .header = "core/forces/field.h",
         .lesson = "Any push that a program of one's own can say for a place and a time.",
         .equations =
             {{R"(\b{v} \gets \b{v} + h \b{a}(\b{x}, t))",
               R"($\b{a}$ (m/s²) is asked once a frame at every point, and acts in each substep.)"}},
         .rows = {"IN29", "IN30"}},
    };
}

}  // namespace plait
