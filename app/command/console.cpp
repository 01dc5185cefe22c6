// app/command/console.cpp: the two streams and the exit statuses.
#include "app/command/console.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <sys/ioctl.h>
#include <unistd.h>

namespace sinew::app {
namespace {

constexpr int kPercentStep = 5;  ///< Between lines where stderr is not a terminal.

bool lineIsOpen = false;  ///< The terminal shows an unfinished progress line.

void putError(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

/// Other output replaces the progress line, which is drawn again below it.
void clearLine() {
  if (lineIsOpen) putError("\r\033[K");
  lineIsOpen = false;
}

/// One line, whatever a file name holds: Error::text() sees to that.
std::string lineOf(const std::string& text) { return "sinew: " + errorAt({}, text).text(); }

void putErrorLine(const std::string& text) {
  clearLine();
  putError(lineOf(text) + '\n');
}

bool isOnTerminal() { return ::isatty(STDERR_FILENO) == 1; }

/// A line that wraps cannot be overwritten: keeps the end of a longer one.
std::string fitted(const std::string& line) {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return line;
  const std::size_t most = size.ws_col - 1U;
  if (line.size() <= most) return line;
  std::size_t start = line.size() - most;
  while (start < line.size() && (static_cast<unsigned char>(line[start]) & 0xC0U) == 0x80U) ++start;  // Inside UTF-8.
  return line.substr(start);
}

}  // namespace

int badInput(const Error& error) {
  putErrorLine(error.text());
  return kBadInput;
}

int badCommandLine(const std::string& reason) {
  putErrorLine(reason);
  return kBadCommandLine;
}

int refused(const Error& error) { return error.file.empty() ? badCommandLine(error.text()) : badInput(error); }

void message(const std::string& text) { putErrorLine(text); }

ProgressLine::ProgressLine(std::string what, bool isAsked)
    : what_(std::move(what)), isAsked_(isAsked), isTerminal_(isOnTerminal()) {}

ProgressLine::~ProgressLine() { end(); }

void ProgressLine::show(double share) {
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  const int shown = isTerminal_ ? percent : percent / kPercentStep * kPercentStep;
  const bool isGone = isTerminal_ && !lineIsOpen && shown == percent_;
  if (!isShown() || (shown <= percent_ && !isGone)) return;
  percent_ = shown;
  const std::string line = lineOf(what_ + ": " + std::to_string(shown) + " %");
  putError(isTerminal_ ? '\r' + fitted(line) : line + '\n');
  lineIsOpen = isTerminal_;
}

void ProgressLine::end() {
  if (isTerminal_ && lineIsOpen) putError("\n");
  lineIsOpen = false;
  percent_ = -1;
}

int putResult(const std::string& text) {
  if (::isatty(STDOUT_FILENO) == 1) clearLine();
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (whole && std::fflush(stdout) == 0) return kDone;
  return badInput(errorAt("stdout", "cannot be written"));
}

}  // namespace sinew::app
