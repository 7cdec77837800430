// The ballerina: one closed surface that keeps its shape, feet that stay where they stand, weight
// that is carried or falls.
#include "scenes/ballerina/ballerina.h"

#include "tests/catch.h"
#include "tests/report.h"

#include <plait/measure/surfaces/intersections.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace plait;
using plait::test::note;
using plait::test::report;

namespace {

using Point = Vec<double>;
using Triangle = std::array<int, 3>;

const Point& at(const std::vector<Point>& x, int i) { return x[static_cast<std::size_t>(i)]; }

double volume(const std::vector<Point>& x, const std::vector<Triangle>& triangles) {
    double sum = 0;
    for (const auto& [a, b, c] : triangles) sum += dot(at(x, a), cross(at(x, b), at(x, c))) / 6;
    return sum;
}

// Of what the surface encloses.
Point centroid(const std::vector<Point>& x, const std::vector<Triangle>& triangles) {
    Point sum{0, 0, 0};
    for (const auto& [a, b, c] : triangles)
        sum += dot(at(x, a), cross(at(x, b), at(x, c))) * (at(x, a) + at(x, b) + at(x, c));
    return (1 / (24 * volume(x, triangles))) * sum;
}

double lowest(const std::vector<Point>& x) {
    return std::min_element(x.begin(), x.end(),
                            [](const Point& a, const Point& b) { return a.y < b.y; })
        ->y;
}

double flat(const Point& d) { return std::hypot(d.x, d.z); }

// Where a plane cuts the skin: points on its edges, the same in every pose.
struct Section {
    struct Cut {
        int from, to;
        double part;
        Point of(const std::vector<Point>& x) const {
            return at(x, from) + part * (at(x, to) - at(x, from));
        }
    };
    std::vector<std::array<Cut, 2>> segments;

    double area(const std::vector<Point>& x) const {
        const Point center = segments.front()[0].of(x);
        Point sum{0, 0, 0};
        for (const auto& [a, b] : segments) sum += cross(a.of(x) - center, b.of(x) - center);
        return length(sum) / 2;
    }
};

// Across `axis` through `p`, near it.
Section sectionOf(const Ballerina& dancer, const Point& p, const Point& axis, double radius) {
    const std::vector<Point>& x = dancer.shape().positions;
    Section section;
    for (const Triangle& t : dancer.triangles()) {
        std::vector<Section::Cut> cuts;
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            const double da = dot(at(x, a) - p, axis), db = dot(at(x, b) - p, axis);
            if ((da < 0) == (db < 0) || length(at(x, a) - p) > radius) continue;
            cuts.push_back({a, b, da / (da - db)});
            if (da < 0 && cuts.size() == 2) std::swap(cuts[0], cuts[1]);
        }
        if (cuts.size() == 2) section.segments.push_back({cuts[0], cuts[1]});
    }
    return section;
}

}  // namespace

TEST_CASE("The ballerina's skin is one closed surface that looks outward", "[ballerina][figures]") {
    const Ballerina dancer;
    const std::vector<Triangle>& triangles = dancer.triangles();
    const int vertices = static_cast<int>(dancer.shape().positions.size());
    CHECK(vertices >= 6000);
    CHECK(vertices <= 12000);
    CHECK(dancer.parts().size() == dancer.shape().positions.size());

    std::set<std::array<int, 2>> edges;
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) CHECK(edges.insert({t[k], t[(k + 1) % 3]}).second);
    int open = 0;
    for (const auto& [a, b] : edges) open += !edges.contains({b, a});
    CHECK(open == 0);
    const int faces = static_cast<int>(triangles.size());
    CHECK(vertices - static_cast<int>(edges.size()) / 2 + faces == 2);

    // With one component, that is a sphere.
    std::vector<int> group(static_cast<std::size_t>(vertices));
    for (int i = 0; i < vertices; ++i) group[static_cast<std::size_t>(i)] = i;
    const auto rootOf = [&](int i) {
        while (group[static_cast<std::size_t>(i)] != i) i = group[static_cast<std::size_t>(i)];
        return i;
    };
    for (const auto& [a, b] : edges) group[static_cast<std::size_t>(rootOf(a))] = rootOf(b);
    std::set<int> roots;
    for (int i = 0; i < vertices; ++i) roots.insert(rootOf(i));
    CHECK(roots.size() == 1);
    note("litres", 1000 * volume(dancer.shape().positions, triangles));
    CHECK(volume(dancer.shape().positions, triangles) > 0.03);
}

TEST_CASE("The ballerina never passes through herself and keeps her volume",
          "[ballerina][figures]") {
    const Ballerina dancer;
    const double whole = volume(dancer.positions(0), dancer.triangles());
    int intersections = 0;
    double change = 0, under = 0;
    for (double t = 0; t < Ballerina::seconds; t += 0.2) {
        const std::vector<Point> x = dancer.positions(t);
        intersections += countIntersections(x, dancer.triangles());
        change = std::max(change, std::abs(volume(x, dancer.triangles()) / whole - 1));
        under = std::max(under, -lowest(x));
    }
    CHECK(intersections == 0);
    CHECK(report("change of volume, parts of it", change, 0.04));
    CHECK(report("under the floor, m", under, 0.002));
}

TEST_CASE("The ballerina's limbs keep their sections", "[ballerina][figures]") {
    const Ballerina dancer;
    // At rest: along the left leg and arm.
    const Point hip{0.085, 0.905, 0}, down{0.1050, -0.9945, 0};
    const Point shoulder{0.150, 1.372, -0.012}, out{0.9700, -0.2430, 0};
    std::vector<Section> sections;
    for (double s = 0.24; s < 0.80; s += 0.04)
        sections.push_back(sectionOf(dancer, hip + s * down, down, 0.12));
    for (double s = 0.10; s < 0.50; s += 0.04)
        sections.push_back(sectionOf(dancer, shoulder + s * out, out, 0.08));
    double least = 1, most = 1;
    for (double t = 0; t < Ballerina::seconds; t += 0.05) {
        const std::vector<Point> x = dancer.positions(t);
        for (const Section& section : sections) {
            const double area = section.area(x) / section.area(dancer.shape().positions);
            least = std::min(least, area);
            most = std::max(most, area);
        }
    }
    // A section is bent over an arc at a knee, but nowhere is it wrung.
    CHECK(report("least area of a section, parts lost", 1 - least, 0.10));
    CHECK(report("greatest area of a section, parts gained", most - 1, 0.10));
}

TEST_CASE("The ballerina moves without jerks", "[ballerina][figures]") {
    const Ballerina dancer;
    // All keys are at whole hundredths: a jump of velocity v there would show as v / h.
    constexpr double h = 1e-4;
    double greatest = 0, speed = 0;
    for (int i = -1; i <= 100 * Ballerina::seconds + 1; ++i) {
        const double t = 0.01 * i;
        const std::vector<Point> a = dancer.positions(t - h), b = dancer.positions(t),
                                 c = dancer.positions(t + h);
        for (std::size_t v = 0; v < b.size(); v += 7) {
            greatest = std::max(greatest, length(a[v] - 2.0 * b[v] + c[v]) / (h * h));
            speed = std::max(speed, length(c[v] - a[v]) / (2 * h));
        }
    }
    note("greatest speed, m/s", speed);
    CHECK(report("greatest acceleration, m/s^2", greatest, 400));
}

TEST_CASE("The ballerina's feet stay where they stand", "[ballerina][figures]") {
    const Ballerina dancer;
    const std::vector<Point>& rest = dancer.shape().positions;
    double slid = 0, off = 0;
    for (std::size_t side = 0; side < 2; ++side) {
        std::vector<std::size_t> shoe;
        for (std::size_t v = 0; v < rest.size(); ++v)
            if (dancer.parts()[v] == BodyPart::shoe && (rest[v].x > 0) == (side == 0))
                shoe.push_back(v);
        std::vector<Point> stood;  // when the sole, or the tip, came down
        Ballerina::Foot before{};
        int frames = 0;
        for (double t = 0; t < Ballerina::seconds; t += 0.01) {
            const Ballerina::Foot foot = dancer.feet(t)[side];
            const bool settled =
                foot.planted == 1 && foot.tip.y == 0 && (foot.rise == 0 || foot.rise == 1);
            if (!settled || foot.rise != before.rise || !(foot.tip == before.tip)) stood.clear();
            before = foot;
            if (!settled) continue;
            const std::vector<Point> x = dancer.positions(t);
            if (stood.empty()) stood = x;
            ++frames;
            for (const std::size_t v : shoe) {
                if (stood[v].y > 0.004) continue;
                if (foot.rise == 0) slid = std::max(slid, flat(x[v] - stood[v]));
                // A tip may turn where it stands.
                off = std::max(off, std::abs(flat(x[v] - foot.tip) - flat(stood[v] - foot.tip)));
            }
        }
        CHECK(frames > 200);
    }
    CHECK(report("a sole slides, m", slid, 0.001));
    CHECK(report("a tip turns off the point that it stands on, m", off, 0.001));
}

TEST_CASE("The ballerina's weight is carried, or falls", "[ballerina][figures]") {
    const Ballerina dancer;
    constexpr double h = 1e-3, gravity = 9.81;
    double apart = 0, closest = 1;
    for (double t = Ballerina::takeOff + 2 * h; t < Ballerina::landing - h; t += 0.01) {
        const Point a = (1 / (h * h)) * (dancer.centerOfMass(t + h) + dancer.centerOfMass(t - h) -
                                         2.0 * dancer.centerOfMass(t));
        apart = std::max(apart, length(a + Point{0, gravity, 0}));
        if (t > Ballerina::takeOff + 0.02 && t < Ballerina::landing - 0.03)
            closest = std::min(closest, lowest(dancer.positions(t)));
    }
    CHECK(report("in the leap, off free fall, m/s^2", apart, 1e-3));
    CHECK(closest > 0);

    // Feet push but do not pull.
    double pulled = 0;
    for (double t = 0; t < Ballerina::seconds; t += 0.01)
        pulled = std::max(pulled,
                          -gravity - (dancer.centerOfMass(t + h).y + dancer.centerOfMass(t - h).y -
                                      2 * dancer.centerOfMass(t).y) /
                                         (h * h));
    CHECK(report("pulled down faster than by gravity, m/s^2", pulled, 0.5));

    // On one tip, by masses of the parts; of the whole as if it were of one density.
    double off = 0, middle = 0;
    for (double t = 4.2; t < 8.5; t += 0.05) {
        const Ballerina::Foot foot = dancer.feet(t)[0];
        if (foot.rise != 1) continue;
        off = std::max(off, flat(dancer.centerOfMass(t) - foot.tip));
        middle =
            std::max(middle, flat(centroid(dancer.positions(t), dancer.triangles()) - foot.tip));
    }
    CHECK(report("centre of mass beside the tip, m", off, 0.002));
    CHECK(report("middle of the body beside the tip, m", middle, 0.04));
}

TEST_CASE("The ballerina dances the same every time", "[ballerina]") {
    const Ballerina one, two;
    for (const double t : {0.0, 2.5, 5.2, 10.4, 20.0}) CHECK(one.positions(t) == two.positions(t));
    CHECK(one.positions(-1) == one.positions(0));
}
