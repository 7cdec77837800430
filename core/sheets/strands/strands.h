// Strands: links strung end to end, so that each strand can be solved at once. In woven cloth they
// are its threads; in any other mesh, the straightest ways through it.
#pragma once

#include "../../numbers/math.h"

#include <span>
#include <vector>

namespace plait {

struct Strand {
    std::vector<int> vertices;  // one more than links, none twice
    std::vector<int> links;     // their places in what was given
    int color = 0;              // strands of a colour share no vertex
};

// Every link (two vertices each) in one strand. At each vertex links go on in one another in pairs
// within 60 degrees of straight by the positions `rest`, as many and as straight as can be.
std::vector<Strand> strandsOf(std::span<const int> links, std::span<const Vec<double>> rest);

// What is left of strands when some links are gone (by link): each part of one goes on in its
// colour, which the whole had to itself. Links are numbered anew, as those left are in order.
std::vector<Strand> partsOf(std::span<const Strand> strands, const std::vector<bool>& gone);

}  // namespace plait
