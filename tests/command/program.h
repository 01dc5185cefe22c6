// tests/command/program.h: runs the real program and captures its output.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/files/disk/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {

/// One run: exit status and both streams.
struct Outcome {
  int status = -1;
  std::string out;
  std::string error;

  [[nodiscard]] bool oneErrorLine() const {
    return error.starts_with("sinew: ") && error.ends_with('\n') && error.find('\n') == error.size() - 1;
  }
};

/// Gives each test its own folder; the program runs without a display.
class Program : public ::testing::Test {
 protected:
  /// @param before  prefix of the command line: "echo a.glb |"
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments, const char* program = SINEW_PROGRAM,
                            const std::string& before = "") const {
    const std::string out = (folder_ / "stdout").string();
    const std::string error = (folder_ / "stderr").string();
    std::string command =
        "cd " + quoted(folder_.string()) + " && " + before + " env -u DISPLAY -u WAYLAND_DISPLAY " + quoted(program);
    for (const std::string& argument : arguments) command += ' ' + quoted(argument);
    command += " >" + quoted(out) + " 2>" + quoted(error) + (before.empty() ? " </dev/null" : "");
    const int status = std::system(command.c_str());
    Outcome result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, readWholeFile(out, 1 << 26).value(),
                   readWholeFile(error, 1 << 26).value()};
    std::filesystem::remove(out);
    std::filesystem::remove(error);
    return result;
  }

  static std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + '\'';
  }

  [[nodiscard]] static std::string demo(const char* file) {
    return (std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / file).string();
  }

  const TemporaryFolder own_;
  const std::filesystem::path folder_ = own_.path();
};

}  // namespace sinew::test
