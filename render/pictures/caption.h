// The strip along the bottom of every clip.
#pragma once

#include "picture.h"

#include <string>

namespace plait {

struct Caption {
    std::string title;    // left
    std::string numbers;  // right, digits of equal width; parts between " · " may stand in lines
    double fade = 1;      // 0: not there, to 1
};

// The look book's strip: 64 pixels of 720, and everything in it scaled likewise. Text that is too
// long for the width is set smaller; where that would be much, the numbers go below the title.
void drawCaption(Picture& picture, const Caption& caption);

// A line above, at the left; nothing where there are no words.
void drawHeadline(Picture& picture, const std::string& words);

}  // namespace plait
