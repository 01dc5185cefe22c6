// app/cli/console.h: how the verbs talk: results to stdout, all else to stderr, and the exit statuses.
#pragma once

#include <string>

#include "app/platform/version.h"
#include "sinew/base/result.h"

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

/// One line on stderr if that is a terminal: what takes a while now.
void progress(const std::string& text);

/// Puts the verb's result on stdout. kDone, or kBadInput with a line on stderr if stdout does not take it.
[[nodiscard]] int putResult(const std::string& text);

}  // namespace sinew::app
