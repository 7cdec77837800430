#include "staging.h"

#include "views.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plait {

Staging stagingOf(const std::function<std::vector<Vec<double>>(double)>& positions,
                  const std::function<Vec<double>(double)>& followed, double seconds, int poses) {
    double low = std::numeric_limits<double>::infinity(), high = -low, reach = 0;
    for (int i = 0; i < poses; ++i) {
        const double t = seconds * i / std::max(poses - 1, 1);
        const Vec<double> middle = followed(t);
        for (const Vec<double>& x : positions(t)) {
            low = std::min(low, x.y);
            high = std::max(high, x.y);
            reach = std::max(reach, std::hypot(x.x - middle.x, x.z - middle.z));
        }
    }
    const Vec<double> start = followed(0);
    return {.place = {start.x, low, start.z},
            .height = high - low,
            .reach = reach,
            .eye = 1,
            .ground = 1,
            .across = {{0, 0.5}}};
}

View viewOf(const std::vector<Range>& objects, const Staging& staging,
            const std::function<Vec<double>(double)>& followed) {
    const Staging ballerina;
    const double wide = staging.reach / ballerina.reach;
    const double scale = std::max(staging.height / ballerina.height, wide);
    const double size = 2.1 * scale;  // m, of what is to be seen
    View view = viewOf(objects, staging.place + Vec<double>{0, 0.88 * scale, 0}, size,
                       Material::silk, {0.5, 0.12, 2.5});
    Camera camera = view.cameras[0];
    view.cameras.clear();
    for (const auto& [time, across] : staging.across) {
        camera.time = time;
        camera.across = across * wide / scale;
        view.cameras.push_back(camera);
    }
    view.groundHeight = staging.place.y;
    view.groundSize = size;
    view.stage = theatre(size);
    view.follow = {.point = followed,
                   .home = followed(0),
                   .eye = {staging.eye, 0.2, staging.eye},
                   .ground = staging.ground};
    return view;
}

}  // namespace plait
