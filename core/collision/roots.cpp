#include "roots.h"

#include <type_traits>

namespace plait {
namespace {

using detail::larger;
using detail::magnitude;
using detail::tiny;

// A part of [0, 1] with the polynomial's coefficients on it.
template <int n, class T>
struct Part {
    T low, high;
    Bernstein<n, T> p;
};

// De Casteljau's algorithm: the value at x, and on request the coefficients on either side.
template <int n, class T>
T evaluate(const Bernstein<n, T>& p, T x, Bernstein<n, T>* left = nullptr,
           Bernstein<n, T>* right = nullptr) {
    T c[n + 1];
    for (int i = 0; i <= n; ++i) c[i] = p.c[i];
    for (int level = 1; level <= n; ++level) {
        if (left) left->c[level - 1] = c[0], right->c[n - level + 1] = c[n - level + 1];
        for (int i = 0; i <= n - level; ++i) c[i] = (1 - x) * c[i] + x * c[i + 1];
    }
    if (left) left->c[n] = right->c[0] = c[0];
    return c[0];
}

template <int n, class T>
class Isolation {
public:
    void search(const Part<n, T>& part) {
        const double error = part.p.error + tiny;
        int above = 0, below = 0, changes = 0, unsure = 0, sign = 0;
        bool flat = true;
        for (const T& c : part.p.c) {
            const int s = (c > error) - (c < -error);
            flat = flat && !(magnitude(c) > 8 * error);
            above += s > 0, below += s < 0, unsure += s == 0;
            if (s != 0) changes += sign * s < 0, sign = s;
        }
        if (above == n + 1 || below == n + 1) return;
        if (flat || !(part.high - part.low > 2 * roundoff<T>) || ++parts_ > 256) {
            found.append({part.low, part.high, false});
        } else if (changes == 1 && unsure == 0) {
            found.append(refined(part));
        } else {
            split(part);
        }
    }

    Brackets<T> found;

private:
    void split(const Part<n, T>& part) {
        const T width = part.high - part.low;
        Part<n, T> left, right;
        // A root at the middle would stay at an end of all further parts.
        for (T x = fraction(part.p);; x = 0.4375) {
            const T t = part.low + x * width;
            if (!(t > part.low && t < part.high)) {
                found.append({part.low, part.high, false});
                return;
            }
            evaluate(part.p, (t - part.low) / width, &left.p, &right.p);
            // A level: three roundings of x, which weighs differences up to twice the size, are 3
            // roundoffs of it; those of 1 - x, the products and the sum 1.5; and some to spare.
            left.p.error = right.p.error = part.p.error + 5 * n * roundoff<T> * part.p.size();
            left.low = part.low, right.high = part.high;
            left.high = right.low = t;
            if (x != 0.5 || magnitude(left.p.c[n]) > left.p.error) break;
        }
        search(left);
        search(right);
    }

    // The middle, or next to an end where the polynomial may be 0: as far from it as its slope
    // there needs to make it differ from 0.
    static T fraction(const Bernstein<n, T>& p) {
        const double error = p.error + tiny;
        const auto near = [&](const T& end, const T& next) -> T {
            return 2 * (magnitude(end) + error) / (n * (magnitude(next) + error));
        };
        if (magnitude(p.c[0]) <= error) {
            const T x = near(p.c[0], p.c[1]);
            if (x < 0.5) return x;
        }
        if (magnitude(p.c[n]) <= error) {
            const T x = near(p.c[n], p.c[n - 1]);
            if (x < 0.5) return 1 - x;
        }
        return 0.5;
    }

    // The one root of a part whose ends have opposite signs: regula falsi with a bisection now and
    // then, until rounding hides the sign; then out again to either side until it shows.
    static Bracket<T> refined(const Part<n, T>& part) {
        const Bernstein<n, T>& p = part.p;
        const double error = p.error + 2 * n * roundoff<T> * p.size() + tiny;
        const T width = part.high - part.low;
        T a = 0, b = 1, atA = p.c[0], atB = p.c[n];
        const bool rises = atA < 0;
        T weighedA = atA, weighedB = atB;
        for (int i = 0; i < 100 && (b - a) * width > roundoff<T>; ++i) {
            T x = i % 4 == 3 ? 0.5 * (a + b) : a + (b - a) * (weighedA / (weighedA - weighedB));
            if (!(x > a && x < b)) x = 0.5 * (a + b);
            const T v = evaluate(p, x);
            if (!(magnitude(v) > error)) {
                const T step = 2 * error * (b - a) / magnitude(atB - atA);
                widen(p, x, larger(step, T(0.5 * roundoff<T>)), error, rises, a, b);
                break;
            }
            // Illinois: an end that stays twice counts half.
            if ((v < 0) == rises) {
                a = x, atA = weighedA = v, weighedB = 0.5 * weighedB;
            } else {
                b = x, atB = weighedB = v, weighedA = 0.5 * weighedA;
            }
        }
        // Four roundings to t, each at most a quarter of a roundoff.
        const T low = part.low + a * width - roundoff<T>;
        const T high = part.low + b * width + roundoff<T>;
        return {larger(low, part.low), high < part.high ? high : part.high, true};
    }

    // Moves a up and b down towards x as far as the sign shows.
    static void widen(const Bernstein<n, T>& p, const T& x, const T& step, double error, bool rises,
                      T& a, T& b) {
        const double up = rises ? 1 : -1;
        for (T d = step; x - d > a; d = 2 * d) {
            if (up * evaluate(p, x - d) < -error) {
                a = x - d;
                break;
            }
        }
        for (T d = step; x + d < b; d = 2 * d) {
            if (up * evaluate(p, x + d) > error) {
                b = x + d;
                break;
            }
        }
    }

    int parts_ = 0;
};

template <int n, class T>
Brackets<T> isolate(const Bernstein<n, T>& p) {
    Isolation<n, T> isolation;
    isolation.search({0, 1, p});
    return isolation.found;
}

// What is promised where the polynomial is exact.
bool narrow(const Bracket<double>& b) { return b.high - b.low <= 0x1p-40; }

// The same polynomial, and the brackets rounded outwards.
template <int n>
Brackets<double> isolateInTwiceTheDigits(const Bernstein<n>& p) {
    Bernstein<n, DoubleDouble> fine;
    for (int i = 0; i <= n; ++i) fine.c[i] = p.c[i];
    fine.error = p.error;
    Brackets<double> brackets;
    for (const auto& [low, high, simple] : isolate(fine)) {
        const double ulp = roundoff<double>;
        Bracket<double> b{low.low < 0 ? low.high * (1 - ulp) : low.high,
                          high.low > 0 ? high.high * (1 + ulp) : high.high, simple};
        b.simple = simple && narrow(b);
        brackets.append(b);
    }
    return brackets;
}

}  // namespace

template <int n, class T>
Brackets<T> isolateRoots(const Bernstein<n, T>& p) {
    const Brackets<T> found = isolate(p);
    if constexpr (std::is_same_v<T, double>) {
        // Where the polynomial is known better than double can work with it.
        bool settled = true;
        for (const Bracket<T>& b : found) settled = settled && b.simple && narrow(b);
        if (!settled && p.error < 0.25 * roundoff<double> * p.size())
            return isolateInTwiceTheDigits(p);
    }
    return found;
}

template Brackets<double> isolateRoots(const Bernstein<1>&);
template Brackets<double> isolateRoots(const Bernstein<2>&);
template Brackets<double> isolateRoots(const Bernstein<3>&);
template Brackets<double> isolateRoots(const Bernstein<4>&);
template Brackets<double> isolateRoots(const Bernstein<5>&);
template Brackets<double> isolateRoots(const Bernstein<6>&);
template Brackets<DoubleDouble> isolateRoots(const Bernstein<2, DoubleDouble>&);
template Brackets<DoubleDouble> isolateRoots(const Bernstein<3, DoubleDouble>&);

}  // namespace plait
