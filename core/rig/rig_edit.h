// core/rig/rig_edit.h: the public edits under the name by which core and app include them.
#pragma once

#include "sinew/rig/rig_edit.h"  // IWYU pragma: export
