#include "ballerina.h"

#include "dance.h"
#include "skin.h"

namespace plait {

static_assert(Ballerina::seconds == dancer::danceLength);
static_assert(Ballerina::takeOff == dancer::takeOff && Ballerina::landing == dancer::landing);

struct Ballerina::Figure {
    dancer::Surface surface = dancer::bodySurface();
    dancer::Skin skin{surface.positions};
    Shape shape;
    std::vector<BodyPart> parts;
};

namespace {

BodyPart partOf(const Vec<double>& x) {
    const Vec<double> p = x.x < 0 ? dancer::mirrored(x) : x;
    constexpr double rounding = 1e-4;  // m, of vertices that lie on an edge of hair or clothes
    if (p.y > 1.49 && dancer::hair(p) > -rounding) return BodyPart::hair;
    if (p.y > 1.46 && p.x < 0.12) return BodyPart::head;
    if (p.x > 0.655) return BodyPart::hand;
    if (p.y > 1.1 && p.x > 0.16) return BodyPart::arm;
    if (p.y < 0.2 && dancer::shoe(p) > -rounding) return BodyPart::shoe;
    if (p.y < 0.78) return BodyPart::leg;
    return dancer::bodice(p) > -rounding ? BodyPart::torso : BodyPart::chest;
}

}  // namespace

Ballerina::Ballerina() {
    static const std::shared_ptr<const Figure> made = [] {
        auto figure = std::make_shared<Figure>();
        const dancer::Surface& surface = figure->surface;
        figure->shape.positions = surface.positions;
        Simplices simplices;
        simplices.triangles = surface.triangles;
        figure->shape.complex =
            SimplicialComplex(static_cast<int>(surface.positions.size()), simplices);
        for (const Vec<double>& p : surface.positions) figure->parts.push_back(partOf(p));
        return figure;
    }();
    figure_ = made;
}

const Shape& Ballerina::shape() const { return figure_->shape; }
const std::vector<std::array<int, 3>>& Ballerina::triangles() const {
    return figure_->surface.triangles;
}
const std::vector<BodyPart>& Ballerina::parts() const { return figure_->parts; }

std::vector<Vec<double>> Ballerina::positions(double t) const {
    return figure_->skin.positions(dancer::pose(dancer::controls(t)));
}

Frame Ballerina::pelvis(double t) const {
    const dancer::Posed posed = dancer::pose(dancer::controls(t));
    return {.origin = posed.hips, .across = posed.pelvis.x, .up = posed.pelvis.y};
}

Frame Ballerina::waist(double t) const {
    const dancer::Posed posed = dancer::pose(dancer::controls(t));
    const dancer::Axes lumbar = posed.lumbar;
    return {.origin = posed.waist + lumbar * Vec<double>{0, 0, 0.006},
            .across = lumbar.x,
            .up = lumbar.y};
}

Vec<double> Ballerina::centerOfMass(double t) const {
    return dancer::pose(dancer::controls(t)).balance;
}

std::array<Ballerina::Foot, 2> Ballerina::feet(double t) const {
    const dancer::Controls controls = dancer::controls(t);
    std::array<Foot, 2> feet{};
    for (std::size_t side = 0; side < 2; ++side) {
        const dancer::LegControl& leg = controls.legs[side];
        feet[side] = {.planted = leg.planted, .rise = leg.rise, .tip = leg.tip};
    }
    return feet;
}

}  // namespace plait
