// core/include/sinew/files/progress.h: how far a long export is, and how its caller ends it.
#pragma once

#include <functional>
#include <string_view>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Called on the exporting thread with the share that is done, 0..1, never falling. False cancels: nothing is written,
/// and the export returns an error whose reason is kCanceled. Empty: nobody wants to know.
using ExportProgress = std::function<bool(double share)>;

inline constexpr std::string_view kCanceled = "cancelled";

}  // namespace sinew
