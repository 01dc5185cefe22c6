// app/document/export_queue.h: exports in the background, one after the other.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/export_kinds.h"
#include "app/document/picture_job.h"

namespace sinew::app {

/// Owns all that its export needs: whatever is edited, opened or closed meanwhile, it writes what was asked for.
struct ExportOrder {
  const ExportKind* kind = nullptr;
  ExportSource source;
  ExportSettings settings;
  std::filesystem::path file;
  std::optional<PictureJob> pictures{};  ///< Not the character but pictures of it: neither kind nor source.
};

/// One that is not done yet.
struct ExportStand {
  std::filesystem::path file;
  double share = 0.0;  ///< Done, 0..1.
  bool running = false;
  bool canceled = false;  ///< It is about to stop.
};

struct ExportOutcome {
  std::filesystem::path file;
  Result<ExportReport> result;  ///< Of pictures only whether there is an error.
  bool canceled = false;        ///< The result says so too.
  ExportOrder order{};          ///< What was asked for.
};

/// All calls from one thread, which never waits but in the destructor. One export runs at a time on a thread of its
/// own; the next begins when takeDone() has taken the one before.
class ExportQueue {
 public:
  ExportQueue();
  /// Cancels everything; what was not written yet leaves no file.
  ~ExportQueue();
  ExportQueue(ExportQueue&&) noexcept;
  ExportQueue& operator=(ExportQueue&&) noexcept;

  void add(ExportOrder order);
  /// The running one; those that wait go on.
  void cancel();
  /// The running one first, then those that wait, in the order in which they will be made.
  [[nodiscard]] std::vector<ExportStand> stands() const;
  [[nodiscard]] bool empty() const;
  /// What has ended since the last call.
  [[nodiscard]] std::vector<ExportOutcome> takeDone();

 private:
  struct Run;
  void startNext();

  std::unique_ptr<Run> run_;  ///< Null: nothing waits either.
  std::vector<ExportOrder> waiting_;
  std::vector<ExportOutcome> done_;  ///< Not taken yet.
};

}  // namespace sinew::app
