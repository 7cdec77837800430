#include "interrupt.h"

#include "errors.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

namespace plait {
namespace {

volatile std::sig_atomic_t signalled = 0;
std::atomic<int> endsAtOnce = 0;

void note(int) {
    if (endsAtOnce > 0) endInterrupted();
    signalled = 1;
}

}  // namespace

void catchInterrupts() {
    struct sigaction action{};
    action.sa_handler = note;
    // The second time it is the system's own.
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

bool interrupted() { return signalled != 0; }

void stopIfInterrupted() {
    if (interrupted()) throw Interrupted("interrupted");
}

// Also within a signal.
void endInterrupted() {
    constexpr char line[] = "plait: interrupted\n";
    // Nothing is left to do about a line that cannot be written.
    [[maybe_unused]] const auto written = write(STDERR_FILENO, line, sizeof line - 1);
    _exit(exitInterrupted);
}

EndsAtOnce::EndsAtOnce() {
    stopIfInterrupted();
    ++endsAtOnce;
}

EndsAtOnce::~EndsAtOnce() { --endsAtOnce; }

}  // namespace plait
