// Constraints of a few vertices each: the kinds of core/constraints.
#include "topics.h"

namespace plait {

std::vector<Topic> constraintTopics() {  // NOLINT(readability-function-size): a table
    constexpr TopicSort sort = TopicSort::constraint;
    return {
        {.sort = sort,
         .name = "stretch",
         .title = "Stretch",
         .marks = {"Stretch,"},
         .header = "core/constraints/stretch.h",
         .lesson = "Two points keep their distance, as the ends of a thread or a rod do.",
         .equations =
             {{R"(C(\b{x}) = \|\b{x}_1 - \b{x}_0\| - \ell)",
               R"($\b{x}_0$ and $\b{x}_1$ are where the two points are, $\ell$ (m) is how far apart they want to be. $C$ is how much too long the link is; it is kept when $C = 0$.)"},
              {R"(\nabla_1 C = \b{n} = \frac{\b{x}_1 - \b{x}_0}{\|\b{x}_1 - \b{x}_0\|}, \quad \nabla_0 C = -\b{n})",
               R"(Moving either end along the link changes $C$ most, so that is the way in which a correction goes. The two are opposite: what one end is given the other is given back, and momentum stays.)"},
              {R"(\Delta \b{x}_i = - w_i \frac{C}{w_0 + w_1} \nabla_i C)",
               R"(One evaluation of a rigid link. $w$ (1/kg) is one over the mass: the lighter end gives way more, and an end that is pinned has $w = 0$ and stays.)"}},
         .rows = {"DC1", "DC5", "DC7", "DC8"},
         .maps = {"step-stiffness", "mass-ratio", "stiffness-ratio", "chain-length"}},
        {.sort = sort,
         .name = "angle",
         .title = "Angle",
         .marks = {"Angle,"},
         .header = "core/constraints/angle.h",
         .lesson = "Three points keep the angle between them: it is how a curve bends, and how the "
                   "corner of a triangle resists shear.",
         .equations =
             {{R"(C(\b{x}) = \theta - \theta_0, \quad \theta = \text{atan2}(\|\b{a} \times \b{b}\|, \b{a} \cdot \b{b}))",
               R"($\b{a} = \b{x}_1 - \b{x}_0$ and $\b{b} = \b{x}_2 - \b{x}_1$ are the two edges, $\theta$ is by how much the way turns at $\b{x}_1$, and $\theta_0$ (rad) is how much it wants to.)"},
              {R"(\psi = \text{acos}(\hat{\b{d}}_{10} \cdot \hat{\b{d}}_{12}) = \pi - \theta)",
               R"(The paper of 2009 measures the angle $\psi$ inside, by acos. Its derivative is infinite where the three points lie in a line; the turning angle by atan2 stays finite there.)"}},
         .rows = {"DC2", "DC6"}},
        {.sort = sort,
         .name = "shear",
         .title = "Shear",
         .marks = {"Shear,"},
         .header = "core/constraints/shear.h",
         .lesson =
             "Two directions in a triangle that are at right angles stay so: warp and weft of "
             "a cloth do not become a rhombus.",
         .equations =
             {{R"(C(\b{x}) = \frac{\b{u} \cdot \b{v}}{\|\b{u}\| \|\b{v}\|})",
               R"($\b{u}$ and $\b{v}$ are where the warp and the weft of the rest shape lie now. $C$ is the sine of the shear; divided by both lengths, it is blind to stretch.)"},
              {R"(\b{u} = q_{11} (\b{x}_1 - \b{x}_0) + q_{12} (\b{x}_2 - \b{x}_0), \quad \b{v} = q_{21} (\b{x}_1 - \b{x}_0) + q_{22} (\b{x}_2 - \b{x}_0))",
               R"(The four numbers $q$ (1/m) follow from the triangle at rest, where $\b{u}$ and $\b{v}$ have length 1, and never change.)"}},
         .rows = {"DC2"}},
        {.sort = sort,
         .name = "bend",
         .title = "Bend",
         .marks = {"Bend,"},
         .header = "core/constraints/bend.h",
         .lesson = "Two triangles that share an edge keep the angle of the fold between them.",
         .equations =
             {{R"(C(\b{x}) = \theta - \theta_0, \quad \theta = \text{atan2}(\frac{(\b{m} \times \b{n}) \cdot \b{e}}{\|\b{e}\|}, \b{m} \cdot \b{n}))",
               R"($\b{e} = \b{x}_1 - \b{x}_0$ is the edge that both share, $\b{m}$ and $\b{n}$ stand at right angles on the triangle to its left and to its right, and $\theta_0$ (rad) is the fold at rest: 0 for cloth that was woven flat.)"},
              {R"(\nabla_2 C = - \frac{\|\b{e}\|}{\|\b{m}\|^2} \b{m}, \quad \nabla_3 C = - \frac{\|\b{e}\|}{\|\b{n}\|^2} \b{n})",
               R"(The two corners that are not on the edge move across their triangles; the two on the edge take back what these were given, and the turning too.)"},
              {R"(E = \frac{1}{2 \alpha} C^2)",
               R"(Bending is always soft: with the compliance $\alpha$ (rad per N m) a fold stores the energy $E$ (J), as a hinge with a spring in it.)"}},
         .rows = {"DC3", "DC6", "DC9"}},
        {.sort = sort,
         .name = "attach",
         .title = "Attach",
         .marks = {"Attach,"},
         .header = "core/constraints/attach.h",
         .lesson = "A point is held at a place, which may move: a pin that may give way.",
         .equations =
             {{R"(C(\b{x}) = \|\b{x} - \b{p}(t)\|)",
               R"($\b{p}(t)$ is where the point is to be at time $t$.)"},
              {R"(C = \alpha F)",
               R"(At rest a soft pin lags behind by its compliance $\alpha$ (m/N) times the load $F$ (N). With $\alpha = 0$ it is hard.)"}},
         .rows = {"AT18", "AT25", "DC19"}},
        {.sort = sort,
         .name = "tether",
         .title = "Tether",
         .marks = {"Tether,"},
         .header = "core/constraints/tether.h",
         .lesson =
             "A point goes no further from a pin than cloth that does not stretch would let it.",
         .equations =
             {{R"(C(\b{x}) = \|\b{x} - \b{a}\| - L \le 0)",
               R"($\b{a}$ is the pin, $L$ (m) the shortest way to it along the cloth. Nearer it may come, so only $C > 0$ is corrected.)"}},
         .rows = {"DC7"},
         .maps = {"resolution"}},
        {.sort = sort,
         .name = "plane-contact",
         .title = "Contact with a plane",
         .marks = {"PlaneContact,"},
         .header = "core/constraints/contact.h",
         .lesson = "A point stays above a floor.",
         .equations =
             {{R"(C(\b{x}) = \b{n} \cdot (\b{x} - \b{p}) - d \ge 0)",
               R"($\b{p}$ is a point of the plane, $\b{n}$ the direction away from it, $d$ (m) the thickness. A contact pushes and never pulls: where $C > 0$ it does nothing.)"}},
         .rows = {"CC1", "CC22"}},
        {.sort = sort,
         .name = "sphere-contact",
         .title = "Contact with a ball",
         .marks = {"SphereContact,"},
         .header = "core/constraints/contact.h",
         .lesson = "A point stays outside of a ball.",
         .equations =
             {{R"(C(\b{x}) = \|\b{x} - \b{c}\| - r - d \ge 0)",
               R"($\b{c}$ is the centre of the ball, $r$ (m) its radius, $d$ (m) the thickness.)"}},
         .rows = {"CC1"}},
        {.sort = sort,
         .name = "capsule-contact",
         .title = "Contact with a capsule",
         .marks = {"CapsuleContact,"},
         .header = "core/constraints/contact.h",
         .lesson = "A point stays outside of a rod with round ends, as a peg or a limb.",
         .equations =
             {{R"(C(\b{x}) = \|\b{x} - \b{q}\| - r - d \ge 0, \quad \b{q} = \b{a} + s (\b{b} - \b{a}))",
               R"($\b{q}$ is the point of the axis from $\b{a}$ to $\b{b}$ that is nearest to $\b{x}$; $s$, from 0 to 1, is where along the axis it lies.)"}},
         .rows = {"CC1"}},
        {.sort = sort,
         .name = "volume",
         .title = "Volume",
         .marks = {"Volume,"},
         .header = "core/constraints/volume.h",
         .lesson =
             "What a closed skin holds keeps its volume: one constraint over all of its triangles.",
         .equations =
             {{R"(C(\b{x}) = \sum_{\text{triangles}} \frac{1}{6} \b{x}_0 \cdot (\b{x}_1 \times \b{x}_2) - V)", R"(Each triangle is the base of a tetrahedron whose top is one point that all share, wherever it is. With their signs their volumes add up to what the skin holds; $V$ (m³) is what it is to hold.)"},
              {R"(\nabla_0 C = \frac{1}{6} \b{x}_1 \times \b{x}_2)",
               R"(A triangle pushes its corners outward in proportion to its area, as a pressure does.)"}},
         .rows = {"AW13", "AW14", "DC13", "DC16"}},
    };
}

}  // namespace plait
