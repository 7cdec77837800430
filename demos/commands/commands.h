// Every command of plait, each in a file of its own.
#pragma once

#include "demos/tools/arguments.h"

namespace plait {

Command listCommand();
Command describeCommand();
Command runCommand();
Command renderCommand();
Command checkCommand();
Command compareCommand();
Command benchCommand();
Command ablateCommand();
Command tuneCommand();
Command stabilityCommand();
Command studyCommand();
Command catalogueCommand();

// Version, compiler, kernels and Mesa of this program here, a line each.
std::string versionText();

}  // namespace plait
