// How someone who moves is to be seen: as tall as the picture, whoever it is and wherever.
#pragma once

#include "../view.h"

#include <array>
#include <functional>
#include <vector>

namespace plait {

// What the picture must hold; as it is, the ballerina. Lengths (m) are of all poses together.
struct Staging {
    Vec<double> place{0, 0, 0};  // on the floor, where the way begins
    double height = 1.85;        // above the floor, but for arms that are raised
    double reach = 1.1;          // level, from the point that is followed
    // Parts of the way, level, that eye and ground go.
    double eye = 0.7, ground = 0;
    // By time (s), of the width of a picture of 16:9: narrower ones come closer where they can.
    std::vector<std::array<double, 2>> across{
        {0, 0.36}, {5, 0.36}, {7.2, 0.5}, {10.9, 0.5}, {13, 0.36}};
};

// Of anybody, from so many poses between time 0 and `seconds`; positions (m) by time (s).
Staging stagingOf(const std::function<std::vector<Vec<double>>(double)>& positions,
                  const std::function<Vec<double>(double)>& followed, double seconds, int poses);

// In a theatre, where the camera follows the point; every object looks the same.
View viewOf(const std::vector<Range>& objects, const Staging& staging,
            const std::function<Vec<double>(double)>& followed);

}  // namespace plait
