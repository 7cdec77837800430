// How far a run is, on stderr: a bar on a terminal, a line every few seconds in a pipe.
#pragma once

#include <chrono>
#include <string>

namespace plait {

class Progress {
public:
    // `begun` of the `total` were done before; `unit` says of what.
    Progress(std::string name, int begun, int total, bool quiet, std::string unit = "frames");
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // `done` frames are; shows it if it is time to.
    void show(int done);
    // While this lives, frameSolved() on this thread shows one more: for loops that know of none.
    void follow();

private:
    using Clock = std::chrono::steady_clock;
    enum class Form { none, bar, lines };

    std::string name_, unit_;
    int begun_, total_;
    Form form_;
    Clock::time_point start_ = Clock::now(), shown_ = start_;
    bool drawn_ = false;
};

// A frame was solved. Throws Interrupted, if anything is followed.
void frameSolved();

}  // namespace plait
