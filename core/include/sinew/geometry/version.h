// core/include/sinew/geometry/version.h: the version of the headers. For C and C++.
#pragma once

#define SINEW_VERSION_MAJOR 0
#define SINEW_VERSION_MINOR 2
#define SINEW_VERSION_PATCH 0
#define SINEW_VERSION_TEXT "0.2.0"
/// For comparisons: 10203 is 1.2.3.
#define SINEW_VERSION_NUMBER (10000 * SINEW_VERSION_MAJOR + 100 * SINEW_VERSION_MINOR + SINEW_VERSION_PATCH)
