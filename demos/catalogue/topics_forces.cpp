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
         .name = "tearing",
         .title = "Tearing",
         .marks = {"tearing"},
         .header = "core/tearing/tearing.h",
         .lesson = "A sheet tears on where what it sets free by that is more than what the tear "
                   "costs, however large the stress at its end.",
         .equations =
             {{R"(\b{J} = - \sum_e V_e (W_e \b{I} - \b{F}_e^T \b{P}_e) \nabla q_e)",
               R"(What drives the end of a tear, as a force on a place in the matter (N), after Eshelby: over the triangles $e$ around it, of volume $V$, stored energy $W$ (J in a cubic metre), deformation $\b{F}$ and force on areas at rest $\b{P}$. $q$ is 1 near the end and 0 three edges away.)"},
              {R"(\b{J} \cdot \b{t} > \Gamma d)",
               R"(The tear goes on along an edge of direction $\b{t}$ where this is so. $\Gamma$ (J/m²) is the toughness, $d$ (m) the thickness.)"},
              {R"(F = F_0 (1 - \frac{\delta}{\delta_c}), \quad \frac{1}{2} F_0 \delta_c = \Gamma d \ell)",
               R"(Its lips begin with the force $F_0$ that they bore as one, and let go as they open by $\delta$: all in all they take what the edge of length $\ell$ costs.)"}},
         .rows = {"AT7", "BR1", "BR7", "FX9"}},
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
