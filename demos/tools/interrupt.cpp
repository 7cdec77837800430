#include "interrupt.h"

#include "errors.h"

#include <csignal>

namespace plait {
namespace {

volatile std::sig_atomic_t signalled = 0;

void note(int) { signalled = 1; }

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

}  // namespace plait
