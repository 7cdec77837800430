// What a heap of shards costs as it falls and at rest, and how still it is. Prints, never judges.
#pragma once

namespace plait {

// Returns an exit status.
int benchPile(int threads);

}  // namespace plait
