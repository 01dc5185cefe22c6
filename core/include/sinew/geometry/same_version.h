/* core/include/sinew/geometry/same_version.h: headers only link with the library of their version. For C and C++. */
#pragma once

#include "sinew/geometry/version.h"

/* Every file that includes a header of Sinew needs a symbol that only the library of that version defines
 * (core/geometry/same_version.cpp). The linker names the missing one: sinew_library_of_version_0_1_0. */
#define SINEW_LIBRARY_NAME_(major, minor, patch) sinew_library_of_version_##major##_##minor##_##patch
#define SINEW_LIBRARY_NAME(major, minor, patch) SINEW_LIBRARY_NAME_(major, minor, patch)
#define SINEW_LIBRARY SINEW_LIBRARY_NAME(SINEW_VERSION_MAJOR, SINEW_VERSION_MINOR, SINEW_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif
/* Hidden, so that every shared library needs its own. */
extern const char SINEW_LIBRARY __attribute__((visibility("hidden")));
#ifdef __cplusplus
}
#endif

/* Compilers and linkers must keep it although nothing reads it. */
#if defined(__has_attribute)
#if __has_attribute(retain)
__attribute__((retain))
#endif
#endif
__attribute__((used)) static const char* const sinewLibraryOfThisFile = &SINEW_LIBRARY;
