// The broad phase against brute force, and its bounds against a definition of their own.
#include "soup.h"
#include "tests/catch.h"
#include "tests/random.h"
#include "tests/report.h"

#include <plait/collision/hash_grid.h>
#include <plait/collision/kdop_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using namespace plait;
using plait::test::Random;
using plait::test::Soup;
using plait::test::soup;
using plait::test::soups;

namespace {

using V = Vec<double>;
using Pairs = std::vector<Candidate>;

// Directions by coordinates -1, 0, 1; the i-th from the end is opposite to the i-th.
std::vector<V> directions(int k) {
    std::vector<V> all;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                const int steps = std::abs(x) + std::abs(y) + std::abs(z);
                if (steps == 1 || (steps == 2 && k >= 18) || (steps == 3 && k != 6 && k != 18))
                    all.push_back({double(x), double(y), double(z)});
            }
    return all;
}

using Long = long double;

// How far a primitive reaches in each direction, and the size that roundings are relative to.
struct Reach {
    std::vector<Long> in;
    Long size = 0;
};

Reach reachOf(const Soup& s, int i, const std::vector<V>& to) {
    Reach reach{std::vector<Long>(to.size(), -HUGE_VALL)};
    for (int c = 0; c < 3; ++c)
        for (const V& x : {s.start[s.ids[3 * i + c]], s.end[s.ids[3 * i + c]]}) {
            const Vec<Long> d{Long(x.x) - s.origin.x, Long(x.y) - s.origin.y,
                              Long(x.z) - s.origin.z};
            reach.size = std::max(reach.size, std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z));
            for (std::size_t n = 0; n < to.size(); ++n)
                reach.in[n] = std::max(reach.in[n], to[n].x * d.x + to[n].y * d.y + to[n].z * d.z);
        }
    for (std::size_t n = 0; n < to.size(); ++n)
        reach.in[n] += s.radius * std::sqrt(Long(dot(to[n], to[n])));
    reach.size += 2 * s.radius;
    return reach;
}

std::vector<Reach> reaches(const Soup& s, int k) {
    std::vector<Reach> all;
    for (int i = 0; i < s.count(); ++i) all.push_back(reachOf(s, i, directions(k)));
    return all;
}

// Pairs that overlap, and those that would if each were wider by 2^-20 of its size.
struct Truth {
    Pairs least, most;

    void add(const Reach& p, const Reach& q, Candidate pair) {
        const Long slack = 0x1p-20L * (p.size + q.size);
        bool surely = true;
        for (std::size_t n = 0, m = p.in.size() - 1; n < p.in.size(); ++n, --m) {
            const Long shared = p.in[n] + q.in[m];
            if (shared < -slack) return;
            surely &= shared >= 0;
        }
        most.push_back(pair);
        if (surely) least.push_back(pair);
    }
};

Truth selfTruth(const Soup& s, int k) {
    const auto all = reaches(s, k);
    Truth truth;
    for (int a = 0; a < s.count(); ++a)
        for (int b = a + 1; b < s.count(); ++b) truth.add(all[a], all[b], {a, b});
    return truth;
}

Pairs sorted(const Candidates& found) {
    Pairs pairs(found.pairs().begin(), found.pairs().end());
    std::ranges::sort(pairs);
    return pairs;
}

bool between(const Truth& truth, const Pairs& found) {
    return std::ranges::adjacent_find(found) == found.end() &&
           std::ranges::includes(found, truth.least) && std::ranges::includes(truth.most, found);
}

// Every pair by its own bounds, one by one.
template <int k>
Pairs bruteForce(const Soup& s) {
    std::vector<KDop<k>> bounds;
    for (int i = 0; i < s.count(); ++i) bounds.push_back(s.bounds<k>()(i));
    Pairs pairs;
    for (int a = 0; a < s.count(); ++a)
        for (int b = a + 1; b < s.count(); ++b)
            if (bounds[a].overlaps(bounds[b])) pairs.push_back({a, b});
    return pairs;
}

template <int k>
Pairs treePairs(const Soup& s) {
    Workers workers(2);
    Candidates found;
    KDopTree<k>(s.count(), s.bounds<k>(), workers).selfPairs(found, workers);
    return sorted(found);
}

Pairs gridPairs(const Soup& s) {
    Workers workers(2);
    Candidates found;
    HashGrid grid;
    grid.build(s.count(), s.bounds<6>(), workers);
    grid.selfPairs(found, workers);
    return sorted(found);
}

template <int k>
void compare(const Soup& s) {
    INFO(s.name << ", k = " << k);
    const Pairs found = treePairs<k>(s), brute = bruteForce<k>(s);
    const Truth truth = selfTruth(s, k);
    CHECK(found == brute);
    CHECK(between(truth, found));
    CHECK((s.count() < 100 || !truth.least.empty()));
    if (k == 6) CHECK(gridPairs(s) == brute);
    if (s.name == "swept") {
        test::note("pairs of " + std::to_string(s.count()) + ", k = " + std::to_string(k),
                   static_cast<double>(found.size()));
        CHECK(truth.most.size() - truth.least.size() < 10);
    }
}

void compareAll(const Soup& s) {
    compare<6>(s);
    compare<14>(s);
    compare<18>(s);
    compare<26>(s);
}

// The bounds of one primitive against its reach in the directions that the slabs turn out to have.
template <int k>
void holdBounds() {
    Soup unit{.name = "unit"};
    for (const V& e : {V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}}) unit.add({e, e, e}, {e, e, e});
    std::array<KDop<k>, 3> along;
    for (int a = 0; a < 3; ++a) along[a] = unit.bounds<k>()(a);
    std::vector<V> to;
    for (const int side : {-1, 1})
        for (int i = 0; i < k / 2; ++i) {
            const auto at = [&](int a) { return side * std::round(double(along[a].low[i])); };
            to.push_back({at(0), at(1), at(2)});
        }
    for (const V& d : directions(k)) CHECK(std::ranges::count(to, d) == 1);
    const double scales[]{1e-300, 1e-42, 1e-36, 1e-6, 1, 1e6, 1e30};
    for (const double scale : scales)
        for (const double thick : {0.0, 0.3, 30.0}) {
            Soup s = soup("", 60, scale, scale, scale * thick,
                          [&](Random& r) { return r.point(3 * scale); });
            s.origin = scale * V{0.1, -7, 3};
            int wrong = 0;
            for (int i = 0; i < s.count(); ++i) {
                const KDop<k> b = s.bounds<k>()(i);
                const Reach reach = reachOf(s, i, to);
                const Long slack = 0x1p-20L * reach.size + 0x1p-119L;
                for (int n = 0; n < k / 2; ++n) {
                    const Long low = -reach.in[n], high = reach.in[k / 2 + n];
                    wrong += !(b.low[n] <= low && b.low[n] >= low - slack);
                    wrong += !(b.high[n] >= high && b.high[n] <= high + slack);
                }
            }
            INFO("k = " << k << ", scale " << scale << ", radius " << s.radius);
            CHECK(wrong == 0);
        }
}

// Those of which corners are within their radii of each other at one time or another.
Pairs meetings(const Soup& s) {
    Pairs pairs;
    for (int a = 0; a < s.count(); ++a)
        for (int b = a + 1; b < s.count(); ++b) {
            bool met = false;
            for (int c = 0; c < 9 && !met; ++c)
                for (int step = 0; step <= 16 && !met; ++step) {
                    const auto at = [&](int i) {
                        const int v = s.ids[i];
                        return s.start[v] + step / 16.0 * (s.end[v] - s.start[v]);
                    };
                    met = length(at(3 * a + c / 3) - at(3 * b + c % 3)) < 1.999 * s.radius;
                }
            if (met) pairs.push_back({a, b});
        }
    return pairs;
}

}  // namespace

TEST_CASE("broad phase: bounds hold what is swept, and little more", "[broadphase][BP5]") {
    holdBounds<6>();
    holdBounds<14>();
    holdBounds<18>();
    holdBounds<26>();
    const FlushDenormals flush;
    holdBounds<18>();
}

TEST_CASE("broad phase: tree and grid find the pairs of brute force", "[broadphase][BP1][BP3]") {
    for (const Soup& s : soups(2000)) compareAll(s);
    for (int n = 0; n < 24; ++n)
        compare<14>(soup("few", n, 0.4, 0.1, 0.01, [](Random& r) { return r.point(1); }));
}

TEST_CASE("broad phase: what is not a place overlaps everything", "[broadphase]") {
    for (const double bad : {infinity, -infinity, std::nan(""), 1e300, -1e38}) {
        Soup s = soup("", 200, 0.01, 0.01, 0.001, [](Random& r) { return r.point(1); });
        s.end[3 * 77 + 1].y = bad;
        s.start[3 * 5].z = bad;
        const Pairs found = treePairs<18>(s);
        CHECK(std::ranges::count_if(found, [](auto p) { return p.a == 77 || p.b == 77; }) == 199);
        CHECK(found == bruteForce<18>(s));
        CHECK(gridPairs(s) == bruteForce<6>(s));
        for (V& x : s.start) x.x = bad;
        CHECK(treePairs<18>(s).size() == 199 * 100);
        CHECK(gridPairs(s).size() == 199 * 100);
    }
}

TEST_CASE("broad phase: a refitted tree and a grid built again know new places", "[broadphase]") {
    const auto all = soups(800);
    Workers workers(2);
    Candidates found;
    HashGrid grid;
    KDopTree<18> tree(all[0].count(), all[0].bounds<18>(), workers);
    for (const int i : {1, 9, 0}) {
        tree.refit(all[i].bounds<18>(), workers);
        tree.selfPairs(found, workers);
        CHECK(sorted(found) == bruteForce<18>(all[i]));
    }
    for (const Soup& s : all) {
        grid.build(s.count(), s.bounds<6>(), workers);
        grid.selfPairs(found, workers);
        CHECK(sorted(found) == bruteForce<6>(s));
    }
}

TEST_CASE("broad phase: pairs of two sets", "[broadphase]") {
    const auto anywhere = [](Random& r) { return r.point(1); };
    Workers workers(2);
    Candidates found;
    for (const int n : {0, 1, 3, 40, 900})
        for (const int m : {0, 1, 17, 300}) {
            Soup a = soup("", n, 0.1, 0.1, 0.01, anywhere),
                 b = soup("", m, 0.2, 0.1, 0.02, anywhere);
            for (V& x : b.start) x += {0.01, 0.02, 0.03};
            const auto reachA = reaches(a, 18), reachB = reaches(b, 18);
            Truth truth;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < m; ++j) truth.add(reachA[i], reachB[j], {i, j});
            const KDopTree<18> treeA(n, a.bounds<18>(), workers), treeB(m, b.bounds<18>(), workers);
            treeA.pairs(treeB, found, workers);
            CHECK(between(truth, sorted(found)));
        }
}

TEST_CASE("broad phase: pairs with a shared vertex are left out on request", "[broadphase]") {
    Soup s = soup("", 300, 0.3, 0, 0.01, [](Random& r) { return r.point(0.5); });
    Random random(2);
    for (int& id : s.ids) id = random.below(150);
    const NoSharedVertex apart{s.ids, 3, s.ids, 3};
    Pairs expected = bruteForce<18>(s);
    const auto all = expected.size();
    std::erase_if(expected, [&](const Candidate& p) {
        for (int c = 0; c < 9; ++c)
            if (s.ids[3 * p.a + c / 3] == s.ids[3 * p.b + c % 3]) return true;
        return false;
    });
    CHECK((expected.size() > 1000 && expected.size() + 1000 < all));
    Workers workers(2);
    Candidates found;
    KDopTree<18> tree(s.count(), s.bounds<18>(), workers);
    tree.selfPairs(found, workers, apart);
    CHECK(sorted(found) == expected);
}

TEST_CASE("broad phase: the same list for any number of threads", "[broadphase][threads]") {
    const auto all = soups(4000);
    for (const Soup& s : {all[0], all[4]}) {
        Pairs lists[3];
        for (const int threads : {1, 2, 3, 8}) {
            Workers workers(threads);
            Candidates found[3];
            KDopTree<26> tree(s.count(), s.bounds<26>(), workers);
            HashGrid grid;
            grid.build(s.count(), s.bounds<6>(), workers);
            tree.selfPairs(found[0], workers);
            tree.pairs(tree, found[1], workers);
            grid.selfPairs(found[2], workers);
            for (int i = 0; i < 3; ++i) {
                const Pairs list(found[i].pairs().begin(), found[i].pairs().end());
                if (threads == 1) lists[i] = list;
                CHECK((!list.empty() && list == lists[i]));
            }
        }
    }
}

// Seen where they start and where they end, what moves alike is apart: a crowd that flies past is
// no more work than one that stands.
TEST_CASE("broad phase: bounds that move", "[broadphase]") {
    Workers workers(2);
    for (Soup s : soups(400)) {
        INFO(s.name);
        Candidates found;
        const auto pairs = [&] {
            BoundsTree<MovingKDop<14>>(s.count(), s.movingBounds<14>(), workers)
                .selfPairs(found, workers);
            return sorted(found);
        };
        CHECK(std::ranges::includes(treePairs<14>(s), pairs()));
        CHECK(std::ranges::includes(pairs(), meetings(s)));
        if (s.name != "swept") continue;
        const std::size_t slow = pairs().size();
        for (Vec<double>& x : s.end) x += {1, 0.5, 0.7};
        test::note("standing", static_cast<double>(slow));
        test::note("flying past, by ways swept", static_cast<double>(treePairs<14>(s).size()));
        test::note("flying past, by both ends", static_cast<double>(pairs().size()));
        CHECK(pairs().size() == slow);
        CHECK(std::ranges::includes(pairs(), meetings(s)));
    }
}

// S 7 found k-DOPs best: what they cost in directions they save in pairs that do not meet.
TEST_CASE("broad phase: more directions leave fewer pairs, and never one that meets",
          "[broadphase][BP2]") {
    for (const Soup& s : soups(800)) {
        const Pairs pairs[]{treePairs<6>(s), treePairs<14>(s), treePairs<18>(s), treePairs<26>(s)};
        test::note(s.name + ": pairs of boxes, a primitive", double(pairs[0].size()) / s.count());
        test::note("    of 14, 18 and 26 directions, of these",
                   double(pairs[1].size()) / double(pairs[0].size()));
        test::note("", double(pairs[2].size()) / double(pairs[0].size()));
        test::note("", double(pairs[3].size()) / double(pairs[0].size()));
        for (int i : {1, 2, 3}) CHECK(std::ranges::includes(pairs[0], pairs[i]));
        for (int i : {1, 2}) CHECK(std::ranges::includes(pairs[i], pairs[3]));
        CHECK(pairs[0].size() >= gridPairs(s).size());
    }
}
