// core/geometry/same_version.cpp: what headers of this version ask for (sinew/geometry/same_version.h).
#include "sinew/geometry/same_version.h"

const char SINEW_LIBRARY = 0;

/// Has the same name in all versions: two of them do not link into one program, but each into a shared library.
extern "C" __attribute__((visibility("hidden"))) const char sinew_only_one_version_in_a_program = 0;
