// app/cli/console.cpp: the two streams and the exit statuses.
#include "app/cli/console.h"

#include <cstdio>

#include <unistd.h>

namespace sinew::app {
namespace {

void putErrorLine(const std::string& text) {
  // Error::text() keeps it on one line whatever a file name holds.
  const std::string line = "sinew: " + errorAt({}, text).text() + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
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

void progress(const std::string& text) {
  if (::isatty(STDERR_FILENO) == 1) putErrorLine(text);
}

int putResult(const std::string& text) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (whole && std::fflush(stdout) == 0) return kDone;
  return badInput(errorAt("stdout", "cannot be written"));
}

}  // namespace sinew::app
