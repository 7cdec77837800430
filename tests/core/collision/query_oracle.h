// When two moving simplices touch, in integer arithmetic: the oracle of collision queries.
#pragma once

#include "integer_polynomial.h"

#include <plait/collision/query.h>

#ifdef PLAIT_GMP
#include <algorithm>
#include <array>

namespace plait::test {

// What may touch: a face, an edge or a corner of the difference of two simplices. It is as near as
// the bound where `distance` is 0, `size` is not, and the point of the origin's foot is on it, so
// that no `inside` is below 0.
struct Feature {
    Polynomial distance, size;
    std::vector<Polynomial> inside;
};

using ExactVector = std::array<Polynomial, 3>;

inline Polynomial dot(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline ExactVector cross(const ExactVector& a, const ExactVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The polygon of all differences, as core/collision/difference.h has it, from vertices: a and b; p
// and a, b; p and a, b, c; a, b and c, d. With the thickness, in a unit that makes all whole.
class ExactPolygon {
public:
    ExactPolygon(const std::vector<MovingVertex>& v, bool edges, double thickness) {
        std::vector<double> numbers{thickness};
        for (const MovingVertex& m : v)
            for (const Vec<double>& x : {m.start, m.end})
                numbers.insert(numbers.end(), {x.x, x.y, x.z});
        const std::vector<Integer> whole = integers(numbers);
        square_ = Polynomial{whole[0] * whole[0]};
        const auto difference = [&](int from, int to) {
            ExactVector d;
            for (int axis = 0; axis < 3; ++axis) {
                const Integer *a = &whole[1 + 6 * from + axis], *b = &whole[1 + 6 * to + axis];
                d[axis] = trimmed({b[0] - a[0], b[3] - b[0] - a[3] + a[0]});
            }
            return d;
        };
        const std::vector<std::array<int, 2>> pairs =
            edges ? std::vector<std::array<int, 2>>{{0, 2}, {0, 3}, {1, 3}, {1, 2}}
                  : std::vector<std::array<int, 2>>{{0, 1}, {0, 2}, {0, 3}};
        const int k = edges ? 4 : static_cast<int>(v.size()) - 1;
        for (int i = 0; i < k; ++i) corner_.push_back(difference(pairs[i][0], pairs[i][1]));
        for (int i = 0; k > 1 && i < (k == 2 ? 1 : k); ++i) {
            ExactVector e = corner_[(i + 1) % k];
            for (int j = 0; j < 3; ++j) e[j] = e[j] - corner_[i][j];
            side_.push_back(e);
        }
    }

    // In three dimensions.
    Feature face() const {
        const ExactVector n = cross(side_[0], side_[1]);
        Feature f{dot(corner_[0], n), dot(n, n), {}};
        for (std::size_t i = 0; i < side_.size(); ++i)
            f.inside.push_back(dot(n, cross(corner_[i], side_[i])));
        return f;
    }
    // In the plane of x and y.
    Feature edge(std::size_t i) const {
        const Polynomial along = dot(corner_[i], side_[i]), size = dot(side_[i], side_[i]);
        return {cross(corner_[i], side_[i])[2], size, {-along, size + along}};
    }
    // All of them, with squares of distances.
    std::vector<Feature> thick() const {
        std::vector<Feature> features;
        for (const ExactVector& v : corner_) features.push_back({dot(v, v) - square_, {1}, {}});
        for (std::size_t i = 0; i < side_.size(); ++i) {
            Feature f = edge(i);
            const ExactVector moment = cross(corner_[i], side_[i]);
            f.distance = dot(moment, moment) - square_ * f.size;
            features.push_back(f);
        }
        if (side_.size() > 1) {
            Feature f = face();
            f.distance = f.distance * f.distance - square_ * f.size;
            features.push_back(f);
        }
        return features;
    }

private:
    std::vector<ExactVector> corner_, side_;
    Polynomial square_;  // of the thickness
};

struct Score {
    int cases = 0, touching = 0, degenerate = 0, missed = 0, late = 0, invented = 0;
    double early = 0;  // the most, where it touches
};

// Holds an answer to the first time any feature is near. A thick one that has no size then or is
// always near may be left out, since its own corners and edges are as near; with a thin one false
// is returned, and nothing counted.
inline bool hold(const std::vector<Feature>& features, bool thin, const Impact& impact,
                 Score& score) {
    bool touches = false, late = false;
    double early = 2;
    const Rational told = impact.value_or(0), expected = told + Rational(score.early);
    for (const Feature& f : features) {
        const auto outside = [](const Polynomial& p) { return sign(p, 0) < 0; };
        if (!thin && sign(f.size, 0) > 0 && sign(f.distance, 0) <= 0 &&
            std::none_of(f.inside.begin(), f.inside.end(), outside)) {
            touches = true, early = 0;
            late = late || told > 0;
        }
        if (f.distance.empty()) {
            if (thin) return false;
            continue;
        }
        if (rootless(f.distance)) continue;
        const Polynomial p = withoutMultiples(f.distance);
        for (Root& root : rootsOf(p)) {
            if (root.sign(f.size) == 0) {
                if (thin) return false;
                continue;
            }
            const auto without = [&](const Polynomial& q) { return root.sign(q) < 0; };
            if (std::any_of(f.inside.begin(), f.inside.end(), without)) continue;
            touches = true;
            root.cut(told);
            late = late || (root.low < told && root.high <= told);
            root.cut(expected);
            while (root.high > expected && root.high - root.low > 0x1p-70) root.halve();
            early = std::min(early, Rational(root.high - told).get_d());
            break;
        }
    }
    ++score.cases;
    score.touching += touches;
    score.missed += touches && !impact;
    score.invented += !touches && impact;
    score.late += impact && late;
    if (touches && impact) score.early = std::max(score.early, early);
    return true;
}

// The same of a thin polygon: by its one feature, or where that has no size by all of them.
inline void holdThin(const ExactPolygon& polygon, const Feature& only, const Impact& impact,
                     Score& score) {
    if (hold({only}, true, impact, score)) return;
    ++score.degenerate;
    hold(polygon.thick(), false, impact, score);
}

}  // namespace plait::test
#endif
