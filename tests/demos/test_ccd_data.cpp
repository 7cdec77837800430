// Collision queries against the answers of published query sets (PLAIT_CCD_DATA; skipped without).
#include "ccd_folder.h"
#include "demos/tools/errors.h"
#include "program.h"
#include "tests/catch.h"
#include "tests/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

using namespace plait;
using plait::test::note;
using plait::test::report;

namespace {

// Calls back with each table's name and rows.
void eachTable(const std::function<void(const std::string&, const std::vector<CcdQuery>&)>& body) {
    if (!test::haveCcdData()) return;
    for (const std::string& name : ccdTables(test::ccdData()))
        body(name, readCcdQueries(test::ccdData() / "open" / (name + ".csv.gz")));
}

// The same query with ends, corners and edges in other orders, each followed by its reverse in
// time.
std::vector<CcdQuery> rewritten(const CcdQuery& query) {
    using Order = std::array<int, 4>;
    const std::vector<Order> triangles{{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                       {0, 1, 3, 2}, {0, 2, 1, 3}, {0, 3, 2, 1}};
    const std::vector<Order> edges{{0, 1, 2, 3}, {1, 0, 2, 3}, {0, 1, 3, 2}, {1, 0, 3, 2},
                                   {2, 3, 0, 1}, {3, 2, 0, 1}, {2, 3, 1, 0}, {3, 2, 1, 0}};
    std::vector<CcdQuery> all;
    for (const Order& order : query.edges ? edges : triangles) {
        CcdQuery other = query;
        for (int i = 0; i < 4; ++i) other.vertex[i] = query.vertex[order[i]];
        all.push_back(other);
        for (MovingVertex& m : other.vertex) m = {m.end, m.start};
        all.push_back(other);
    }
    return all;
}

struct Count {
    int asked = 0, missed = 0, invented = 0, late = 0, early = 0;

    // `low` and `high` bracket the first time.
    void add(const Impact& impact, double low, double high, double speed) {
        ++asked;
        missed += !impact;
        if (!impact) return;
        late += *impact > high;
        early += *impact < low - (1e-6 + 1e-6 / speed);
    }
};

void print(const std::string& what, const Count& c) {
    CHECK(report(what + ": missed", c.missed, 0));
    CHECK(report("  told late", c.late, 0));
    CHECK(report("  told more than 1e-6 + 1e-6 / speed early", c.early, 0.001 * c.asked));
    CHECK(c.asked > 100);
}

}  // namespace

TEST_CASE("query sets that cannot be read are named", "[ccd]") {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "text") << "not compressed, and longer than eighteen bytes";
    const std::ofstream empty(folder / "empty");
    std::filesystem::create_directory(folder / "folder");
    for (const char* name : {"text", "empty", "folder", "absent"}) {
        std::string message;
        try {
            readCcdQueries(folder / name);
        } catch (const FileError& error) {
            message = error.what();
        }
        CHECK(message.starts_with((folder / name).string() + ": "));
    }
}

TEST_CASE("query sets: none missed, none late, nearly none invented", "[ccd][CC5][CC6]") {
    eachTable([](const std::string& name, const std::vector<CcdQuery>& queries) {
        Count thin, thick, close;
        int apart = 0, inventedApart = 0;
        for (const CcdQuery& q : queries) {
            const Impact impact = answer(q, 0);
            if (q.touches) {
                thin.add(impact, q.timeLow, q.timeHigh, q.speed());
            } else {
                thin.invented += impact.has_value();
                inventedApart += impact && q.distances && q.leastLow > 1e-6;
            }
            if (!q.distances) continue;
            thick.add(answer(q, q.thickness), q.thickLow, q.thickHigh, q.speed());
            close.missed += !answer(q, 1.001 * q.leastHigh);
            const double clear = 0.999 * q.leastLow - 1e-6;
            if (!(clear > 0)) continue;
            ++apart;
            inventedApart += answer(q, clear).has_value();
        }
        print(name + ", thin", thin);
        print(name + ", thick", thick);
        CHECK(report("  missed at 1.001 times the least distance", close.missed, 0));
        CHECK(report("  told where they pass by, thin", thin.invented, 35));
        CHECK(report("  told where they are 1e-6 clear", inventedApart, 0));
        note("  rows", static_cast<double>(queries.size()));
        note("  rows with a clearance", apart);
    });
}

TEST_CASE("query sets rewritten: ends, corners, edges swapped, time reversed", "[ccd][CC5][CC6]") {
    eachTable([](const std::string& name, const std::vector<CcdQuery>& queries) {
        int asked = 0, missed = 0, late = 0, invented = 0, originals = 0, missedThick = 0;
        for (const CcdQuery& q : queries) {
            bool forward = false;
            for (const CcdQuery& other : rewritten(q)) {
                ++asked;
                forward = !forward;
                const Impact told = answer(other, 0);
                missed += q.touches && !told;
                late += forward && q.touches && told > q.timeHigh;
                invented += !q.touches && told;
                if (q.distances) missedThick += !answer(other, 1.001 * q.leastHigh);
            }
            originals = static_cast<int>(rewritten(q).size());
        }
        CHECK(report(name + " rewritten: missed", missed, 0));
        CHECK(report("  told late", late, 0));
        CHECK(report("  missed at 1.001 times the least distance", missedThick, 0));
        CHECK(report("  told where they pass by, of each order", double(invented) / originals, 35));
        note("  queries", asked);
    });
}

// Rows hold no truth for these: the distance is sampled instead.
TEST_CASE("query sets: their ends as points, and as points and edges", "[ccd][CC6]") {
    constexpr int samples = 257;
    eachTable([](const std::string& name, const std::vector<CcdQuery>& queries) {
        int missed = 0, late = 0, invented = 0, asked = 0;
        double off = 0;
        for (std::size_t i = 0; i < queries.size(); i += 4) {
            const auto& [a, b, c, d] = queries[i].vertex;
            for (const bool edge : {false, true}) {
                const auto distance = [&](double t) {
                    const Vec<double> u = at(c, t) - at(a, t), e = at(d, t) - at(c, t);
                    if (!edge) return length(u);
                    const double s = std::clamp(divide(-dot(u, e), dot(e, e)), 0.0, 1.0);
                    return length(u + s * e);
                };
                double least = distance(0);
                for (int k = 0; k < samples; ++k)
                    least = std::min(least, distance(k / (samples - 1.0)));
                for (const double thickness : {1.01 * least, 0.5 * (least + distance(0))}) {
                    // No ties, which rounding here would decide.
                    if (!(thickness > 1e-9 && thickness > least * (1 + 1e-9))) continue;
                    ++asked;
                    const Impact impact = edge ? thickPointEdge(a, c, d, thickness)
                                               : thickPointPoint(a, c, thickness);
                    missed += !impact;
                    if (!impact) continue;
                    if (*impact > 0) off = std::max(off, std::abs(distance(*impact) - thickness));
                    if (*impact == 0) invented += distance(0) > thickness * (1 + 1e-9);
                    for (int k = 0; k < samples; ++k) {
                        const double t = k / (samples - 1.0);
                        late += t < *impact && distance(t) < thickness * (1 - 1e-12);
                    }
                }
            }
        }
        CHECK(report(name + ", points and edges: missed", missed, 0));
        CHECK(report("  told late", late, 0));
        CHECK(report("  told at the start where they are apart", invented, 0));
        CHECK(report("  distance when told - thickness (m)", off, 1e-9));
        note("  queries", asked);
    });
}
