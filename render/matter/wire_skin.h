// What is seen of wires: curves of the world with a section.
#pragma once

#include "polyline.h"
#include "wire_mesh.h"
#include "wire_surroundings.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace plait {

// From where a picture is taken, as far as the width of a wire depends on it.
struct Lens {
    glm::vec3 eye{0};      // m
    glm::vec3 forward{0};  // of length 1
    float pixel = 0;       // m that a pixel shows 1 m away
};

class WireSkin {
public:
    // `curves` count from the start of look.object. `pixel`: m that a pixel shows of it. Throws
    // std::invalid_argument where section or directors do not fit.
    WireSkin(const Look& look, std::vector<Polyline> curves, std::span<const glm::vec3> rest,
             float pixel);

    const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

    // Positions of the object and of its directors (m), and tints of an overlay by vertex.
    void update(std::span<const glm::vec3> points, std::span<const glm::vec3> directors,
                std::span<const glm::vec3> tints, const Lens& lens,
                std::vector<MeshVertex>& vertices);

    // Triangles in a row that lie around the wire at one place.
    std::size_t group() const { return 2 * outline_.size(); }

    // Some of it is fainter than it is, being thinner than is drawn.
    bool faint() const { return faint_; }

private:
    // One of the curves, as it is now.
    struct Strand {
        std::vector<WirePoint> path;
        std::vector<WireLook> looks;
        int firstStation, stations;
        bool closed;
    };
    // What stands about a station.
    struct Surroundings {
        Openness open;
        Beside hidden{};   // towards the turns beside, as long as the part that they hide
        float layers = 1;  // of wire, as wide as it is drawn, over a pixel
    };

    void placeStrands(std::span<const glm::vec3> points, std::span<const glm::vec3> directors);
    void look(Strand& strand, const Polyline& curve, std::span<const glm::vec3> tints,
              const Lens& lens);
    void shade(const Strand& strand, const Lens& lens, std::span<MeshVertex> vertices) const;
    void bend(const WirePoint& p, float relief, const Lens& lens, std::span<MeshVertex> ring) const;
    const WirePoint& pathAt(const Strand& strand, int station) const;
    Surroundings between(const Strand& strand, float link) const;
    Surroundings about(const Beside& beside, const Openness& open, const WirePoint& p,
                       const Lens& lens) const;
    float thinner() const;  // m, side of its section
    float widthAcross(const WirePoint& p, const glm::vec3& side) const;

    Section section_;
    std::vector<Polyline> curves_;
    std::vector<OutlinePoint> outline_;
    int steps_ = 4;  // of the path, in a link
    bool faint_ = false;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<Strand> strands_;
    std::vector<WireStation> stations_;
    std::vector<Surroundings> surroundings_;
};

}  // namespace plait
