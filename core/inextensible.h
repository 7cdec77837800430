// For programs of one's own: sheets/inextensible.h by a shorter name.
#pragma once

#include "sheets/inextensible.h"
