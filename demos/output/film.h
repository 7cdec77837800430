// Which frames of a run its film shows, in which order: all of them, or the takes of its view.
#pragma once

#include "demos/runs/settings.h"

#include <vector>

namespace plait {

class Film {
public:
    // Of the frames `first` to `last` of the run, which must live as long.
    Film(const Run& run, int first, int last);

    struct Picture {
        int frame;         // of the run
        const Take* take;  // none: the run as it is
    };

    bool isCut() const { return cut_; }
    FrameRate rate() const { return rate_; }
    int size() const { return static_cast<int>(pictures_.size()); }
    // The number of its first picture.
    int first() const { return first_; }
    // By number.
    const Picture& picture(int number) const { return pictures_[number - first_]; }
    // The numbers of the pictures that show this frame.
    std::vector<int> showing(int frame) const;

private:
    bool cut_;
    FrameRate rate_;
    int first_;
    std::vector<Picture> pictures_;
};

}  // namespace plait
