// core/geometry/same_version.cpp: the symbol that headers of this version need (sinew/geometry/same_version.h).
#include "sinew/geometry/same_version.h"

const char SINEW_LIBRARY = 0;

/// One name in all versions: two of them cannot link into one program, only into separate shared libraries.
extern "C" __attribute__((visibility("hidden"))) const char sinew_only_one_version_in_a_program = 0;
