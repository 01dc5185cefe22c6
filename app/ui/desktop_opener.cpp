// app/ui/desktop_opener.cpp: xdg-open as a process of its own.
#include "app/ui/desktop_opener.h"

#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <string>

extern char** environ;

namespace sinew::app {
namespace {

constexpr int kMostLooks = 60;  // A viewer that runs that long has opened the file, and may stay for hours.

}  // namespace

bool DesktopOpener::open(const std::filesystem::path& file) {
  std::string program = "xdg-open";
  std::string path = std::filesystem::absolute(file).string();
  const std::array<char*, 3> arguments{program.data(), path.data(), nullptr};
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // A group of its own: Ctrl+C in the terminal that the editor runs in does not end the viewer.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, program.c_str(), nullptr, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (failed != 0) return false;
  running_.push_back({process, file});
  return true;
}

bool DesktopOpener::busy() const {
  return std::ranges::any_of(running_, [](const Running& one) { return one.looks < kMostLooks; });
}

std::vector<std::filesystem::path> DesktopOpener::failed() {
  std::vector<std::filesystem::path> failed;
  std::erase_if(running_, [&](Running& one) {
    ++one.looks;
    int status = 0;
    if (waitpid(one.process, &status, WNOHANG) == 0) return false;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) failed.push_back(one.file);
    return true;
  });
  return failed;
}

}  // namespace sinew::app
