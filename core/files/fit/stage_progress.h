// core/files/fit/stage_progress.h: progress through the stages of one export.
#pragma once

#include <algorithm>

#include "sinew/files/progress.h"

namespace sinew::exporting {

/// Thrown out of an export that its caller canceled.
struct Canceled {};

class StageProgress {
 public:
  explicit StageProgress(ExportProgress tell) : tell_(std::move(tell)) {}

  /// The next stage, and what share of all the work it is.
  void begin(double share) {
    before_ += stage_;
    stage_ = share;
    tell(0.0);
  }
  /// How much of the stage is done, 0..1. Throws Canceled.
  void tell(double part) const {
    if (tell_ && !tell_(std::min(1.0, before_ + stage_ * part))) throw Canceled{};
  }

 private:
  ExportProgress tell_;
  double before_ = 0.0;
  double stage_ = 0.0;
};

}  // namespace sinew::exporting
