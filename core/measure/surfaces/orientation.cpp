#include "orientation.h"

#include <array>
#include <cmath>

#include "../../numbers/exact.h"

namespace plait {
namespace {

// A sum of doubles without rounding: terms that do not overlap, the least first (Shewchuk 1997,
// figure 6, GROW-EXPANSION). Zeros are dropped, so the sign is that of the last term.
class Expansion {
public:
    void add(double b) {
        int kept = 0;
        for (int i = 0; i < size_; ++i) {
            const Twofold s = exactSum(b, term_[i]);
            if (s.low != 0) term_[kept++] = s.low;
            b = s.high;
        }
        if (b != 0) term_[kept++] = b;
        size_ = kept;
    }
    int sign() const { return size_ ? signOf(term_[size_ - 1]) : 0; }

private:
    // 6 products of three differences of two terms each, of four doubles each.
    std::array<double, 6 * 8 * 4> term_;
    int size_ = 0;
};

using Difference = std::array<double, 2>;

Difference difference(double a, double b) {
    const Twofold d = exactSum(a, -b);
    return {d.high, d.low};
}

// Adds sign a b c.
void addProduct(Expansion& sum, double sign, const Difference& a, const Difference& b,
                const Difference& c) {
    for (const double p : a) {
        for (const double q : b) {
            for (const double r : c) {
                if (p == 0 || q == 0 || r == 0) continue;
                const Twofold pq = exactProduct(sign * p, q);
                const Twofold high = exactProduct(pq.high, r), low = exactProduct(pq.low, r);
                for (const double term : {low.low, low.high, high.low, high.high}) sum.add(term);
            }
        }
    }
}

int exactOrientation(const Vec<double>& a, const Vec<double>& b, const Vec<double>& c,
                     const Vec<double>& d) {
    using Row = std::array<Difference, 3>;
    const auto relative = [&](const Vec<double>& p) -> Row {
        return {difference(p.x, d.x), difference(p.y, d.y), difference(p.z, d.z)};
    };
    const Row u = relative(a), v = relative(b), w = relative(c);
    Expansion sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        addProduct(sum, 1, u[i], v[j], w[k]);
        addProduct(sum, -1, u[i], v[k], w[j]);
    }
    return sum.sign();
}

}  // namespace

int orientation(const Vec<double>& a, const Vec<double>& b, const Vec<double>& c,
                const Vec<double>& d) {
    const Vec<double> u = a - d, v = b - d, w = c - d;
    const double determinant = dot(u, cross(v, w));
    const auto absolute = [](double p, double q) { return std::abs(p) + std::abs(q); };
    const double permanent = std::abs(u.x) * absolute(v.y * w.z, v.z * w.y) +
                             std::abs(u.y) * absolute(v.z * w.x, v.x * w.z) +
                             std::abs(u.z) * absolute(v.x * w.y, v.y * w.x);
    // Shewchuk's bound A for this determinant: (7 + 56 e) e with e = 2^-53, rounded up.
    if (std::abs(determinant) > 0x1.c000000000008p-51 * permanent) return signOf(determinant);
    return exactOrientation(a, b, c, d);
}

}  // namespace plait
