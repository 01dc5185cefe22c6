// app/command/picture_writer.cpp: a thread for the picture that is written.
#include "app/command/picture_writer.h"

#include <utility>

#include "app/viewport/render/png.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/stopwatch.h"

namespace sinew::app {

Result<void> PictureWriter::write(const std::filesystem::path& file, Image image) {
  if (const Result<void> before = finish(); !before) return before;
  file_ = file;
  writing_ = std::async(std::launch::async, [file, image = std::move(image)]() -> Written {
    Stopwatch watch;
    const Result<std::string> bytes = pngBytes(image);
    if (!bytes) return {Error{file.string(), bytes.error().place, bytes.error().reason}, 0.0};
    Result<void> done = writeFileAtomically(file, bytes.value());
    return {std::move(done), watch.lap()};
  });
  return {};
}

Result<void> PictureWriter::finish() {
  if (!writing_.valid()) return {};
  Written written = writing_.get();
  seconds_ += written.seconds;
  if (written.result) status_ = putResult(file_.string() + '\n');
  return std::move(written.result);
}

}  // namespace sinew::app
