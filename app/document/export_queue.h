// app/document/export_queue.h: exports and pictures in the background, one after the other.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/export_kinds.h"
#include "sinew/files/progress.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// Pictures are drawn by `sinew render` in a process of its own, independent of what the editor draws.

/// A temporary folder that is removed with its contents.
class JobFolder {
 public:
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
  std::shared_ptr<const JobFolder> folder;
  std::string program;                 ///< sinew
  std::string input;                   ///< Name of the rig in the folder.
  std::vector<std::string> arguments;  ///< Of `render`, without the input, -o and --progress.
};

/// Writes the file atomically. Error: it failed or was canceled (kCanceled); there is no file then.
[[nodiscard]] Result<void> runPictureJob(const PictureJob& job, const std::filesystem::path& file,
                                         const ExportProgress& progress);

/// Owns all that its export needs: later edits do not change it.
struct ExportOrder {
  const ExportKind* kind = nullptr;
  ExportSource source;
  ExportSettings settings;
  std::filesystem::path file;
  std::optional<PictureJob> pictures{};  ///< Draw pictures; kind and source are unused.
};

/// An unfinished export.
struct ExportStand {
  std::filesystem::path file;
  double share = 0.0;  ///< Done, 0..1.
  bool running = false;
  bool canceled = false;  ///< About to stop.
};

struct ExportOutcome {
  std::filesystem::path file;
  Result<ExportReport> result;  ///< For pictures only success or error.
  bool canceled = false;        ///< The result is an error too.
  ExportOrder order{};
};

/// Call from one thread; only the destructor waits. One export runs at a time, on a thread; takeDone() starts the next.
class ExportQueue {
 public:
  ExportQueue();
  ~ExportQueue();  ///< Cancels everything.
  ExportQueue(ExportQueue&&) noexcept;
  ExportQueue& operator=(ExportQueue&&) noexcept;

  void add(ExportOrder order);
  void cancel();                                          ///< Cancels the running export.
  [[nodiscard]] std::vector<ExportStand> stands() const;  ///< The running export, then the waiting ones in order.
  [[nodiscard]] bool empty() const;
  [[nodiscard]] std::vector<ExportOutcome> takeDone();  ///< Exports that ended since the last call.

 private:
  struct Run;
  void startNext();

  std::unique_ptr<Run> run_;  ///< Null: nothing waits either.
  std::vector<ExportOrder> waiting_;
  std::vector<ExportOutcome> done_;  ///< Not taken yet.
};

}  // namespace sinew::app
