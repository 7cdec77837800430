// For programs of one's own: numbers/elementary.h by a shorter name.
#pragma once

#include "numbers/elementary.h"
