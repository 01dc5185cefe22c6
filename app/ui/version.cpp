// app/ui/version.cpp: the only file that is compiled again when the commit changes.

#include "app/ui/version.h"

#include "sinew_version.h"

namespace sinew::app {

const char* programVersion() { return SINEW_VERSION " (" SINEW_COMMIT ")"; }

}  // namespace sinew::app
