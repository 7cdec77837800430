// What meeting each other costs a scene, beside what it costs without. Prints, never judges.
#pragma once

namespace plait {

// The first frames of the flag, the dress and a sheet on a ball with contacts and without, in
// turns: milliseconds a frame (median and worst) and constraints swept. Returns an exit status.
int benchContacts(int threads);

}  // namespace plait
