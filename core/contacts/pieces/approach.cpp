#include "approach.h"

#include <cmath>

namespace plait {

bool findMeeting(const Convex& first, const PoseWay& firstWay, const Convex& second,
                 const PoseWay& secondWay, double near, double far, Meeting& meeting) {
    constexpr int steps = 32;
    const double bias = 0.05 * std::fabs(near);
    meeting.part = 0;
    for (int step = 0;; ++step) {
        meeting.first.put(first, firstWay.at(meeting.part));
        meeting.second.put(second, secondWay.at(meeting.part));
        meeting.parting = partingOf(meeting.first, meeting.second, bias);
        const double over = meeting.parting.gap - near;
        if (over <= bias || step == steps) return true;
        if (meeting.part == 1) return meeting.parting.gap <= far;
        const Vec<double>& n = meeting.parting.normal;
        const double closing = firstWay.along(-n, first.radius) + secondWay.along(n, second.radius);
        meeting.part = over < closing * (1 - meeting.part) ? meeting.part + over / closing : 1;
    }
}

}  // namespace plait
