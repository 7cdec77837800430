#include "skin.h"

#include "directions.h"
#include "outer_triangles.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace plait {
namespace {

glm::vec3 toGlm(const Vec<double>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

glm::vec3 toGlm(const std::array<double, 3>& v) { return toGlm(Vec<double>{v[0], v[1], v[2]}); }

constexpr glm::vec3 up{0, 1, 0};  // where a direction vanishes

// Pixels, of an edge. A rasteriser in software shades blocks of 4 by 4 for each triangle that
// touches them: of smaller triangles it draws a picture several times over.
constexpr float widestFacet = 10;

// m
float meanEdge(std::span<const Vec<double>> x, std::span<const std::array<int, 3>> triangles) {
    double sum = 0;
    for (const auto& [a, b, c] : triangles)
        sum += length(x[b] - x[a]) + length(x[c] - x[b]) + length(x[a] - x[c]);
    return static_cast<float>(sum / (3 * static_cast<double>(triangles.size())));
}

}  // namespace

Skin::Skin(const World& world, const Look& look, float pixel)
    : range_(look.object),
      material_(look.material),
      color_(toGlm(look.color)),
      printed_(look.print == "plait"),
      radius_(static_cast<float>(look.radius)),
      pointLook_(look.point) {
    const SimplicialComplex& complex = world.complex;
    const std::span<const Vec<double>> rest = world.rest;
    if (range_.first < 0 || range_.last > complex.count(0) || range_.size() < 1)
        throw std::invalid_argument("look: its object is not a range of the world's vertices");
    for (const std::size_t n : {look.uv.size(), look.colors.size(), look.satin.size()})
        if (n > 0 && static_cast<int>(n) != range_.size())
            throw std::invalid_argument(
                "look: needs as many uv, colors or satin as the object has vertices");
    addSurface(complex, rest, look, pixel);

    const Csr triangles = complex.parents(1);
    std::vector<std::array<int, 2>> edges;
    std::vector<char> covered(static_cast<std::size_t>(range_.size()));
    for (int i = 0; i < complex.count(1); ++i) {
        const auto ends = complex.vertices(1, i);
        if (!liesIn(ends, range_)) continue;
        for (const int v : ends) covered[v - range_.first] = 1;
        if (triangles[i].empty()) edges.push_back({ends[0] - range_.first, ends[1] - range_.first});
    }
    // Copies are corners of triangles, or not there yet.
    for (const Tearable& tearable : world.tearable)
        for (int v = tearable.spare.first; v < tearable.spare.last; ++v)
            if (liesIn({&v, 1}, range_)) covered[v - range_.first] = 1;
    curves_ = polylines(edges, range_.size());
    if (look.section.along > 0) addWire(rest, look, pixel);
    if (look.radius > 0) addBalls(covered);
    update({rest});
}

void Skin::addBalls(std::span<const char> covered) {
    for (int i = 0; i < range_.size() && facets_.empty(); ++i)
        if (!covered[i] && material_ != Material::water) balls_.push_back(i);
    // A hundred thousand need not be as round.
    constexpr std::size_t many = 10'000;
    if (!balls_.empty()) ball_ = sphere({.subdivisions = balls_.size() < many ? 2 : 1});
}

void Skin::addWire(std::span<const Vec<double>> rest, const Look& look, float pixel) {
    directors_ = look.directors;
    if (surfaceVertices_ > 0 || directors_.first < 0 ||
        directors_.last > static_cast<int>(rest.size()))
        throw std::invalid_argument("look: a wire is a curve, its directors are in the world");
    std::vector<glm::vec3> points;
    for (int i = range_.first; i < range_.last; ++i) points.push_back(toGlm(rest[i]));
    wire_.emplace(look, std::exchange(curves_, {}), points, pixel);
}

Skin::Skin(const Prop& prop) : material_(prop.material), color_(toGlm(prop.color)) {
    const auto& complex = prop.shape.complex;
    const Range all{0, complex.count(0)};
    const auto& x = prop.shape.positions;
    if (!prop.hollow.empty() && prop.hollow.size() != x.size())
        throw std::invalid_argument("prop: needs as many of hollow as its shape has vertices");
    const auto triangles = outerTriangles(complex, x, all);
    std::vector<glm::vec3> normals;  // as long as twice the area
    std::vector<std::vector<int>> around(x.size());
    for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
        const auto& [a, b, c] = triangles[i];
        normals.push_back(toGlm(cross(x[b] - x[a], x[c] - x[a])));
        for (const int v : triangles[i]) around[v].push_back(i);
    }
    for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
        const int first = static_cast<int>(vertices_.size());
        triangles_.push_back({first, first + 1, first + 2});
        for (const int v : triangles[i]) {
            glm::vec3 normal{0};
            for (const int other : around[v])
                if (glm::dot(unit(normals[other], up), unit(normals[i], up)) > 0.766f)
                    normal += normals[other];
            vertices_.push_back(
                {.position = toGlm(x[v]), .normal = unit(normal, up), .tangent = {0, 1, 0}});
            if (!prop.hollow.empty()) vertices_.back().satin = static_cast<float>(prop.hollow[v]);
        }
    }
    if (prop.motion) own_ = vertices_;
}

void Skin::place(const Frame& frame) {
    const glm::vec3 x = toGlm(frame.across), y = toGlm(frame.up), at = toGlm(frame.origin);
    const glm::mat3 turn(x, y, glm::cross(x, y));
    for (std::size_t i = 0; i < own_.size(); ++i) {
        vertices_[i].position = at + turn * own_[i].position;
        vertices_[i].normal = turn * own_[i].normal;
        vertices_[i].tangent = turn * own_[i].tangent;
    }
}

void Skin::addSurface(const SimplicialComplex& complex, std::span<const Vec<double>> rest,
                      const Look& look, float pixel) {
    triangles_ = outerTriangles(complex, rest, range_);
    if (triangles_.empty()) return;
    if (material_ == Material::glass) return cutFacets(rest);
    const auto coarse = triangles_;
    surfaceVertices_ = range_.size();
    const auto own = rest.subspan(range_.first, range_.size());
    if (look.sharp) {
        subdivision_ = Subdivision::facets(coarse, own);
    } else if (complex.count(3) == 0) {
        float edge = meanEdge(own, coarse);
        const bool refined = edge > widestFacet * pixel;
        if (refined) edge *= 0.5f;
        if (edge < widestFacet * pixel) facet_ = edge;
        subdivision_ = Subdivision(coarse, own, refined);
    }
    if (subdivision_.size() > 0) {
        surfaceVertices_ = subdivision_.size();
        triangles_ = subdivision_.triangles();
    }
    surfaceTriangles_ = static_cast<int>(triangles_.size());
    if (material_ == Material::latex) areaStretch_ = AreaStretch(coarse, own);
    layCloth(rest, coarse, look);
    paint(look);
}

void Skin::cutFacets(std::span<const Vec<double>> rest) {
    std::vector<glm::vec3> positions;
    for (const Vec<double>& x : rest.subspan(range_.first, range_.size()))
        positions.push_back(toGlm(x));
    facets_ = Facets(positions, std::move(triangles_));
    surfaceVertices_ = facets_.corners();
    triangles_.clear();
    for (int i = 0; i < surfaceVertices_; i += 3) triangles_.push_back({i, i + 1, i + 2});
    surfaceTriangles_ = static_cast<int>(triangles_.size());
}

void Skin::paint(const Look& look) {
    for (const auto& c : look.colors) colors_.push_back(toGlm(c));
    satin_.assign(look.satin.begin(), look.satin.end());
    if (subdivision_.size() == 0) return;
    const auto coarseColors = colors_;
    const auto coarseSatin = satin_;
    if (!colors_.empty()) subdivision_.apply<glm::vec3>(coarseColors, colors_);
    if (!satin_.empty()) subdivision_.apply<float>(coarseSatin, satin_);
}

// The uv of a look come in any unit: here they become metres of the rest shape.
void Skin::layCloth(std::span<const Vec<double>> rest,
                    std::span<const std::array<int, 3>> triangles, const Look& look) {
    std::vector<glm::vec2> uv(static_cast<std::size_t>(range_.size()));
    for (int i = 0; i < range_.size(); ++i) {
        const auto& x = rest[range_.first + i];
        uv[i] =
            look.uv.empty() ? glm::vec2(x.x, x.y + x.z) : glm::vec2(look.uv[i][0], look.uv[i][1]);
    }
    // Least squares of |dx|^2 = (a du)^2 + (b dv)^2 would couple the two; edges along one axis only
    // are enough to scale by.
    glm::dvec2 length{0}, span{1e-12};
    for (const auto& t : triangles)
        for (int k = 0; k < 3; ++k) {
            const int a = t[k], b = t[(k + 1) % 3];
            const glm::vec2 d = glm::abs(uv[a] - uv[b]);
            const int axis = d.x > d.y ? 0 : 1;
            if (d[1 - axis] > 0.1f * d[axis]) continue;
            length[axis] += plait::length(rest[range_.first + a] - rest[range_.first + b]);
            span[axis] += d[axis];
        }
    const glm::vec2 scale(length.x > 0 ? length.x / span.x : 1,
                          length.y > 0 ? length.y / span.y : 1);
    glm::vec2 low{1e30f}, high{-1e30f};
    for (auto& c : uv) {
        c *= scale;
        low = glm::min(low, c);
        high = glm::max(high, c);
    }
    for (auto& c : uv) c -= low;
    size_ = high - low;
    uv_ = uv;
    if (subdivision_.size() > 0) subdivision_.apply<glm::vec2>(uv, uv_);
}

void Skin::update(const Moment& moment, std::span<const glm::vec3> tints, const Lens& lens) {
    const std::span<const Vec<double>> positions = moment.positions;
    if (range_.size() == 0) return;  // a prop
    if (static_cast<int>(positions.size()) < range_.last ||
        (!tints.empty() && static_cast<int>(tints.size()) < range_.last))
        throw std::invalid_argument("draw: positions and tints must be those of the whole world");
    coarse_.resize(static_cast<std::size_t>(range_.size()));
    coarseTints_.assign(coarse_.size(), glm::vec3(0));
    for (int i = 0; i < range_.size(); ++i) {
        coarse_[i] = toGlm(positions[range_.first + i]);
        if (!tints.empty()) coarseTints_[i] = tints[range_.first + i];
    }
    vertices_.resize(static_cast<std::size_t>(surfaceVertices_));
    triangles_.resize(static_cast<std::size_t>(surfaceTriangles_));
    if (!facets_.empty()) return facets_.update(coarse_, vertices_);
    if (surfaceVertices_ > 0) updateSurface(!tints.empty());
    updateCurves();
    updateBalls(!tints.empty(), moment);
    if (wire_) updateWire(*wire_, positions, lens);
}

void Skin::updateSurface(bool tinted) {
    const bool refined = subdivision_.size() > 0;
    if (refined) {
        subdivision_.apply<glm::vec3>(coarse_, fine_);
        subdivision_.apply<glm::vec3>(coarseTints_, fineTints_);
    }
    if (material_ == Material::latex) updateStretch();
    const auto& x = refined ? fine_ : coarse_;
    const auto& tints = refined ? fineTints_ : coarseTints_;
    for (int i = 0; i < surfaceVertices_; ++i)
        vertices_[i] = {.position = x[i],
                        .uv = uv_[i],
                        .tint = colored() && !tinted ? colors_[i] : tints[i],
                        .satin = satin_.empty() ? 0.0f : satin_[i]};
    for (const auto& [a, b, c] : triangles_) {
        const glm::vec3 p = x[b] - x[a], q = x[c] - x[a];
        const glm::vec2 s = uv_[b] - uv_[a], t = uv_[c] - uv_[a];
        const glm::vec3 normal = glm::cross(p, q);
        const glm::vec3 along = (p * t.y - q * s.y) * glm::sign(s.x * t.y - t.x * s.y);
        for (const int v : {a, b, c}) {
            vertices_[v].normal += normal;
            vertices_[v].tangent += along;
        }
    }
    for (auto& v : vertices_) {
        v.normal = unit(v.normal, up);
        v.tangent = unit(v.tangent - v.normal * glm::dot(v.normal, v.tangent), up);
    }
    // Bend of the surface towards the normal: dn.dx / dx.dx, averaged over the edges at a vertex.
    for (const auto& t : triangles_)
        for (int k = 0; k < 3; ++k) {
            MeshVertex &a = vertices_[t[k]], &b = vertices_[t[(k + 1) % 3]];
            const glm::vec3 d = b.position - a.position;
            const float bend = -glm::dot(b.normal - a.normal, d) / (glm::dot(d, d) + 1e-12f) / 6;
            a.cavity += bend;
            b.cavity += bend;
        }
}

void Skin::updateStretch() {
    areaStretch_.measure(coarse_, coarseStretch_);
    if (subdivision_.size() > 0)
        subdivision_.apply<float>(coarseStretch_, satin_);
    else
        satin_ = coarseStretch_;
}

void Skin::updateCurves() {
    std::vector<glm::vec3> points;
    std::vector<glm::vec3> tints;
    for (const Polyline& curve : curves_) {
        points.clear();
        tints.clear();
        for (const int v : curve.vertices) {
            points.push_back(coarse_[v]);
            tints.push_back(coarseTints_[v]);
        }
        appendTube(points, tints, curve.closed, radius_, vertices_, triangles_);
    }
}

// What is not there has no size: triangles are those of all. A tail is drawn out of the back.
void Skin::updateBalls(bool tinted, const Moment& moment) {
    for (const int v : balls_) {
        const auto at = static_cast<std::size_t>(range_.first) + static_cast<std::size_t>(v);
        const double age = moment.ages.empty() ? 0 : moment.ages[at];
        PointLook look{age < 0 ? 0 : radius_};
        if (pointLook_ && age >= 0) look = pointLook_(moment.ids.empty() ? 0 : moment.ids[at], age);
        const auto radius = static_cast<float>(look.radius);
        const glm::vec3 back = moment.velocities.empty()
                                   ? glm::vec3(0)
                                   : -static_cast<float>(look.tail) * toGlm(moment.velocities[at]);
        const glm::vec3 behind = unit(back, up);
        const glm::vec3 tint = pointLook_ && !tinted ? toGlm(look.color) : coarseTints_[v];
        const int first = static_cast<int>(vertices_.size());
        for (const auto& p : ball_.positions) {
            const glm::vec3 normal = toGlm(p);
            vertices_.push_back({.position = coarse_[v] + radius * normal +
                                             std::max(0.0f, glm::dot(normal, behind)) * back,
                                 .normal = normal,
                                 .tangent = {0, 1, 0},
                                 .tint = tint});
        }
        for (int i = 0; i < ball_.complex.count(2); ++i) {
            const auto [a, b, c] = ball_.complex.triangle(i);
            triangles_.push_back({first + a, first + b, first + c});
        }
    }
}

void Skin::updateWire(WireSkin& wire, std::span<const Vec<double>> positions, const Lens& lens) {
    if (static_cast<int>(positions.size()) < directors_.last)
        throw std::invalid_argument("draw: positions must be those of the whole world");
    std::vector<glm::vec3> directors;
    for (int i = directors_.first; i < directors_.last; ++i)
        directors.push_back(toGlm(positions[i]));
    const int first = static_cast<int>(vertices_.size());
    wire.update(coarse_, directors, coarseTints_, lens, vertices_);
    for (const auto& [a, b, c] : wire.triangles())
        triangles_.push_back({first + a, first + b, first + c});
}

}  // namespace plait
