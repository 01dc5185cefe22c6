// core/include/sinew/geometry/version.h: which version a program is compiled against. For C and C++.
#pragma once

#define SINEW_VERSION_MAJOR 0
#define SINEW_VERSION_MINOR 2
#define SINEW_VERSION_PATCH 0
#define SINEW_VERSION_TEXT "0.2.0"
/// To compare with: 10203 is 1.2.3.
#define SINEW_VERSION_NUMBER (10000 * SINEW_VERSION_MAJOR + 100 * SINEW_VERSION_MINOR + SINEW_VERSION_PATCH)
