// SIGINT and SIGTERM ask a run to stop between two frames; a second one ends the program at once,
// which `--resume` survives as well.
#pragma once

namespace plait {

void catchInterrupts();
bool interrupted();

// Throws Interrupted if a signal came.
void stopIfInterrupted();

}  // namespace plait
