// app/document/recovery.h: unsaved work survives a crash.
//
// Every running editor has a lock file in the recovery folder, NUMBER.lock, held by flock: the system releases it
// however the process ends. While its document has unsaved changes, NUMBER.json beside it holds them. A .json whose
// lock nobody holds was left behind by a crash.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/document/file_lock.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// $XDG_STATE_HOME/sinew/recovery, else recovery/ beside the preferences. Need not exist.
[[nodiscard]] std::filesystem::path recoveryFolder();

/// This process's place in the folder. Destroying it leaves the work where it is: only an end that was meant to be one
/// takes it away.
class RecoveryFile {
 public:
  /// Makes the folder. Error: it cannot be made or written.
  [[nodiscard]] static Result<RecoveryFile> claim(const std::filesystem::path& folder);

  /// Writes the document's rig and its paths, atomically. The rig file itself is never touched.
  [[nodiscard]] Result<void> write(const Document& document);
  /// Nothing is unsaved any more.
  void remove();
  /// Clean end: the lock goes too.
  void finish();

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] bool written() const { return written_; }

 private:
  RecoveryFile(std::filesystem::path file, FileLock lock) : file_(std::move(file)), lock_(std::move(lock)) {}

  std::filesystem::path file_;
  FileLock lock_;
  bool written_ = false;
};

/// Work that a crash left behind.
struct LeftBehind {
  std::filesystem::path file;  ///< The .json in the recovery folder.
  std::filesystem::path rigFile;
  std::filesystem::path characterFile;
  std::filesystem::file_time_type when;
  int primitives = 0;

  [[nodiscard]] std::string name() const;  ///< The rig file's, or the character's.
};

/// Newest first. Damaged ones, which a power cut may leave, are left out; locks that hold nothing are cleared away.
[[nodiscard]] std::vector<LeftBehind> findLeftBehind(const std::filesystem::path& folder);

/// The document as it was: modified, with its rig file's path, and one undo step back to what the file on the disk
/// holds. The recovery file stays until discardLeftBehind. Error: another editor has it, or the character is gone.
[[nodiscard]] Result<Document> recoverDocument(const LeftBehind& left);
void discardLeftBehind(const LeftBehind& left);

/// "just now", "5 minutes ago", "3 hours ago", "2 days ago".
[[nodiscard]] std::string ageText(std::filesystem::file_time_type when, std::filesystem::file_time_type now);

/// When to write. At most `interval` seconds of work are ever unwritten, gestures included: a rig in the middle of a
/// drag is a rig as good as any.
class AutosaveClock {
 public:
  enum class Deed { kNothing, kWrite, kRemove };

  /// Called often. @param now seconds on a clock that only grows; @param document a number that changes with every
  /// opened document; @param clip the one that is chosen: changing it writes at once.
  [[nodiscard]] Deed look(double now, double interval, const CommandStack& commands, std::size_t document, int clip);
  /// The next look() wants what is unwritten to be written, whatever the interval.
  void hurry() { hurried_ = true; }
  /// After a write that succeeded; one that did not is due again an interval later.
  void wrote(std::size_t revision);
  /// Seconds until look() may want to write; none: nothing is unwritten.
  [[nodiscard]] std::optional<double> secondsLeft(double now, double interval) const;

 private:
  std::size_t document_ = 0;
  std::optional<std::size_t> written_;  ///< Revision of this document that is in the recovery file.
  std::optional<double> since_;         ///< When the first unwritten change was seen.
  bool hasFile_ = false;                ///< The recovery file is there, of this document or the one before.
  int clip_ = -1;
  bool hurried_ = false;
};

}  // namespace sinew::app
