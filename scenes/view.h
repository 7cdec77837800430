// How a scene should be looked at, as plain numbers: camera, materials, props. What they look like
// in pixels is the business of render/. Metres, y up.
#pragma once

#include "complex.h"
#include "shapes.h"

#include <array>
#include <string>
#include <vector>

namespace plait {

// A camera pose. The focal length is for a sensor 36 mm wide (of a 16:9 picture, 20.25 mm high).
struct Camera {
    double time = 0;  // s
    Vec<double> eye{0, 0, 5};
    Vec<double> target{0, 0, 0};
    double focalLength = 50;  // mm
};

enum class Material { silk, cotton, brass, steel, matte, rubber, wire };

// How one object of the world is drawn: its triangles, or its curves as tubes of `radius`.
struct Look {
    Range object;
    Material material = Material::silk;
    std::array<double, 3> color{0.578, 0.032, 0.014};  // linear; vermilion
    std::string print = "";                      // "plait": our emblem across the cloth; needs `uv`
    std::vector<std::array<double, 2>> uv = {};  // by vertex of the object; (0, 0) lower left
    double radius = 0.004;                       // m, of curves and points
};

// A helical spring, drawn from a place that stays to the middle of a vertex.
struct Coil {
    Vec<double> from{0, 0, 0};
    int to = 0;           // vertex of the world
    double radius = 0.1;  // m, to the middle of its wire
    double wire = 0.01;   // m, radius of it
    int turns = 10;
    Material material = Material::steel;
    std::array<double, 3> color{0.397, 0.445, 0.491};
};

// What stands about and does not move, or moves as one rigid thing.
struct Prop {
    Shape shape;
    Material material = Material::matte;
    std::array<double, 3> color{0.254, 0.216, 0.188};
};

struct View {
    std::vector<Camera> cameras;  // poses in time; between them the path is smooth
    std::vector<Look> looks;
    std::vector<Coil> coils;
    std::vector<Prop> props;
    bool ground = true;  // a matte plane at y = groundHeight that dissolves into the backdrop
    double groundHeight = 0;
    double groundSize = 1;  // m, of the subject: the plane dissolves from 1.2 to 3.5 of it
    // A glow of the backdrop behind the subject: its direction is that from camera to this point.
    Vec<double> glowCenter{0, 0, 0};
    double glow = 0.3;
};

}  // namespace plait
