// app/command/console.h: how the verbs talk: results to stdout, all else to stderr, and the exit statuses.
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

/// One line, "sinew: file: place: reason", on stderr. Returns kBadInput.
[[nodiscard]] int badInput(const Error& error);

/// One line on stderr. Returns kBadCommandLine.
[[nodiscard]] int badCommandLine(const std::string& reason);

/// Either of them: an error without a file is one of the command line.
[[nodiscard]] int refused(const Error& error);

/// One line on stderr that is no error: something the user should know of the result.
void message(const std::string& text);

/// How far a long work is, on stderr: on a terminal one line that is written over; elsewhere, if it is wanted there, a
/// line whenever another 5 percent are done. Messages and results that come meanwhile take its place on the terminal.
class ProgressLine {
 public:
  /// @param what  the work: "exporting fox.glb"  @param isAsked  whether it is wanted where there is no terminal
  ProgressLine(std::string what, bool isAsked);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Whether anybody sees it.
  [[nodiscard]] bool isShown() const { return isTerminal_ || isAsked_; }
  /// @param share  of the work that is done, 0..1, never falling
  void show(double share);
  /// Ends the line, for what is to stand below it.
  void end();

 private:
  std::string what_;
  bool isAsked_ = false;
  bool isTerminal_ = false;
  int percent_ = -1;  ///< Shown last; -1: none.
};

/// Puts the verb's result on stdout. kDone, or kBadInput with a line on stderr if stdout does not take it.
[[nodiscard]] int putResult(const std::string& text);

}  // namespace sinew::app
