// app/document/picture_job.h: pictures that `sinew render` makes, in a process of its own: whatever the editor draws
// meanwhile, they are the command line's.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sinew/files/progress.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// A folder that goes with all that is in it.
class JobFolder {
 public:
  /// Below the system's folder for temporary files, for this user alone.
  [[nodiscard]] static Result<std::shared_ptr<const JobFolder>> make();
  ~JobFolder();
  JobFolder(const JobFolder&) = delete;
  JobFolder& operator=(const JobFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit JobFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

struct PictureJob {
  std::shared_ptr<const JobFolder> folder;  ///< Has `input`.
  std::string program;                      ///< sinew
  std::string input;                        ///< Name of the rig in the folder.
  std::vector<std::string> arguments;       ///< Of `render`, without the input, -o and --progress.
};

/// The file appears whole, or, on an Error or when it is canceled (kCanceled), not at all.
[[nodiscard]] Result<void> runPictureJob(const PictureJob& job, const std::filesystem::path& file,
                                         const ExportProgress& progress);

}  // namespace sinew::app
