#include "film.h"

#include <cmath>

namespace plait {

Film::Film(const Run& run, int first, int last)
    : cut_(!run.scene.view.takes.empty()),
      rate_(cut_ ? FrameRate{} : run.scene.options.schedule.frameRate),
      first_(cut_ ? 1 : first) {
    if (!cut_)
        for (int frame = first; frame <= last; ++frame) pictures_.push_back({frame, nullptr});
    for (const Take& take : run.scene.view.takes) {
        const double step = rate_.seconds / (rate_.frames * take.slow);
        const auto count = std::lround((take.to - take.from) / step);
        for (long i = 0; i < count; ++i) {
            const double time = take.from + static_cast<double>(i + 1) * step;
            const int frame = static_cast<int>(std::lround(time * run.frameRate()));
            if (frame >= first && frame <= last) pictures_.push_back({frame, &take});
        }
    }
}

std::vector<int> Film::showing(int frame) const {
    std::vector<int> numbers;
    for (int i = 0; i < size(); ++i)
        if (pictures_[i].frame == frame) numbers.push_back(first_ + i);
    return numbers;
}

}  // namespace plait
