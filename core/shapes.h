// For programs of one's own: complex/shapes.h by a shorter name.
#pragma once

#include "complex/shapes.h"
