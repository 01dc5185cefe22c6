/* core/include/sinew/geometry/same_version.h: headers link only with the library of their own version. For C and C++.
 */
#pragma once

#include "sinew/geometry/version.h"

/* Every file that includes a header of Sinew asks for a symbol that the library of that version alone defines
 * (core/geometry/same_version.cpp). The linker names what is missing: sinew_library_of_version_0_1_0. */
#define SINEW_LIBRARY_NAME_(major, minor, patch) sinew_library_of_version_##major##_##minor##_##patch
#define SINEW_LIBRARY_NAME(major, minor, patch) SINEW_LIBRARY_NAME_(major, minor, patch)
#define SINEW_LIBRARY SINEW_LIBRARY_NAME(SINEW_VERSION_MAJOR, SINEW_VERSION_MINOR, SINEW_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif
/* Hidden: a shared library must have its own too, and does not lend it to others. */
extern const char SINEW_LIBRARY __attribute__((visibility("hidden")));
#ifdef __cplusplus
}
#endif

/* Kept by compilers and linkers although nothing reads it. */
#if defined(__has_attribute)
#if __has_attribute(retain)
__attribute__((retain))
#endif
#endif
__attribute__((used)) static const char* const sinewLibraryOfThisFile = &SINEW_LIBRARY;
