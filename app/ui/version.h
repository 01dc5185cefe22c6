// app/ui/version.h: which program this is.
#pragma once

namespace sinew::app {

/// Version and commit: "0.2.0 (4bbcc04d41e0)"; the commit ends in "-dirty" if the tree was changed, and is "unknown"
/// outside git.
[[nodiscard]] const char* programVersion();

}  // namespace sinew::app
