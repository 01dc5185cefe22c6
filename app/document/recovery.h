// app/document/recovery.h: unsaved work survives a crash. Every running editor locks NUMBER.lock in the recovery folder
// (flock ends with the process), with its unsaved changes in NUMBER.json. A .json without a held lock was left behind.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/document/file_stamp.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// $XDG_STATE_HOME/sinew/recovery, else recovery/ beside the preferences. Need not exist.
[[nodiscard]] std::filesystem::path recoveryFolder();

/// This process's file in the folder. The destructor keeps it; finish() removes it.
class RecoveryFile {
 public:
  [[nodiscard]] static Result<RecoveryFile> claim(const std::filesystem::path& folder);  ///< Makes the folder.

  [[nodiscard]] Result<void> write(const Document& document);  ///< Writes the document's rig and paths, atomically.
  void remove();                                               ///< Removes the unsaved work.
  void finish();                                               ///< Clean exit: removes the lock too.

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

/// Newest first, without damaged files. Removes unused locks.
[[nodiscard]] std::vector<LeftBehind> findLeftBehind(const std::filesystem::path& folder);

/// The document as it was: modified, with one undo step back to the file on disk. The recovery file stays until
/// discardLeftBehind(). Error: another editor has it, or the character is missing.
[[nodiscard]] Result<Document> recoverDocument(const LeftBehind& left);
void discardLeftBehind(const LeftBehind& left);

/// "just now", "5 minutes ago", "3 hours ago", "2 days ago".
[[nodiscard]] std::string ageText(std::filesystem::file_time_type when, std::filesystem::file_time_type now);

/// Decides when to write, so that at most `interval` seconds of work are unwritten, gestures included.
class AutosaveClock {
 public:
  enum class Deed { kNothing, kWrite, kRemove };

  /// Called often. @param now  seconds, monotonic  @param document  changes with every opened document
  /// @param clip  the chosen one; choosing another writes at once
  [[nodiscard]] Deed look(double now, double interval, const CommandStack& commands, std::size_t document, int clip);
  /// The next look() writes unwritten work regardless of the interval.
  void hurry() { hurried_ = true; }
  void wrote(std::size_t revision);  ///< Call after a successful write; a failed one is due again an interval later.
  /// Seconds until look() may write; nullopt: nothing is unwritten.
  [[nodiscard]] std::optional<double> secondsLeft(double now, double interval) const;

 private:
  std::size_t document_ = 0;
  std::optional<std::size_t> written_;  ///< Revision in the recovery file.
  std::optional<double> since_;         ///< Time of the first unwritten change.
  bool hasFile_ = false;                ///< The recovery file exists.
  int clip_ = -1;
  bool hurried_ = false;
};

}  // namespace sinew::app
