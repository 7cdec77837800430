// Sets of every kind in constraints/kinds.h, so that no other file compiles them again.
#include "constrain.h"

namespace plait {

template void World::constrain(Rows<Stretch>, SetOptions);
template void World::constrain(Rows<Angle>, SetOptions);
template void World::constrain(Rows<Shear>, SetOptions);
template void World::constrain(Rows<Bend>, SetOptions);
template void World::constrain(Rows<Attach>, SetOptions);
template void World::constrain(Rows<Tether>, SetOptions);
template void World::constrain(Rows<PlaneContact>, SetOptions);
template void World::constrain(Rows<SphereContact>, SetOptions);
template void World::constrain(Rows<CapsuleContact>, SetOptions);

}  // namespace plait
