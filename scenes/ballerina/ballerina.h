// A ballerina who dances: plié, relevé, pirouettes, arabesque, a leap, a last pose. One smooth
// closed surface of our own shape that moves over the floor y = 0, which carries her feet. Metres
// and seconds, y up; she starts at the origin, faces z, and leaps along x.
#pragma once

#include <plait/complex/shapes.h>

#include <array>
#include <memory>
#include <vector>

namespace plait {

// The torso ends at the neckline of a bodice; above it, bare, is the chest.
enum class BodyPart { torso, chest, head, hair, arm, hand, leg, shoe };

class Ballerina {
public:
    // s, of the dance; before and after it she stands.
    static constexpr double seconds = 14;
    // s, between which no foot is on the floor and her centre of mass flies.
    static constexpr double takeOff = 10.15, landing = 10.65;

    Ballerina();

    // Her skin at rest, triangles counter-clockwise from outside.
    const Shape& shape() const;
    const std::vector<std::array<int, 3>>& triangles() const;
    // By vertex.
    const std::vector<BodyPart>& parts() const;

    // At a time, with two continuous derivatives; the same to the bit whenever it is asked.
    std::vector<Vec<double>> positions(double t) const;

    // Her frames: across to her left, up along the spine.
    Frame pelvis(double t) const;  // between the hips
    Frame waist(double t) const;   // in the middle of its ring, which is about an ellipse:
    static constexpr double waistWidth = 0.21, waistDepth = 0.136;  // m

    Vec<double> centerOfMass(double t) const;
    struct Foot {
        double planted;   // 1: it stands on the floor, and carries weight or could
        double rise;      // 0: on the sole, 1: on the tip
        Vec<double> tip;  // where it stands when on the tip; y is its height over the floor
    };
    std::array<Foot, 2> feet(double t) const;  // left, right

private:
    struct Figure;
    std::shared_ptr<const Figure> figure_;  // made once
};

}  // namespace plait
