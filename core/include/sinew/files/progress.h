// core/include/sinew/files/progress.h: progress of long exports, and cancelling them.
#pragma once

#include <functional>
#include <string_view>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Called on the exporting thread with the finished fraction, 0..1, never decreasing. False cancels: nothing is
/// written, and the export returns an error with the reason kCanceled. May be empty.
using ExportProgress = std::function<bool(double share)>;

inline constexpr std::string_view kCanceled = "cancelled";

}  // namespace sinew
