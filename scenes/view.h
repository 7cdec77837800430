// How a scene should be looked at, as plain numbers: camera, materials, props. What they look like
// in pixels is the business of render/. Metres, y up.
#pragma once

#include <plait/complex/complex.h>
#include <plait/complex/shapes.h>
#include <plait/contacts/solids/placement.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plait {

// A camera pose. The focal length is for a sensor of 36 mm x 20.25 mm, of a picture of 16:9; wider
// ones show more to the sides, and narrower ones more above and below.
struct Camera {
    double time = 0;  // s
    Vec<double> eye{0, 0, 5};
    Vec<double> target{0, 0, 0};
    double focalLength = 50;  // mm
    // Part of the width, about its middle, that the subject needs: what a narrower picture keeps.
    double across = 1;
};

// A tulle is a net: what lies behind it is seen, and dimmed by each layer; it is to be drawn by
// triangles. Skin may wear satin where its look says so.
// Brushed metal has a grain along its wire: its highlights are drawn out across it.
// Water is a liquid of particles, of which `radius` is half the spacing; of a view one look may be
// of it. Latex lets through the more light the thinner it is drawn out: glossy and aglow where it
// is taut, deep and matte where it is limp. It is to be drawn by triangles; their rest shape is the
// world's.
// Glass is solids of a pane, with sharp edges, whose faces inside are seen where they came apart.
// Crystal is a vessel of glass with a smooth wall; a thing that stands about.
// A spark shines by itself: its colour is the light that it sends, and it casts no shadow.
enum class Material {
    silk,
    cotton,
    brass,
    steel,
    matte,
    rubber,
    wire,
    satin,
    tulle,
    skin,
    brushed,
    latex,
    water,
    glass,
    crystal,
    spark,
};

// Of a wire: a rectangle of `along` by `across` its director, or, without the latter, a circle of
// the diameter `along`.
struct Section {
    double along = 0;   // m
    double across = 0;  // m
    double bevel = 1;   // 0 .. 1: radius of the rectangle's corners in halves of its thinner side
};

// A wall of rubber whose area has grown by the factor s lets through exp(-k thickness / s) of the
// light from behind, by channel; k = -ln(color) / clear.
struct Wall {
    double thickness = 0.25e-3;  // m, at rest
    double clear = 16e-6;        // m, at which what comes through has the look's colour
};

// A flat wall of glass that water lies against: of what is behind it, where the normal points,
// nothing is drawn.
struct GlassPane {
    Vec<double> point;   // m
    Vec<double> normal;  // of length 1
};

// How a point is drawn that comes and goes.
struct PointLook {
    double radius = 0.004;                 // m; 0: it is not seen
    std::array<double, 3> color{1, 1, 1};  // linear; of a spark beyond 1
    double tail = 0;                       // s: of its way that it is drawn out by
};

// How one object of the world is drawn: its triangles, or its curves as tubes of `radius`, or, with
// a `section`, as wires: swept along a smooth curve through the vertices, with the frame that the
// directors have, at least 1.5 pixels wide and fainter where they are thinner, and darker where
// turns lie close. Wires are of metal, rubber or matte.
struct Look {
    // Of what may tear all of it: spare vertices look as what they become copies of.
    Range object;
    Material material = Material::silk;
    std::array<double, 3> color{0.578, 0.032, 0.014};  // linear; vermilion
    std::string print = "";                      // "plait": our emblem across the cloth; needs `uv`
    std::vector<std::array<double, 2>> uv = {};  // by vertex of the object; (0, 0) lower left
    double radius = 0.004;                       // m, of curves and points; 0: points are not drawn
    bool sharp = false;  // its triangles are as they are, with edges from 40 degrees on
    // By vertex of the object; none: `color`, and bare skin.
    std::vector<std::array<double, 3>> colors = {};  // linear
    std::vector<double> satin = {};                  // 0 .. 1, how much of it skin wears
    // Of a point, in place of radius and colour: by the id that its source gave it and its age, s.
    std::function<PointLook(std::int32_t id, double age)> point = {};
    Section section = {};
    Range directors = {};  // of a wire, one an edge, beside its middle; none: a frame without twist
    // Of latex. Of water: `clear` is the depth (m) at which its colour has swallowed what it can,
    // `thickness` how far behind it lies what is seen through it as through a lens.
    Wall wall = {};
    std::vector<GlassPane> panes = {};  // of water, at most six
};

// What stands about and does not move, or moves as one rigid thing.
struct Prop {
    Shape shape;
    Material material = Material::matte;
    std::array<double, 3> color{0.254, 0.216, 0.188};
    // Of crystal, by vertex: radius of the hollow over that of the outside, 0 where it is solid; -1
    // inside the hollow.
    std::vector<double> hollow = {};
    Posing motion = {};  // where the shape's own axes are at a time (s); none: it stands
};

// The camera goes along with a point, as an operator would who knows the way: its motion is
// averaged before and after each moment, so that the picture neither shakes nor lags.
struct Follow {
    std::function<Vec<double>(double)> point;  // m, at any time (s); none: the camera stays
    Vec<double> home{0, 0, 0};                 // where it is when the poses hold as they are
    // Parts of its way, along each axis, that eye and target go.
    Vec<double> eye{0.7, 0.2, 0.7};
    Vec<double> target{1, 0.5, 1};
    double ground = 0;       // part of its way that the middle of the ground goes
    double smoothing = 0.8;  // s, before and after
};

// Light and floor of a theatre; as it is, those of the studio.
struct Stage {
    double spot = 0;         // m, radius of the key light's pool around `glowCenter`; 0: everywhere
    double dim = 0;          // part of the light of backdrop and fill that is off
    double mirror = 0;       // part of the light that the floor mirrors where it is grazed
    double mirrorFades = 1;  // m, above the floor, where a mirror image has faded to a third
    double vignette = 0.12;  // part of the light that the lens loses at the middle of an edge
    std::array<double, 3> floor{0.254, 0.216, 0.188};  // linear
};

// A part of a film.
struct Take {
    double from = 0, to = 0;           // s of the run
    double slow = 1;                   // times slower than it was
    std::string words = "";            // a line above
    std::vector<Camera> cameras = {};  // none: the view's
};

// A small chart in a corner of every picture: a curve, as long as its axes, and a dot where two
// metrics of the scene are, which leaves a trail.
struct Inset {
    std::string x, y;  // their names; with their units the axes' labels
    std::vector<std::array<double, 2>> curve = {};
};

struct View {
    std::vector<Camera> cameras;  // poses in time; between them the path is smooth
    Follow follow;                // moves glow and spot as well
    std::vector<Look> looks;
    std::vector<Prop> props;
    bool ground = true;  // a matte plane at y = groundHeight that dissolves into the backdrop
    double groundHeight = 0;
    double groundSize = 1;  // m, of the subject: the plane dissolves from 1.2 to 3.5 of it
    // A glow of the backdrop behind the subject: its direction is that from camera to this point.
    Vec<double> glowCenter{0, 0, 0};
    double glow = 0.3;
    Stage stage;
    // Of the film, in their order, at 24 pictures a second; a take may show again what one before
    // it did. None: the run as it is.
    std::vector<Take> takes;
    std::optional<Inset> inset;
};

}  // namespace plait
