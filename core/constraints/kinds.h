// Every kind the core knows: one line here, and a kind has kernels for each instruction set, each
// lane width and both precisions, and all of the tests of test_kinds.cpp.
#pragma once

#include "angle.h"
#include "attach.h"
#include "bend.h"
#include "contact.h"
#include "shear.h"
#include "stretch.h"
#include "tether.h"
#include "volume.h"

namespace plait {
inline namespace PLAIT_ISA {

template <class... Kind>
struct KindList {};

using Kinds = KindList<Stretch, Angle, Shear, Bend, Attach, Tether, PlaneContact, SphereContact,
                       CapsuleContact, Volume>;

}  // namespace PLAIT_ISA
}  // namespace plait
