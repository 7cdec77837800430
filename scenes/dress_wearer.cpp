#include "dress_wearer.h"

#include "ballerina/ballerina.h"

#include <plait/files/mesh_sequence.h>
#include <plait/inspection/inspect.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace plait {
namespace {

// Bare skin, hair, tights and satin shoes; her bodice is of the skirt's silk.
Look lookOf(const Ballerina& dancer) {
    Look look;
    look.material = Material::skin;
    for (const BodyPart part : dancer.parts()) {
        std::array color{0.72, 0.45, 0.33};
        double satin = 0;
        switch (part) {
            case BodyPart::hair:
                color = {0.03, 0.018, 0.012};
                break;
            case BodyPart::leg:
                color = {0.80, 0.62, 0.52};
                break;
            case BodyPart::shoe:
                color = {0.75, 0.33, 0.27}, satin = 1;
                break;
            case BodyPart::torso:
                color = vermilion, satin = 1;
                break;
            default:
                break;
        }
        look.colors.push_back(color);
        look.satin.push_back(satin);
    }
    return look;
}

// What no cloth could follow: its first mesh stands elsewhere, or frames are missing.
void warnOfJumps(Wearer& wearer, const MeshSequence& sequence, const InspectedMesh& mesh,
                 double rate) {
    constexpr double fastest = 25;  // m/s: a foot kicks at 20
    std::vector<Vec<double>> from(sequence.first().positions.size()), to = from;
    for (int i = 0; i + 1 < sequence.count(); ++i) {
        sequence(i / rate, from);
        sequence((i + 1) / rate, to);
        double most = 0;
        for (std::size_t v = 0; v < to.size(); ++v) most = std::max(most, length(to[v] - from[v]));
        if (most * rate <= fastest) continue;
        wearer.warnings.push_back(mesh.told(
            "mesh " + std::to_string(i + 2) + " of " + std::to_string(sequence.count()) + " is " +
            std::to_string(most) + " m off the one before: contacts may fail there"));
        return;
    }
}

}  // namespace

Wearer ballerina() {
    const Ballerina dancer;
    Shape shape = dancer.shape();
    shape.positions = dancer.positions(0);
    return {.shape = std::move(shape),
            .surface = {dancer.triangles(), [dancer](double t) { return dancer.positions(t); }},
            .waist = dancer.waist(0),
            .followed = [dancer](double t) { return dancer.waist(t).origin; },
            .seconds = Ballerina::seconds,
            .look = lookOf(dancer)};
}

Wearer wearerOf(const Knobs& knobs) {
    const MeshSequence sequence(knobs.text("body"), {.frameRate = knobs.number("rate")});
    const InspectedMesh mesh = inspect(sequence.first(), sequence.file(),
                                       {.solid = true, .least = 0.6, .usual = 1.7, .most = 3.5});
    Wearer wearer;
    wearer.shape = mesh.shape;
    wearer.warnings = mesh.warnings;
    wearer.seconds = sequence.end();
    for (int t = 0; t < wearer.shape.complex.count(2); ++t)
        wearer.surface.triangles.push_back(wearer.shape.complex.triangle(t));
    wearer.surface.positions = [sequence, vertices = mesh.vertices](double t) {
        std::vector<Vec<double>> all(sequence.first().positions.size()), positions;
        sequence(t, all);
        for (const int v : vertices) positions.push_back(all[v]);
        return positions;
    };
    wearer.followed = [at = wearer.surface.positions](double t) {
        const std::vector<Vec<double>> positions = at(t);
        Vec<double> sum{};
        for (const Vec<double>& x : positions) sum += x;
        return divide(1.0, static_cast<double>(positions.size())) * sum;
    };
    wearer.waist.origin = wearer.followed(0);
    const double waist = wearer.waist.origin.y = knobs.number("waist");
    const auto [low, high] =
        std::ranges::minmax(wearer.shape.positions, {}, [](const Vec<double>& x) { return x.y; });
    if (!(low.y < waist && waist < high.y))
        throw std::invalid_argument("waist: it must be on the body, which reaches from " +
                                    std::to_string(low.y) + " to " + std::to_string(high.y) + " m");
    warnOfJumps(wearer, sequence, mesh, knobs.number("rate"));
    if (std::fabs(low.y) > 0.05)
        wearer.warnings.push_back(
            mesh.told("it stands on y = " + std::to_string(low.y) + " m, and the floor is y = 0"));
    wearer.look.material = Material::matte;
    wearer.look.color = {0.254, 0.216, 0.188};
    wearer.staging =
        stagingOf(wearer.surface.positions, wearer.followed, wearer.seconds, sequence.count());
    return wearer;
}

}  // namespace plait
