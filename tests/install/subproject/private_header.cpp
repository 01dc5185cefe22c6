// tests/install/subproject/private_header.cpp: what it must not find.
#include "core/geometry/at.h"
