// Matter that meets matter, and on which terms. README.md tells how it is done.
#pragma once

#include "../complex/shapes.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace plait {

// Which simplices of one surface meet each other (M 4.5.1) [SF1]; those of two surfaces all do.
enum class Self {
    none,
    vertex,      // points with points, as balls: fastest, where balls leave no hole
    vertexFace,  // points with triangles, not edges with edges: for what is closed
    full
};

// All simplices of the complex whose vertices are among these.
struct Surface {
    Range vertices;
    // m, from a simplex to its skin: two stay the sum of theirs apart. None: 1 mm, or an eighth of
    // the mean edge where that is less, so that neighbours do not touch as they rest.
    std::optional<double> thickness{};
    std::vector<double> radii{};  // m, one a vertex in place of the thickness: particles [CC25]
    // Of an open curve with a flat section: half its width (m) along the director beside each edge,
    // in the order of edges, as `Rod` has them. It meets others as an ellipse, twice the thickness
    // across, and does not bounce.
    Range directors{};
    double halfWidth = 0;
    // Of a pair the mean counts, at most 1 (M 5.5). Below 0 it adds energy, and is warned of.
    double staticFriction = 0.1;   // tangent of the steepest slope on which something rests
    double dynamicFriction = 0.1;  // force along the surface over force across, while sliding
    double restitution = 0;  // speed apart over speed of approach, 0 to 1 (S 7); of a pair the mean
    double stickiness = 0;   // N a contact holds before it tears off; of a pair the mean
    double pointMass = 1;    // kg, of each vertex in a contact, where masses are legacy
    // Of two layers, the lower one yields less (LY2): its mass counts `layerShock` times.
    int layer = 0;
    // 0, or 1 a vertex that takes no part in contacts with its own surface, or with others, and
    // neither does any simplex that it is a corner of (V) [FH9]; empty: all do.
    std::vector<std::uint8_t> disableSelf{}, disableExternal{};
    Self self = Self::full;
    double selfWidth = 1;  // times the thickness, where it meets itself [SF4]
    // Others of the same call of meet(), by place, that it lets through and they it (M 3.1.3).
    std::vector<int> ignores{};
};

// Whether two have met on their way, or only how near they are where they have got to: then what is
// fast goes through what is thin.
enum class Detection { path, end };

// What a vertex weighs in a contact.
enum class ContactMass {
    physical,  // what it stands for
    legacy     // its surface's pointMass, however small a part it is: a finer mesh seems heavier,
               // and what it takes from others is not what it gets (M 5.2) [CC26]
};

struct ContactOptions {
    std::string name = "contacts";
    Detection detection = Detection::path;
    ContactMass mass = ContactMass::physical;
    int order = 0;
    int importance = 24;
    double layerShock = 1;                       // 1: layers are alike
    double selfFriction = 1, otherFriction = 1;  // times the friction of what meets its own
                                                 // surface, of what meets others (V); for meet()
    double recovery = 0.5;  // m/s: how fast what began too near may part; slower than it would fly
    double bounceThreshold = 0;  // m/s: what approaches more slowly, or at less than 2 g h, does
                                 // not bounce
    // Where simplices pierce each other as a substep begins, the corners of both are left out of
    // contacts in it: with other surfaces [FH3], or with their own, which helps to draw apart what
    // was pinched, and may make it worse (M 4.5.3) [FH5]. M pushes the former out as well: that is
    // pushOut (push_out.h).
    bool trapped = false, selfTrapped = false;
    // The same, and what crosses after all passes; until it is free, and what is beside it (V)
    // [FH7, FH8].
    bool disableFailed = false;
    double displacementLimit = 0;  // m that one contact moves a vertex in a substep at most,
                                   // across; 0: no limit [CC20]
    double margin = 0;  // m off the way a vertex was foreseen to go until pairs are looked for
                        // again; 0: a fifth of the mean edge, at least half the largest thickness
};

struct World;

// Adds the set of all contacts of these surfaces with each other and, where they ask for it, with
// themselves: point and triangle, edge and edge, and particles and curves with all. Call it when
// all matter has been added and pinned. Throws std::invalid_argument, naming the value, for one out
// of range.
void meet(World& world, std::vector<Surface> surfaces, const ContactOptions& options = {});

}  // namespace plait
