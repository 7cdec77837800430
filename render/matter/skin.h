// What is seen of an object: from its vertices in the world to triangles with normals, every frame.
#pragma once

#include "area_stretch.h"
#include "facets.h"
#include "mesh_vertex.h"
#include "moment.h"
#include "polyline.h"
#include "scenes/view.h"
#include "subdivision.h"
#include "wire_skin.h"

#include <plait/world.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace plait {

// Triangles are smoothed and, where they are wide, divided once (unless they bound tetrahedra);
// edges without triangles become tubes or wires, points without edges balls, unless copies may be
// made of them where matter tears. Simplices belong to the object if all their vertices do.
class Skin {
public:
    // `pixel`: m, that a pixel shows of the object. Throws std::invalid_argument if `look` has a
    // range outside the world or a wrong number of uv, colours or satin.
    Skin(const World& world, const Look& look, float pixel);
    // A thing that keeps its shape; its edges are sharp from 40 degrees on. Throws
    // std::invalid_argument for a wrong number of `hollow`.
    explicit Skin(const Prop& prop);

    // Tints of an overlay by vertex of the world, or none. Wires are as wide as `lens` wants them;
    // balls whose age is below 0 are not there.
    void update(const Moment& moment, std::span<const glm::vec3> tints = {}, const Lens& lens = {});
    // Of a thing that keeps its shape: where its own axes are now.
    void place(const Frame& frame);

    const std::vector<MeshVertex>& vertices() const { return vertices_; }
    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
    Material material() const { return material_; }
    const glm::vec3& color() const { return color_; }
    bool printed() const { return printed_; }
    bool isWire() const { return wire_.has_value(); }
    bool faint() const { return wire_ && wire_->faint(); }            // to be blended
    std::size_t group() const { return wire_ ? wire_->group() : 1; }  // WireSkin
    // By vertex, unless tinted.
    bool colored() const { return !colors_.empty() || pointLook_; }
    const glm::vec2& size() const { return size_; }  // m, of the cloth along u and v
    // m, of an edge of a surface whose triangles are as small as is seen: there light changes
    // little from vertex to vertex. Otherwise 0.
    float facet() const { return facet_; }

private:
    void addSurface(const SimplicialComplex& complex, std::span<const Vec<double>> rest,
                    const Look& look, float pixel);
    void cutFacets(std::span<const Vec<double>> rest);
    void paint(const Look& look);
    void layCloth(std::span<const Vec<double>> rest, std::span<const std::array<int, 3>> triangles,
                  const Look& look);
    void updateSurface(bool tinted);
    void updateStretch();
    void addWire(std::span<const Vec<double>> rest, const Look& look, float pixel);
    void addBalls(std::span<const char> covered);
    void updateCurves();
    void updateBalls(bool tinted, const Moment& moment);
    void updateWire(WireSkin& wire, std::span<const Vec<double>> positions, const Lens& lens);

    Range range_;
    Material material_;
    glm::vec3 color_;
    bool printed_ = false;
    float radius_ = 0;
    glm::vec2 size_{1};
    float facet_ = 0;

    Subdivision subdivision_;  // none: fine is coarse
    Facets facets_;            // of glass; it has neither curves nor points
    int surfaceVertices_ = 0, surfaceTriangles_ = 0;
    std::vector<glm::vec2> uv_;  // m, of fine vertices
    std::vector<glm::vec3> colors_;
    std::vector<float> satin_;  // of latex its stretch, from frame to frame
    AreaStretch areaStretch_;
    std::vector<float> coarseStretch_;
    std::vector<Polyline> curves_;
    std::optional<WireSkin> wire_;
    Range directors_;
    std::vector<int> balls_;
    Shape ball_;  // of radius 1 m
    std::function<PointLook(std::int32_t, double)> pointLook_;

    std::vector<glm::vec3> coarse_, fine_;
    std::vector<glm::vec3> coarseTints_, fineTints_;
    std::vector<MeshVertex> vertices_;
    std::vector<MeshVertex> own_;  // of a thing that moves, in its own axes
    std::vector<std::array<int, 3>> triangles_;
};

}  // namespace plait
