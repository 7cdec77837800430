#include "woven.h"

#include <plait/sheets/mend_set.h>
#include <plait/sheets/strands/strand_set.h>
#include <plait/stencils.h>

#include <array>
#include <cstdlib>

namespace plait {

ThreadOf gridThreads(int columns) {
    return [columns](int a, int b) {
        const int apart = std::abs(b - a);
        return apart == 1 ? Thread::warp : apart == columns ? Thread::weft : Thread::bias;
    };
}

std::vector<int> weave(World& world, Range cloth, const ThreadOf& threadOf, double shearStiffness,
                       const std::string& name, double mending) {
    std::array<Rows<Stretch>, 4> sets;
    auto& [warp, weft, gathers, bias] = sets;
    const Rows<Stretch> edges = restRows<Stretch>(edgeStencils(world.complex, cloth), world.rest);
    for (std::size_t i = 0; i < edges.rows.size(); ++i) {
        const int a = edges.ids[2 * i], b = edges.ids[2 * i + 1];
        const Thread thread = threadOf(a - cloth.first, b - cloth.first);
        if (thread == Thread::none) continue;
        Rows<Stretch>& set = sets[static_cast<std::size_t>(thread)];
        set.ids.insert(set.ids.end(), {a, b});
        set.rows.push_back(edges.rows[i]);
    }
    // A square cell sheared by an angle has its diagonal longer by that times its length / 2.
    for (auto& row : bias.rows) row.compliance = row.compression = 1 / (2 * shearStiffness);
    for (auto& row : gathers.rows) row.compression = slack;
    Rows<Stretch> threads = warp;
    for (const auto* set : {&weft, &gathers}) {
        threads.ids.insert(threads.ids.end(), set->ids.begin(), set->ids.end());
        threads.rows.insert(threads.rows.end(), set->rows.begin(), set->rows.end());
    }
    if (mending > 0)
        mend(world, threads, {.name = name + "mending", .order = -1}, {.tolerance = mending});
    strand(world, warp, {.name = name + "warp"});
    strand(world, weft, {.name = name + "weft", .order = 1});
    if (!gathers.rows.empty()) world.constrain(gathers, {.name = name + "gathers", .order = 1});
    world.constrain(bias, {.name = name + "bias", .order = 2});
    return threads.ids;
}

}  // namespace plait
