// Constraints that are more than a few vertices each: solved at once along a curve or over a sheet,
// bodies, liquids, and all that keeps matter apart.
#include "topics.h"

namespace plait {

std::vector<Topic> setTopics() {  // NOLINT(readability-function-size): a table
    constexpr TopicSort sort = TopicSort::constraint;
    return {
        {.sort = sort,
         .name = "chain",
         .title = "Chains and trees, solved at once",
         .marks = {"DirectSet<"},
         .header = "core/sets/direct_set.h",
         .lesson = "All links of a chain are solved together, so that what one end feels the other "
                   "knows at once.",
         .equations =
             {{R"((\b{J} \b{W} \b{J}^T + \frac{\alpha}{h^2}) \Delta \b{λ} = - (\b{C} + \frac{\alpha}{h^2} \b{λ}))",
               R"(A row for each link: $\b{C}$ says how much too long each is, $\b{J}$ has their gradients, $\b{W}$ the inverse masses, $h$ (s) is the substep. A link couples only with its neighbours, so that the work is in proportion to their number.)"}},
         .rows = {"SH8", "IN8"},
         .maps = {"chain-length", "mass-ratio", "rotation"}},
        {.sort = sort,
         .name = "rod",
         .title = "Rod: length, bending and twist",
         .marks = {"ChainSet<"},
         .header = "core/rods/chain_set.h",
         .lesson = "A wire keeps its length, and springs back from being bent and twisted; all "
                   "along it is solved at once.",
         .equations =
             {{R"(\b{C} = \psi \b{u}, \quad E = \frac{B}{2 \ell} \psi^2)",
               R"(At a joint of a wire that is straight at rest: $\psi$ (rad) is by how much it turns, $\b{u}$ the direction in which, $B$ (N m²) what its steel and section resist bending with, and $\ell$ (m) the length of a link.)"},
              {R"(C = (\b{g} - \b{m}) \cdot \b{t}, \quad C = \|\b{g} - \b{m}\| - r)",
               R"(A wire that can be twisted has a director: a point $\b{g}$ beside the middle $\b{m}$ of each link, across its direction $\b{t}$ and a fixed way $r$ off. How directors of neighbours turn about each other is the twist.)"},
              {R"((\b{J} \b{W} \b{J}^T + \frac{\alpha}{h^2}) \Delta \b{λ} = - (\b{C} + \frac{\alpha}{h^2} \b{λ}))",
               R"(Length, bending and twist of the whole wire are one band of a matrix. One evaluation is one step of Newton's method, however fine the wire is divided.)"}},
         .rows = {"DC2", "DC3", "FX4", "FX23", "FX30", "SH8"},
         .maps = {"rod-segments", "stairs"}},
        {.sort = sort,
         .name = "strands",
         .title = "Strands of a sheet",
         .marks = {"StrandSet<"},
         .header = "core/sheets/strands/strand_set.h",
         .lesson =
             "Each thread of a cloth is solved whole, warp and then weft, so that a fine cloth "
             "stretches no more than a coarse one.",
         .equations =
             {{R"((\b{J} \b{W} \b{J}^T) \Delta \b{λ} = - \b{C})",
               R"(One such equation a thread, with a row for each of its links: three numbers a row differ from 0, and eight threads run side by side.)"},
              {R"(\b{K} = \frac{\lambda}{\ell} (\b{I} - \b{n} \b{n}^T))",
               R"(What a taut thread has against being turned: the larger its tension $\lambda$ and the shorter the link $\ell$, the more. With it a wave may pass many links in a substep.)"}},
         .rows = {"DC1", "DC7", "FX1", "FX2", "SC13"},
         .maps = {"resolution", "bdf2-sweeps"}},
        {.sort = sort,
         .name = "aggregates",
         .title = "Coarse levels of a sheet",
         .marks = {"AggregateSet<"},
         .header = "core/sheets/aggregates/aggregate_set.h",
         .lesson =
             "Groups of neighbours are corrected as one, so that news crosses a large sheet in "
             "a few steps.",
         .equations =
             {{R"(\b{X}_I = \frac{1}{M_I} \sum_{i \in I} m_i \b{x}_i, \quad M_I = \sum_{i \in I} m_i)",
               R"(A group $I$ is where its members are in the mean, each by its mass $m$. What the group is moved by, all members are moved by: so momentum stays.)"}},
         .rows = {"SC13"}},
        {.sort = sort,
         .name = "mending",
         .title = "Mending",
         .marks = {"MendSet<"},
         .header = "core/sheets/mend_set.h",
         .lesson = "Links that are still too long in the end are swept again, they and their "
                   "neighbours, until they are not.",
         .equations =
             {{R"(\frac{\|\b{x}_1 - \b{x}_0\|}{\ell} - 1 > \epsilon)",
               R"(A link is mended while it is too long by more than the part $\epsilon$, which is what the scene promises: mostly 1 %.)"}},
         .rows = {"DC7", "SC19"}},
        {.sort = sort,
         .name = "membrane",
         .title = "Rubber and the gas it holds",
         .marks = {"MembraneSet<"},
         .header = "core/membranes/membrane_set.h",
         .lesson =
             "Rubber has most against being stretched at first; the gas inside presses back, the "
             "more the less room it has. Both are solved at once.",
         .equations =
             {{R"(W = \sum_i \frac{\mu_i}{\alpha_i} (a^{\alpha_i} + b^{\alpha_i} + (a b)^{-\alpha_i} - 3))",
               R"(The energy of rubber (J in a cubic metre) that is $a$ times as long and $b$ times as wide as at rest, after Ogden; it keeps its volume, and so is thinner by $a b$. $\mu$ (Pa) and $\alpha$ are measured.)"},
              {R"(p = \frac{n R T}{V} - p_0)",
               R"(The gas inside presses with $p$ (Pa) beyond the air outside, $p_0$; its amount and its heat $n R T$ (J) stay, $V$ (m³) follows the skin.)"},
              {R"((\frac{\b{M}}{h^2} + \nabla^2 E) \Delta \b{x} = - (\frac{\b{M}}{h^2} (\b{x} - \b{y}) + \nabla E))",
               R"(One step of Newton's method on rubber, springs and gas together: $\b{M}$ (kg) are the masses, $\b{y}$ is where everything would go by itself in the substep $h$, $E$ all energy.)"}},
         .rows = {"AW13", "AW14", "AW15", "FX6"}},
        {.sort = sort,
         .name = "density",
         .title = "Density of a liquid",
         .marks = {"LiquidSet<"},
         .header = "core/particles/liquid_set.h",
         .lesson =
             "Water is particles that will not be crowded: where they come too near, they part.",
         .equations =
             {{R"(C_i = \frac{1}{\rho_0} \sum_j W(\|\b{x}_i - \b{x}_j\|) + s_i - 1 \le 0)", R"(One for each particle $i$: how crowded it is, against water at rest. $W$ is large for what is near and 0 beyond the radius of the kernel, $s_i$ is what walls hide of its surroundings. Too few neighbours are no fault, as at the surface.)"},
              {R"(W(q) = 2 (1 - q)^3 - 8 (\frac{1}{2} - q)^3, \quad 0 \le q \le 1)",
               R"(The cubic spline: $q$ is the distance over the radius of the kernel; the second term is left out from $q = 1/2$ on.)"}},
         .rows = {"DC16", "FL1", "FL2", "FX5"}},
        {.sort = sort,
         .name = "pieces",
         .title = "Rigid pieces",
         .marks = {"PieceSet<"},
         .header = "core/pieces/piece_set.h",
         .lesson = "What is rigid is put back to its shape, turned and placed as near as can be to "
                   "where its points went.",
         .equations =
             {{R"((\b{R}, \b{c}) = \argmin_{\b{R}, \b{c}} \sum_i m_i \|\b{R} \b{r}_i + \b{c} - \b{x}_i\|^2)",
               R"($\b{r}_i$ is where point $i$ lies in the piece, $\b{c}$ where its centre is, $\b{R}$ how it is turned. Momentum and angular momentum stay as they are.)"}},
         .rows = {"DC10", "DC15"}},
        {.sort = sort,
         .name = "welds",
         .title = "Welds that break",
         .marks = {"WeldSet<"},
         .header = "core/fracture/weld_set.h",
         .lesson = "Pieces hold together as one body, until a face between two of them bears more "
                   "than it can.",
         .equations =
             {{R"(\frac{N}{l t} + \frac{6 |M_l|}{l t^2} + \frac{6 |M_t|}{t l^2} > \sigma)",
               R"(A weld breaks where tension and bending together reach its strength $\sigma$ (Pa): $N$ (N) pulls on a face that is $l$ long and $t$ thick (m), and $M_l$ and $M_t$ (N m) bend it about either side, as in any beam.)"},
              {R"((\frac{\b{M}}{\tau^2} + \b{K}) \b{u} = \b{F})",
               R"(What each weld bears under a blow $\b{F}$ that presses for the time $\tau$: $\b{M}$ are the masses of the pieces, $\b{K}$ are the springs of all welds, $\b{u}$ how pieces move.)"}},
         .rows = {"AT6", "BR1", "BR2", "BR5", "BR7", "FX3"}},
        {.sort = sort,
         .name = "contact",
         .title = "Contact between matter",
         .marks = {"ContactSet<"},
         .header = "core/contacts/matter/contact_set.h",
         .lesson =
             "Points, edges and triangles that meet on their way keep a thickness apart, and never "
             "pass through each other, however fast they are.",
         .equations =
             {{R"(C(\b{x}) = \b{n} \cdot (\b{x}_a - \b{x}_b) - d \ge 0, \quad \lambda \ge 0)",
               R"($\b{x}_a$ and $\b{x}_b$ are where the two are nearest, $\b{n}$ points from one to the other, $d$ (m) is the sum of their thicknesses. The multiplier $\lambda$, the push, is never negative: a contact does not pull.)"},
              {R"((\b{p}_1 - \b{p}_0) \cdot ((\b{p}_2 - \b{p}_0) \times (\b{p}_3 - \b{p}_0)) = 0, \quad \b{p}_i = \b{x}_i + t \Delta \b{x}_i)",
               R"(When four points that go straight lie in one plane: a polynomial of degree 3 in the time $t$ from 0 to 1. Only then can a point pass through a triangle, or an edge through an edge. With thickness the degree is 6.)"},
              {R"(|\b{λ}_t| \le \mu \lambda)",
               R"(Friction takes back what the two slid along each other, with at most $\mu$ times the push (Coulomb).)"}},
         .rows = {"CC1", "CC2", "CC5", "CC6", "CC8", "CC9", "FR1", "FR5", "SC5"},
         .maps = {"speed-thickness", "layers-passes"}},
        {.sort = sort,
         .name = "collider",
         .title = "Contact with solids",
         .marks = {"ColliderSet<"},
         .header = "core/contacts/solids/collider_set.h",
         .lesson =
             "Points stay outside of floors, balls, capsules and boxes, which may move and turn.",
         .equations =
             {{R"(C(\b{x}) = \phi(\b{Q}^T (\b{x} - \b{c})) - d \ge 0)",
               R"($\phi$ is the distance to the solid in its own axes, $\b{Q}$ and $\b{c}$ say how it is turned and where it is, $d$ (m) is the thickness.)"},
              {R"(|\b{λ}_t| \le \mu \lambda)",
               R"(Friction, as between any two things that meet.)"}},
         .rows = {"CC2", "CC14", "CC22", "CC23", "FR5", "FR6"}},
        {.sort = sort,
         .name = "piece-contact",
         .title = "Contact between rigid pieces",
         .marks = {"PieceContacts<"},
         .header = "core/contacts/pieces/piece_contacts.h",
         .lesson =
             "Convex pieces stay apart by a plane between them, and answer as the rigid bodies "
             "that they are.",
         .equations =
             {{R"(C = \b{n} \cdot (\b{x}_a - \b{x}_b) - d \ge 0, \quad \Delta \b{v} = w \lambda \b{n}, \quad \Delta \b{ω} = \b{I}^{-1} (\b{r} \times \lambda \b{n}))",
               R"(One push $\lambda$ at a point $\b{r}$ off the centre moves the whole piece and turns it: $w$ (1/kg) is one over its mass, $\b{I}$ (kg m²) its moment of inertia.)"}},
         .rows = {"CC1", "CC2", "CC13", "FX24"}},
        {.sort = sort,
         .name = "push-out",
         .title = "Push out",
         .marks = {"PushOutSet<"},
         .header = "core/contacts/trouble/push_out_set.h",
         .lesson = "What begins inside a closed surface is moved out of it.",
         .equations =
             {{R"(\Delta \b{x} = k (d - \b{n} \cdot (\b{x} - \b{q})) \b{n})",
               R"($\b{q}$ is the nearest point of the surface, $\b{n}$ the way out, $d$ (m) the thickness; the part $k$ of the way is gone in a step.)"}},
         .rows = {"FH1", "FH2"}},
    };
}

}  // namespace plait
