#include "apart.h"

#include "../../numbers/lanes.h"

namespace plait {
namespace {

using Four = Pack<4>;
using Corners = std::array<Vec<Four>, 4>;

Four maximum(Four a, Four b) { return select(a > b, a, b); }
Four minimum(Four a, Four b) { return select(b > a, a, b); }
Four part(Four a) { return minimum(maximum(a, Four(0)), Four(1)); }  // 0 to 1
Four absolute(Four a) { return maximum(a, -a); }
Four along(const Vec<Four>& a) { return absolute(a.x) + absolute(a.y) + absolute(a.z); }

Corners cornersOf(const FourPairs& pairs, std::span<const Spot> of) {
    Corners x{};
    for (int i = 0; i < pairs.first + pairs.second; ++i)
        x[i] = gather<Four>(&of[0].x, pairs.vertices[i].data(), 4).xyz;
    return x;
}

// Squares of distances. r leads to what is looked at from where the edge u begins.
Four fromEdge(const Vec<Four>& r, const Vec<Four>& u) {
    const Vec<Four> d = r - part(divide(dot(r, u), dot(u, u))) * u;
    return dot(d, d);
}

// As nearest() does it. Where edges are nearly parallel rounding decides where on them it looks,
// and there it matters least: with an angle s between them, by the smaller of s and 3e-7 / s of
// their lengths.
Four edgeFromEdge(const Corners& x) {
    const Vec<Four> u = x[1] - x[0], v = x[3] - x[2], r = x[0] - x[2];
    const Four a = dot(u, u), e = dot(v, v), b = dot(u, v), c = dot(u, r), f = dot(v, r);
    const Four s = part(divide(b * f - c * e, a * e - b * b));
    const Four t = part(divide(b * s + f, e));
    return fromEdge(t * v - r, u);
}

// Over the triangle its plane, which is never too far; elsewhere the nearest side, and so where the
// triangle is too slender to have a plane.
Four pointFromTriangle(const Corners& x) {
    const Vec<Four> u = x[2] - x[1], v = x[3] - x[1], r = x[0] - x[1], n = cross(u, v);
    const Four uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ru = dot(r, u), rv = dot(r, v);
    const Four b = vv * ru - uv * rv, c = uu * rv - uv * ru, nn = dot(n, n), height = dot(r, n);
    const auto inside = (b >= Four(0)) & (c >= Four(0)) & (b + c <= uu * vv - uv * uv) &
                        (nn > Four(1e-8F) * uu * vv);
    const Four side =
        minimum(minimum(fromEdge(r, u), fromEdge(r, v)), fromEdge(x[0] - x[2], x[3] - x[2]));
    return select(inside, divide(height * height, nn), side);
}

Four squareOf(const FourPairs& pairs, const Corners& x) {
    if (pairs.first == 2) return edgeFromEdge(x);
    if (pairs.second == 3) return pointFromTriangle(x);
    if (pairs.second == 2) return fromEdge(x[0] - x[1], x[2] - x[1]);
    const Vec<Four> d = x[0] - x[1];
    return dot(d, d);
}

std::array<float, 4> lanes(Four a) { return {a.v[0], a.v[1], a.v[2], a.v[3]}; }

}  // namespace

std::array<float, 4> apartAtLeast(const FourPairs& pairs, std::span<const Spot> at) {
    const Corners x = cornersOf(pairs, at);
    Four size(0);
    for (int i : {0, pairs.first}) {
        const int last = i ? pairs.first + pairs.second : pairs.first;
        for (int k = i + 1; k < last; ++k) size = size + along(x[k] - x[i]);
    }
    const Four wrong = Four(1e-3F) * size + Four(0x1p-20F) * (along(x[0]) + along(x[pairs.first]));
    return lanes(squareRoot(squareOf(pairs, x)) - wrong);
}

std::array<float, 4> goApart(const FourPairs& pairs, std::span<const Spot> way) {
    const Corners go = cornersOf(pairs, way);
    Four most(0);
    for (int i = 0; i < pairs.first; ++i)
        for (int k = pairs.first; k < pairs.first + pairs.second; ++k) {
            const Vec<Four> d = go[i] - go[k];
            most = maximum(most, dot(d, d));
        }
    return lanes(Four(1 + 1e-6F) * squareRoot(most) + Four(1e-12F));
}

}  // namespace plait
