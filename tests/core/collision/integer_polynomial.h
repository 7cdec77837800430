// Polynomials with integer coefficients: where they are 0, and what sign others have there, without
// any rounding (Sturm's theorem). The oracle of roots and of queries.
#pragma once

#if __has_include(<gmpxx.h>) && !defined(PLAIT_WITHOUT_GMP)
#define PLAIT_GMP
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace plait::test {

// The least power first, no zero last; nothing is the polynomial 0. Only roots and signs matter, so
// that every operation may bring in a positive factor.
using Integer = mpz_class;
using Rational = mpq_class;
using Polynomial = std::vector<Integer>;

// The numbers times the power of two that makes all of them integers.
inline std::vector<Integer> integers(const std::vector<double>& numbers) {
    const auto exponent = [](double a) { return std::ilogb(a) - 52; };
    int least = 1024;
    for (const double a : numbers)
        if (a != 0) least = std::min(least, exponent(a));
    std::vector<Integer> scaled;
    for (const double a : numbers) {
        const int e = a != 0 ? exponent(a) : least;
        scaled.push_back(Integer(std::ldexp(a, -e)) << static_cast<unsigned>(e - least));
    }
    return scaled;
}

inline Polynomial trimmed(Polynomial p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
    return p;
}

inline Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    Polynomial sum(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < a.size(); ++i) sum[i] += a[i];
    for (std::size_t i = 0; i < b.size(); ++i) sum[i] += b[i];
    return trimmed(sum);
}

inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    if (a.empty() || b.empty()) return {};
    Polynomial product(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
    }
    return product;
}

inline Polynomial operator-(Polynomial a) {
    for (Integer& c : a) c = -c;
    return a;
}
inline Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }

// Times the denominator of t to the power of the degree.
inline Integer value(const Polynomial& p, const Rational& t) {
    Integer v = 0, power = 1;
    for (std::size_t i = p.size(); i-- > 0; power *= t.get_den())
        v = v * t.get_num() + p[i] * power;
    return v;
}
inline int sign(const Polynomial& p, const Rational& t) { return sgn(value(p, t)); }

inline Polynomial derivative(const Polynomial& p) {
    Polynomial d;
    for (std::size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * static_cast<long>(i));
    return d;
}

struct Division {
    Polynomial quotient, remainder;
};

// Of a positive multiple of a.
inline Division divided(Polynomial a, const Polynomial& b) {
    Polynomial q(a.size() < b.size() ? 0 : a.size() - b.size() + 1);
    const Integer factor = abs(b.back());
    while (a.size() >= b.size()) {
        const std::size_t shift = a.size() - b.size();
        const Integer top = sgn(b.back()) * a.back();
        for (Integer& c : q) c *= factor;
        for (Integer& c : a) c *= factor;
        q[shift] = top;
        for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= top * b[i];
        a = trimmed(a);
    }
    return {q, a};
}

// Without a common factor, so that numbers stay short.
inline Polynomial shortened(Polynomial p) {
    Integer common = 0;
    for (const Integer& c : p) common = gcd(common, c);
    for (Integer& c : p) c /= common;
    return p;
}

inline Polynomial commonDivisor(Polynomial a, Polynomial b) {
    while (!b.empty()) {
        Polynomial r = shortened(divided(a, b).remainder);
        a = b;
        b = r;
    }
    return a;
}

// The same roots, each once.
inline Polynomial withoutMultiples(const Polynomial& p) {
    const Polynomial d = commonDivisor(p, derivative(p));
    return d.size() > 1 ? shortened(divided(p, d).quotient) : p;
}

// Counts roots, by the changes of sign in Sturm's chain.
class Sturm {
public:
    // p has no multiple roots and is not 0.
    explicit Sturm(const Polynomial& p) : chain_{p, derivative(p)} {
        while (!chain_.back().empty()) {
            const auto& last = chain_.back();
            chain_.push_back(shortened(-divided(chain_[chain_.size() - 2], last).remainder));
        }
        chain_.pop_back();
    }
    // Less by one with every root, at the root itself already.
    int changes(const Rational& t) const {
        int n = 0, last = 0;
        for (const Polynomial& p : chain_) {
            const int s = sign(p, t);
            if (s != 0 && s * last < 0) ++n;
            if (s != 0) last = s;
        }
        return n;
    }
    // In [low, high].
    int count(const Rational& low, const Rational& high) const {
        return changes(low) - changes(high) + (sign(chain_[0], low) == 0);
    }

private:
    std::vector<Polynomial> chain_;
};

// The one root in (low, high] of a polynomial without multiple ones; low = high if that is it.
class Root {
public:
    Root(const Polynomial& p, const Rational& begin, const Rational& end)
        : low(begin), high(end), p_(&p), signHigh_(test::sign(p, end)) {
        if (signHigh_ == 0) low = high;
    }

    Rational low, high;

    // Keeps the side of t on which the root is.
    void cut(const Rational& t) {
        if (t <= low || t >= high) return;
        const int s = test::sign(*p_, t);
        if (s == 0 || s == signHigh_) high = t;
        if (s != signHigh_) low = t;
    }
    void halve() { cut((low + high) / 2); }

    // The sign of q at the root.
    int sign(const Polynomial& q) {
        if (q.empty()) return 0;
        // Mostly its slope is enough.
        Integer slope = 0;
        for (std::size_t i = 1; i < q.size(); ++i) slope += abs(q[i]) * static_cast<long>(i);
        for (int i = 0; i < 12; ++i) {
            Integer most = slope * Rational(high - low).get_num();
            for (std::size_t k = 1; k < q.size(); ++k) most *= high.get_den();
            const Integer v = value(q, high);
            if (abs(v) * Rational(high - low).get_den() > most) return sgn(v);
            for (int k = 0; k < 3; ++k) halve();
        }
        const Polynomial common = commonDivisor(*p_, q);
        if (common.size() > 1 && Sturm(common).count(low, high) > 0) return 0;
        const Sturm sturm(withoutMultiples(q));
        while (low < high && sturm.count(low, high) > 0) halve();
        return test::sign(q, high);
    }

private:
    const Polynomial* p_;
    int signHigh_;
};

// True if the Bernstein coefficients show that there is no root in [0, 1].
inline bool rootless(const Polynomial& p) {
    const long n = static_cast<long>(p.size()) - 1;
    long all = 1;
    for (long i = 2; i <= n; ++i) all *= i;
    int above = 0, below = 0;
    for (long i = 0; i <= n; ++i) {
        Integer b = 0;
        long weight = all;  // n! (i choose k) / (n choose k)
        for (long k = 0; k <= i; ++k) {
            b += weight * p[static_cast<std::size_t>(k)];
            if (k < i) weight = weight / (n - k) * (i - k);
        }
        above += b > 0, below += b < 0;
    }
    return above == n + 1 || below == n + 1;
}

// The roots in [0, 1], in order; p has no multiple ones, is not 0 and must live as long as they.
inline std::vector<Root> rootsOf(const Polynomial& p) {
    std::vector<Root> roots;
    if (sign(p, 0) == 0) roots.emplace_back(p, 0, 0);
    const Sturm sturm(p);
    struct Part {
        Rational low, high;
        int changesLow, changesHigh;
    };
    std::vector<Part> open{{0, 1, sturm.changes(0), sturm.changes(1)}};
    while (!open.empty()) {
        const Part part = open.back();
        open.pop_back();
        const int n = part.changesLow - part.changesHigh;
        if (n == 1) roots.emplace_back(p, part.low, part.high);
        if (n > 1) {
            const Rational middle = (part.low + part.high) / 2;
            const int changes = sturm.changes(middle);
            open.push_back({middle, part.high, changes, part.changesHigh});
            open.push_back({part.low, middle, part.changesLow, changes});
        }
    }
    return roots;
}

}  // namespace plait::test
#endif
