#include "views.h"

#include <plait/constraints/constants.h>
#include <plait/numbers/elementary.h>

namespace plait {
namespace {

// Linear, of the look book: brass, steel, slate, and vermilion for the rest.
std::array<double, 3> colorOf(Material material) {
    switch (material) {
        case Material::brass:
            return {0.584, 0.305, 0.050};
        case Material::steel:
            return {0.397, 0.445, 0.491};
        case Material::matte:
            return {0.098, 0.144, 0.195};
        default:
            return {0.578, 0.032, 0.014};
    }
}

}  // namespace

Look lookOf(const Range& object, Material material, double radius) {
    return {.object = object, .material = material, .color = colorOf(material), .radius = radius};
}

View viewOf(const std::vector<Range>& objects, const Vec<double>& middle, double size,
            Material material, const Vec<double>& from) {
    View view;
    view.cameras = {{.time = 0,
                     .eye = middle + size * from,
                     .target = middle - size * Vec<double>{0, 0.05, 0},
                     .focalLength = 40,
                     .across = 0.85}};
    for (const Range& object : objects)
        view.looks.push_back(lookOf(object, material, 0.012 * size));
    view.groundHeight = middle.y - 0.62 * size;
    view.groundSize = size;
    view.glowCenter = middle;
    return view;
}

void travel(View& view, const Vec<double>& velocity) {
    const Camera start = view.cameras[0];
    view.cameras.clear();
    // Between poses in line the path is straight, but for the first and last stretch, where the
    // camera would start and stop.
    for (const double t : {-1e4, 0.0, 1e4, 2e4})
        view.cameras.push_back({t, start.eye + t * velocity, start.target + t * velocity,
                                start.focalLength, start.across});
    view.ground = false;
    // So far away that its direction stays.
    view.glowCenter += 1e6 * (start.target - start.eye);
}

Stage theatre(double size) {
    return {.spot = 1.5 * size,
            .dim = 0.35,
            .mirror = 0.8,
            .mirrorFades = 0.4 * size,
            .vignette = 0.25,
            .floor = {0.2, 0.175, 0.165}};
}

void addBar(View& view, const Vec<double>& from, const Vec<double>& to, double radius,
            Material material) {
    const double l = length(to - from);
    const Vec<double> axis = (1 / l) * (to - from);
    const Vec<double> any = axis.y * axis.y < 0.8 ? Vec<double>{0, 1, 0} : Vec<double>{1, 0, 0};
    const Vec<double> side = cross(axis, any), u = (1 / length(side)) * side, v = cross(axis, u);
    const auto color = colorOf(material);
    view.props.push_back({tube({.segments = 64, .radius = radius, .height = l},
                               {.origin = from, .across = u, .up = axis}),
                          material, color});
    for (const double end : {-1.0, 1.0})
        view.props.push_back({disc({.rings = 8, .radius = radius},
                                   {.origin = end < 0 ? from : to, .across = u, .up = end * v}),
                              material, color});
}

void addBox(View& view, const Vec<double>& low, const Vec<double>& high) {
    const Vec<double> size = high - low;
    view.props.push_back(
        {block({.width = size.x, .height = size.y, .depth = size.z}, {.origin = low}),
         Material::matte, colorOf(Material::matte)});
}

void addPeg(View& view, const Vec<double>& front, double radius) {
    addBar(view, front - Vec<double>{0, 0, 0.2}, front, radius, Material::matte);
}

Shape turned(const std::vector<std::array<double, 2>>& profile, int sides) {
    Simplices simplices;
    Shape shape;
    for (int i = 0; i < static_cast<int>(profile.size()); ++i)
        for (int k = 0; k < sides; ++k) {
            const auto [radius, height] = profile[static_cast<std::size_t>(i)];
            const double a = 2 * pi * k / sides;
            shape.positions.push_back({radius * cosine(a), height, -radius * sine(a)});
            if (i == 0) continue;
            const int right = i * sides + k, left = i * sides + (k + 1) % sides;
            simplices.triangles.push_back({right - sides, left - sides, left});
            simplices.triangles.push_back({right - sides, left, right});
        }
    shape.complex = SimplicialComplex(static_cast<int>(shape.positions.size()), simplices);
    return shape;
}

}  // namespace plait
