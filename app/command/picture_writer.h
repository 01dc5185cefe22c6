// app/command/picture_writer.h: .png files, written beside the drawing of the next one.
#pragma once

#include <filesystem>
#include <future>

#include "app/command/console.h"
#include "app/viewport/render/viewport.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// One at a time, in order.
class PictureWriter {
 public:
  /// First finishes the picture before. @return its failure, if it failed.
  Result<void> write(const std::filesystem::path& file, Image image);
  /// Waits for the last picture, and names its file among the verb's results.
  Result<void> finish();
  [[nodiscard]] double seconds() const { return seconds_; }
  /// kDone, or what became of the standard output.
  [[nodiscard]] int status() const { return status_; }

 private:
  struct Written {
    Result<void> result;
    double seconds = 0.0;
  };
  std::filesystem::path file_;
  std::future<Written> writing_;
  double seconds_ = 0.0;
  int status_ = kDone;
};

}  // namespace sinew::app
