// SIGINT and SIGTERM ask a run to stop, which it does within a second; a second one ends the
// program at once, which `--resume` survives as well.
#pragma once

namespace plait {

void catchInterrupts();
bool interrupted();

// Throws Interrupted if a signal came.
void stopIfInterrupted();

// Ends the program at once, as one that was asked to stop.
[[noreturn]] void endInterrupted();

// While one lives, a signal ends the program at once: where something is built, of which nothing
// could be kept.
class EndsAtOnce {
public:
    EndsAtOnce();
    ~EndsAtOnce();
    EndsAtOnce(const EndsAtOnce&) = delete;
    EndsAtOnce& operator=(const EndsAtOnce&) = delete;
};

}  // namespace plait
