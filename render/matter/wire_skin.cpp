#include "wire_skin.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace plait {
namespace {

constexpr float leastPixels = 1.5f;
// Where no groove is seen wires are wider by this part: nothing shines through seams.
constexpr float seam = 0.06f;
constexpr float groove = 0.85f;  // depth of the darkness between turns

float smooth(float x, float low, float high) {
    const float s = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return s * s * (3 - 2 * s);
}

// Form factor between two strips that face each other, as wide as each other and infinitely long,
// `gap` of their widths apart (Hottel's crossed strings): the part of the light of all around that
// one hides from the other.
float stripFactor(float gap) { return std::sqrt(1 + gap * gap) - gap; }

float lengthOf(std::span<const glm::vec3> points, bool closed) {
    float sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += glm::length(points[i] - points[i - 1]);
    return closed ? sum + glm::length(points[0] - points.back()) : sum;
}

// Part of the light that a turn beside takes from a surface of normal n. Grooves finer than pixels
// would flicker: without relief their mean is shown, 1/6 of a half round that touches the turn.
float lost(const glm::vec3& n, const glm::vec3& hidden, float relief) {
    const float all = glm::dot(hidden, hidden), part = std::max(glm::dot(n, hidden), 0.0f);
    return glm::mix(all / 6 + part * part * 5 / 6, part * part, relief);
}

// Across the wire, and across the view.
glm::vec3 sideOf(const WirePoint& p, const Lens& lens) {
    const glm::vec3 side = glm::cross(p.tangent, p.place - lens.eye);
    const float l = glm::length(side);
    return l > 1e-9f ? side / l : p.director;
}

// m, that a wire is drawn wide.
float leastWidth(const WirePoint& p, const Lens& lens) {
    return leastPixels * lens.pixel * std::max(glm::dot(p.place - lens.eye, lens.forward), 0.0f);
}

std::vector<glm::vec3> picked(std::span<const glm::vec3> all, const std::vector<int>& which) {
    std::vector<glm::vec3> result;
    for (const int i : which) result.push_back(all[i]);
    return result;
}

}  // namespace

WireSkin::WireSkin(const Look& look, std::vector<Polyline> curves, std::span<const glm::vec3> rest,
                   float pixel)
    : section_(look.section), curves_(std::move(curves)) {
    if (!(section_.along > 0) || section_.across < 0 || section_.bevel < 0 || section_.bevel > 1)
        throw std::invalid_argument("look: a wire's section is out of range");
    if (curves_.empty()) throw std::invalid_argument("look: a wire needs a curve");
    int links = 0;
    float length = 0;
    for (const Polyline& curve : curves_) {
        const auto n = static_cast<int>(curve.vertices.size());
        links += curve.closed ? n : n - 1;
        length += lengthOf(picked(rest, curve.vertices), curve.closed);
    }
    if (const int n = look.directors.size(); n > 0 && (curves_.size() > 1 || n != links))
        throw std::invalid_argument("look: a wire with directors is one curve, with one an edge");
    outline_ = outlineOf(section_, thinner() / pixel);
    const float linkPixels = length / (static_cast<float>(links) * pixel);
    steps_ = linkPixels < 24 ? 2 : linkPixels < 80 ? 4 : 8;
    int first = 0;
    for (const Polyline& curve : curves_) {
        const int n = static_cast<int>(curve.vertices.size()),
                  rings = curve.closed ? n * steps_ : (n - 1) * steps_ + 1,
                  corners = static_cast<int>(outline_.size());
        appendWireTriangles(first, rings, corners, curve.closed, triangles_);
        first += (rings + (curve.closed ? 0 : 2)) * corners;
    }
}

void WireSkin::update(std::span<const glm::vec3> points, std::span<const glm::vec3> directors,
                      std::span<const glm::vec3> tints, const Lens& lens,
                      std::vector<MeshVertex>& vertices) {
    placeStrands(points, directors);
    const auto a = static_cast<float>(section_.along), b = static_cast<float>(section_.across);
    const std::vector<Beside> near = besides(stations_, 2 * std::max(a, b));
    // A quarter of a convex outline is its mean shadow; of a circle, but for pi / 4.
    const std::vector<Openness> open = opennessOf(stations_, b > 0 ? 0.5f * (a + b) : 0.785f * a);
    surroundings_.clear();
    for (const Strand& strand : strands_)
        for (int i = 0; i < strand.stations; ++i) {
            const int station = strand.firstStation + i;
            surroundings_.push_back(about(near[station], open[station], pathAt(strand, i), lens));
        }
    faint_ = false;
    for (std::size_t i = 0; i < strands_.size(); ++i) {
        const std::size_t first = vertices.size();
        look(strands_[i], curves_[i], tints, lens);
        appendWireVertices(strands_[i].path, strands_[i].looks, outline_, strands_[i].closed,
                           vertices);
        shade(strands_[i], lens, std::span(vertices).subspan(first));
    }
}

void WireSkin::placeStrands(std::span<const glm::vec3> points,
                            std::span<const glm::vec3> directors) {
    strands_.clear();
    stations_.clear();
    for (const Polyline& curve : curves_) {
        const std::vector<glm::vec3> p = picked(points, curve.vertices);
        std::vector<glm::vec3> arms;
        for (std::size_t e = 0; e < directors.size(); ++e)
            arms.push_back(directors[e] - 0.5f * (p[e] + p[(e + 1) % p.size()]));
        Strand strand{.path = wirePath(p, arms, curve.closed, steps_),
                      .looks = {},
                      .firstStation = static_cast<int>(stations_.size()),
                      .stations = static_cast<int>(p.size()),
                      .closed = curve.closed};
        const float round = curve.closed ? lengthOf(p, true) : 0;
        float length = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (i > 0) length += glm::length(p[i] - p[i - 1]);
            stations_.push_back({.place = p[i],
                                 .tangent = pathAt(strand, static_cast<int>(i)).tangent,
                                 .director = pathAt(strand, static_cast<int>(i)).director,
                                 .length = length,
                                 .round = round,
                                 .wire = static_cast<int>(strands_.size())});
        }
        strands_.push_back(std::move(strand));
    }
}

const WirePoint& WireSkin::pathAt(const Strand& strand, int station) const {
    return strand.path[station * steps_];
}

float WireSkin::thinner() const {
    return static_cast<float>(section_.across > 0 ? std::min(section_.along, section_.across)
                                                  : section_.along);
}

// m, of the section along a direction across the wire.
float WireSkin::widthAcross(const WirePoint& p, const glm::vec3& side) const {
    const auto a = static_cast<float>(section_.along), b = static_cast<float>(section_.across);
    if (b == 0) return a;
    return a * std::abs(glm::dot(side, p.director)) +
           b * std::abs(glm::dot(side, glm::cross(p.tangent, p.director)));
}

WireSkin::Surroundings WireSkin::about(const Beside& beside, const Openness& open,
                                       const WirePoint& p, const Lens& lens) const {
    Surroundings result{.open = open, .hidden = {}, .layers = 1};
    const glm::vec3 side = sideOf(p, lens);
    const float least = leastWidth(p, lens);
    float layers = 0, sides = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const float way = glm::length(beside[k]);
        if (way == 0) continue;
        const glm::vec3 u = beside[k] / way;
        const float gap = std::max(way - widthAcross(p, u), 0.0f);
        result.hidden[k] = stripFactor(gap / widthAcross(p, glm::cross(p.tangent, u))) * u;
        // One that lies behind is no layer of the same stack.
        const float besideIt = std::abs(glm::dot(u, side));
        layers += besideIt * besideIt * std::max(least / (way * besideIt + 1e-9f) - 1, 0.0f);
        ++sides;
    }
    if (sides > 0) result.layers += layers / sides;
    return result;
}

WireSkin::Surroundings WireSkin::between(const Strand& strand, float link) const {
    const int n = strand.stations,
              i = std::min(static_cast<int>(link), strand.closed ? n - 1 : n - 2);
    const float s = link - static_cast<float>(i);
    const auto at = [&](int k) -> const Surroundings& {
        return surroundings_[strand.firstStation + k % n];
    };
    const Surroundings &a = at(i), &b = at(i + 1);
    Surroundings mixed;
    mixed.open = mix(a.open, b.open, s);
    for (std::size_t k = 0; k < 2; ++k) mixed.hidden[k] = glm::mix(a.hidden[k], b.hidden[k], s);
    mixed.layers = glm::mix(a.layers, b.layers, s);
    return mixed;
}

// Widths and covers. Of a stack so far away that its wires, wider than they are, cover each other
// `layers` deep, as much must show through as between them: 1 - c = (1 - cover)^layers.
void WireSkin::look(Strand& strand, const Polyline& curve, std::span<const glm::vec3> tints,
                    const Lens& lens) {
    const int n = strand.stations;
    for (const WirePoint& p : strand.path) {
        const int i = std::min(static_cast<int>(p.link), n - 1);
        WireLook look;
        look.tint = glm::mix(tints[curve.vertices[i]], tints[curve.vertices[(i + 1) % n]],
                             p.link - static_cast<float>(i));
        const float least = leastWidth(p, lens), width = widthAcross(p, sideOf(p, lens));
        look.relief = smooth(thinner() * leastPixels / least, 1.5f, 3.5f);
        look.scale = 1 + seam * (1 - look.relief);
        if (width < least) {
            const float layers = between(strand, p.link).layers;
            const float covered = std::min(1.0f, width * layers / least);
            look.scale = least / std::max(width, 1e-3f * least);
            look.cover = 1 - std::pow(1 - covered, 1 / layers);
            faint_ = true;
        }
        strand.looks.push_back(look);
    }
}

void WireSkin::shade(const Strand& strand, const Lens& lens, std::span<MeshVertex> vertices) const {
    const std::size_t corners = outline_.size(), rings = strand.path.size();
    for (std::size_t i = 0; i * corners < vertices.size(); ++i) {
        const std::size_t at = i < rings ? i : i == rings ? 0 : rings - 1;  // a cap is at an end
        const WirePoint& p = strand.path[at];
        const Surroundings around = between(strand, p.link);
        const float relief = strand.looks[at].relief;
        const auto ring = vertices.subspan(i * corners, corners);
        if (i < rings && section_.across == 0 && relief < 1) bend(p, relief, lens, ring);
        for (MeshVertex& v : ring) {
            v.cavity = around.open.at(glm::dot(v.normal, p.director),
                                      glm::dot(v.normal, glm::cross(p.tangent, p.director)));
            for (const glm::vec3& hidden : around.hidden)
                v.cavity *= 1 - groove * lost(v.normal, hidden, relief);
        }
    }
}

// Normals towards the eye, the more the less relief is left.
void WireSkin::bend(const WirePoint& p, float relief, const Lens& lens,
                    std::span<MeshVertex> ring) const {
    const glm::vec3 out = glm::cross(sideOf(p, lens), p.tangent);
    const glm::vec3 seen = glm::dot(out, lens.eye - p.place) > 0 ? out : -out;
    for (MeshVertex& v : ring) {
        const glm::vec3 n = glm::mix(seen, v.normal, relief);
        v.normal = glm::dot(n, n) > 1e-6f ? glm::normalize(n) : seen;
    }
}

}  // namespace plait
