// Methods: how all constraints are made to hold together in a step of time.
#include "topics.h"

namespace plait {

std::vector<Topic> methodTopics() {  // NOLINT(readability-function-size): a table
    constexpr TopicSort sort = TopicSort::method;
    return {
        {.sort = sort,
         .name = "xpbd",
         .title = "XPBD",
         .marks = {"xpbd"},
         .header = "core/methods/sweeps/xpbd.h",
         .lesson =
             "Every constraint is corrected in turn, and remembers what it has given, so that a "
             "spring is as stiff as its newtons say however often it is asked.",
         .equations =
             {{R"(\Delta \lambda = \frac{-C - \frac{\alpha}{h^2} \lambda}{\nabla C \b{W} \nabla C^T + \frac{\alpha}{h^2}}, \quad \Delta \b{x} = \b{W} \nabla C^T \Delta \lambda)",
               R"($\lambda$ is what the constraint has pushed in this substep so far, $\alpha$ (m/N) its compliance, $h$ (s) the substep, $\b{W}$ (1/kg) the inverse masses. With $\alpha = 0$ it is rigid.)"},
              {R"(\b{v} \gets \b{v} + h \b{W} \b{f}, \quad \b{x} \gets \b{x} + h \b{v}, \quad \text{sweeps}, \quad \b{v} \gets \frac{\b{x} - \b{x}^{-}}{h})",
               R"(A substep: forces $\b{f}$ change velocities, everything goes where it would by itself, constraints put it right, and the velocity is what came of it. $\b{x}^{-}$ is where the substep began.)"}},
         .rows = {"DC12", "IN9", "IN10", "IN13"},
         .maps = {"step-stiffness", "mass-ratio", "stiffness-ratio", "chain-length"}},
        {.sort = sort,
         .name = "nucleus",
         .title = "Nucleus",
         .marks = {"nucleus"},
         .header = "core/methods/sweeps/nucleus.h",
         .lesson =
             "The paper of 2009: every constraint is put right in turn and forgets it. How stiff "
             "something is, is how often it is asked.",
         .equations =
             {{R"(f(a) = C(\b{x} + h \b{v} + a \b{d}) = 0, \quad a = - \frac{f(0)}{f'(0)})",
               R"(Along a direction $\b{d}$, the gradient, one step of Newton's method finds how far to go. More steps are wasted, as the next constraint moves everything again.)"}},
         .rows = {"AR1", "IN7", "IN9", "IN10", "SC1", "SC8"},
         .maps = {"chain-length"}},
        {.sort = sort,
         .name = "block",
         .title = "Vertex block descent",
         .marks = {"block"},
         .header = "core/methods/block/block.h",
         .lesson =
             "Not constraints but points take turns: each goes to where all that pulls at it is "
             "in balance.",
         .equations =
             {{R"(\min_{\b{x}} \frac{1}{2 h^2} \|\b{x} - \b{y}\|_{\b{M}}^2 + \sum_c (\frac{k}{2} C_c^2 + \lambda C_c))",
               R"(What a step makes least: to be far from $\b{y}$, where everything would go by itself, against what constraints store. $k$ is a stiffness (1 over the compliance), $\lambda$ the force of what is rigid.)"},
              {R"((\frac{m}{h^2} \b{I} + \sum_c k \b{g} \b{g}^T + \b{G}) \Delta \b{x} = \frac{m}{h^2} (\b{y} - \b{x}) - \sum_c (k C + \lambda) \b{g})",
               R"(One vertex's turn: three equations for three numbers, over the constraints $c$ that have a part in it; $\b{g}$ is their gradient there, $\b{G}$ keeps the matrix positive.)"}},
         .rows = {"IN9"},
         .maps = {"mass-ratio", "stiffness-ratio", "step-stiffness"}},
        {.sort = sort,
         .name = "global",
         .title = "Newton on tensions",
         .marks = {"global"},
         .header = "core/methods/global/global.h",
         .lesson =
             "All links of a cloth at once: each keeps a tension, and one large equation says how "
             "everything moves.",
         .equations =
             {{R"((\frac{\b{M}}{h^2} + \sum \b{D} \b{H} \b{D}^T) \Delta \b{x} = \frac{\b{M}}{h^2} (\b{y} - \b{x}) - \sum T' \nabla C)",
               R"($T$ (N) is the tension of a link, $T'$ that tension with what the link is too long by now; $\b{D}$ picks the two ends of a link.)"},
              {R"(\b{H} = k' \b{u} \b{u}^T + \frac{\max(T, 0)}{l} (\b{I} - \b{u} \b{u}^T))",
               R"($\b{u}$ is the direction of the link and $l$ its length. The second part is what a taut thread has against being turned; without it a sheet of rigid links is stiff in no direction that matters.)"}},
         .rows = {"DC7"},
         .maps = {"resolution"}},
        {.sort = sort,
         .name = "newton",
         .title = "Newton's method, to convergence",
         .marks = {"newton"},
         .header = "core/methods/newton/newton.h",
         .lesson =
             "The step is solved until nothing is left to solve. It is what the other methods are "
             "measured against, and far too slow for a film.",
         .equations =
             {{R"(\frac{\b{M}}{h^2} (\b{x} - \b{y}) = \nabla C^T \b{λ}, \quad C(\b{x}) + \frac{\alpha}{h^2} \lambda = 0)",
               R"(What holds at the end of a step: masses are moved from where they would have gone by the forces of the constraints, and each constraint is off by its compliance times its force.)"}},
         .rows = {"IN3", "IN16"},
         .maps = {"step-stiffness"}},
        {.sort = sort,
         .name = "linearised",
         .title = "All at once, made linear",
         .marks = {"linearised"},
         .header = "core/methods/linearised.h",
         .lesson = "What the paper of 2009 tried first and gave up: one linear equation for all "
                   "constraints. Good while nothing turns far.",
         .equations =
             {{R"(C(\b{x} + h \b{v}) + \nabla C(\b{x} + h \b{v}) h \Delta \b{v} = 0)",
               R"(Each constraint, as it would be if it went on as it does where the step leads. All of these together are solved by least squares (LSQR).)"}},
         .rows = {"IN8"},
         .maps = {"rotation"}},
        {.sort = sort,
         .name = "explicit",
         .title = "Explicit Euler",
         .marks = {"explicit"},
         .header = "core/methods/springs/explicit.h",
         .lesson =
             "Go on as things are now. It always gains energy, and is here to be seen failing.",
         .equations =
             {{R"(\b{x} \gets \b{x} + h \b{v}, \quad \b{v} \gets \b{v} + h \b{W} \b{f}(\b{x}^{-}))",
               R"(Both lines take what the substep began with, $\b{x}^{-}$.)"},
              {R"(\frac{r_1}{r_0} = \sqrt{1 + h^2 \omega^2} > 1)",
               R"(By how much the swing of a spring of the frequency $\omega$ (1/s) grows in each substep, whatever $h$.)"}},
         .rows = {"IN2"},
         .maps = {"step-stiffness"}},
        {.sort = sort,
         .name = "symplectic",
         .title = "Symplectic Euler",
         .marks = {"symplectic"},
         .header = "core/methods/springs/symplectic.h",
         .lesson =
             "First the velocity, then the place: the swing neither grows nor dies, up to a step "
             "that is exactly known.",
         .equations =
             {{R"(\b{v} \gets \b{v} + h \b{W} \b{f}(\b{x}), \quad \b{x} \gets \b{x} + h \b{v})",
               R"(The new velocity moves the place. Areas in the plane of place and velocity stay the same.)"},
              {R"(h < \frac{2}{\omega})",
               R"(Beyond it a spring of the frequency $\omega$ explodes; there is no step in between that is a little wrong.)"}},
         .rows = {"IN4", "IN5", "IN6"},
         .maps = {"step-stiffness"}},
        {.sort = sort,
         .name = "implicit",
         .title = "Implicit Euler",
         .marks = {"implicit"},
         .header = "core/methods/springs/implicit.h",
         .lesson =
             "Go to where the forces of the end lead back to the beginning. It never explodes, and "
             "swallows motion.",
         .equations =
             {{R"((\b{M} - h^2 \b{K}) \Delta \b{v} = h (\b{f} + h \b{K} \b{v}), \quad \b{K} = \frac{\partial \b{f}}{\partial \b{x}})",
               R"(One step of Newton's method towards the forces at the end of the substep, after Baraff and Witkin.)"},
              {R"(\frac{r_1}{r_0} = \frac{1}{\sqrt{1 + h^2 \omega^2}} < 1)",
               R"(By how much a swing shrinks in each substep, wanted or not.)"}},
         .rows = {"IN3"},
         .maps = {"step-stiffness"}},
    };
}

}  // namespace plait
