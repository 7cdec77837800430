#include "views.h"

#include "constraints/constants.h"
#include "elementary.h"

namespace plait {

Look lookOf(const Range& object, Material material, double radius) {
    Look look{.object = object, .material = material, .radius = radius};
    if (material == Material::brass) look.color = {0.584, 0.305, 0.050};
    if (material == Material::steel) look.color = {0.397, 0.445, 0.491};
    return look;
}

View viewOf(const std::vector<Range>& objects, const Vec<double>& middle, double size,
            Material material, const Vec<double>& from) {
    View view;
    view.cameras = {{.time = 0,
                     .eye = middle + size * from,
                     .target = middle - size * Vec<double>{0, 0.05, 0},
                     .focalLength = 40}};
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
        view.cameras.push_back(
            {t, start.eye + t * velocity, start.target + t * velocity, start.focalLength});
    view.ground = false;
    // So far away that its direction stays.
    view.glowCenter += 1e6 * (start.target - start.eye);
}

void addPeg(View& view, const Vec<double>& front, double radius) {
    constexpr std::array slate{0.098, 0.144, 0.195};
    const Vec<double> back = front - Vec<double>{0, 0, 0.2};
    const Shape side =
        tube({.segments = 64, .radius = radius, .height = 0.2}, {.origin = back, .up = {0, 0, 1}});
    view.props.push_back({side, Material::matte, slate});
    view.props.push_back(
        {disc({.rings = 8, .radius = radius}, {.origin = front}), Material::matte, slate});
}

Shape turned(const std::vector<std::array<double, 2>>& profile) {
    constexpr int sides = 48;
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
