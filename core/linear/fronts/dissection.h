// Nested dissection (George 1973) by geometric bisection: an order of elimination that fills in
// little on anything that is flat or thin at rest.
#pragma once

#include "../../complex/csr.h"
#include "../../numbers/math.h"

#include <span>
#include <vector>

namespace plait {

// Vertices eliminated together: positions [begin, end) of the order. What lies between two parts is
// eliminated after both.
struct Part {
    int begin, end;
    int parent;  // a later part, -1 for none: all that the part couples with later is in ancestors
};

struct Dissection {
    std::vector<int> order;   // vertices, as they are eliminated
    std::vector<Part> parts;  // every subtree is a run that its root ends
};

// Of the given vertices, in ascending order. `rest` (m) and `neighbours` by vertex; parts of at
// most `leaf` vertices, at least 1, are not cut. The order does not depend on the compiler.
Dissection dissect(std::span<const Vec<double>> rest, const Csr& neighbours,
                   std::vector<int> vertices, int leaf);

}  // namespace plait
