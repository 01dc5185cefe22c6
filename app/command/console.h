// app/command/console.h: output of the verbs: results on stdout, everything else on stderr, and the exit statuses.
#pragma once

#include <string>

#include "app/ui/data_files.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// Exit statuses, docs/formats.md.
inline constexpr int kDone = 0;
inline constexpr int kBadInput = 1;
inline constexpr int kBadCommandLine = 2;
inline constexpr int kSomeFailed = 3;

[[nodiscard]] int badInput(const Error& error);  ///< "sinew: file: place: reason" on stderr. Returns kBadInput.

[[nodiscard]] int badCommandLine(const std::string& reason);  ///< One line on stderr. Returns kBadCommandLine.

[[nodiscard]] int refused(const Error& error);  ///< badCommandLine for an error without a file, else badInput.

void message(const std::string& text);  ///< One line on stderr that is not an error.

/// Progress of long work on stderr: on a terminal one line that is overwritten; elsewhere, if asked for, a line every 5
/// percent. Messages and results replace it on the terminal.
class ProgressLine {
 public:
  /// @param what  the work: "exporting fox.glb"  @param isAsked  show it even without a terminal
  ProgressLine(std::string what, bool isAsked);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  [[nodiscard]] bool isShown() const { return isTerminal_ || isAsked_; }
  void show(double share);  ///< @param share  fraction of the work that is done, 0..1, never falling
  void end();               ///< Ends the line, before output below it.

 private:
  std::string what_;
  bool isAsked_ = false;
  bool isTerminal_ = false;
  int percent_ = -1;  ///< Last shown; -1: none.
};

/// Writes the verb's result to stdout. kDone, or kBadInput with a line on stderr if that fails.
[[nodiscard]] int putResult(const std::string& text);

}  // namespace sinew::app
