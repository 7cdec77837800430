// Which pairs may meet does not depend on when they were looked for.
#include "catch.h"
#include "contacts/pair_search.h"
#include "contacts/paths.h"
#include "random.h"
#include "report.h"
#include "workers.h"

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace plait;
using namespace plait::test;

namespace {

using Points = std::vector<Vec<double>>;

constexpr double thickness = 0.02, slack = 0.02, reach = 2 * thickness + slack;

PairSearch searchOf(const SimplicialComplex& complex, double margin) {
    const std::vector<unsigned char> pinned(complex.count(0), 0);
    return {complex, {{.vertices = {0, complex.count(0)}, .thickness = thickness}}, pinned, margin};
}

// As contacts choose them.
std::vector<std::tuple<int, std::array<int, 4>>> chosen(const PairSearch& search,
                                                        const Points& start, const Points& end,
                                                        Workers& workers) {
    std::vector<std::vector<Pairing>> parts;
    search.collect(parts, 3 * slack, workers, [&](const Pairing& pair, std::vector<Pairing>& list) {
        PairPoints from, to;
        for (std::size_t i = 0; i < 4; ++i)
            from[i] = start[pair.vertices[i]], to[i] = end[pair.vertices[i]];
        const double distance = length(nearest(pair, from).apart);
        if (mayMeet(pair, from, to, reach) && movesBy(distance - reach, pair, from, to))
            list.push_back(pair);
    });
    std::vector<std::tuple<int, std::array<int, 4>>> all;
    for (const auto& part : parts)
        for (const Pairing& pair : part) all.emplace_back(pair.first, pair.vertices);
    std::ranges::sort(all);
    return all;
}

}  // namespace

// Some vertices stray, and others dart: an edge whose one end has strayed furthest while the other
// goes furthest was once left out. And all of them turn, as a skirt does.
TEST_CASE("contacts: pairs looked for long ago are those looked for now", "[contacts]") {
    const double angle = GENERATE(0.0, 0.2);  // rad
    const auto turned = [&](const Vec<double>& a) -> Vec<double> {
        return {std::cos(angle) * a.x - std::sin(angle) * a.y,
                std::sin(angle) * a.x + std::cos(angle) * a.y, a.z};
    };
    Random random(7);
    constexpr int triangles = 80;
    Simplices cells;
    Points x, drift;
    for (int t = 0; t < triangles; ++t) {
        cells.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        const Vec<double> middle = random.point(0.4);
        for (int i = 0; i < 3; ++i) x.push_back(middle + random.point(0.1));
    }
    const SimplicialComplex complex(3 * triangles, cells);
    Workers workers(1);
    PairSearch old = searchOf(complex, 0.2);
    long searches = 0, pairs = 0, differing = 0;
    for (int step = 0; step < 400; ++step) {
        if (step % 8 == 0) {
            drift.clear();
            for (std::size_t v = 0; v < x.size(); ++v)
                drift.push_back((random.below(2) ? 0.2 : 0.01) * random.point(0.01));
        }
        Points end;
        for (std::size_t v = 0; v < x.size(); ++v)
            end.push_back(
                turned(x[v] + drift[v] + (random.below(4) ? 0.0 : 1.0) * random.point(0.01)));
        searches += old.cover(x, end, slack, workers);
        PairSearch fresh = searchOf(complex, 0.01);
        fresh.cover(x, end, slack, workers);
        const auto expected = chosen(fresh, x, end, workers);
        pairs += static_cast<long>(expected.size());
        differing += chosen(old, x, end, workers) != expected;
        for (std::size_t v = 0; v < x.size(); ++v) x[v] = turned(x[v] + drift[v]);
    }
    note("pairs", static_cast<double>(pairs));
    note("times looked for", static_cast<double>(searches));
    CHECK(searches < 100);
    CHECK(differing == 0);
}
