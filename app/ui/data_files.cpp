// app/ui/data_files.cpp: folders of the program's files; xdg-open. Compiled again when the commit changes.
#include "app/ui/data_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sinew_version.h"

namespace sinew::app {

namespace {

constexpr int kMostLooks = 60;  // A viewer that runs that long has opened the file.

}  // namespace

bool DesktopOpener::open(const std::filesystem::path& file) {
  std::string program = "xdg-open";
  std::string path = std::filesystem::absolute(file).string();
  const std::array<char*, 3> arguments{program.data(), path.data(), nullptr};
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // In its own process group, so that Ctrl+C in the editor's terminal does not end the viewer.
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

const char* programVersion() { return SINEW_VERSION " (" SINEW_COMMIT ")"; }

namespace {

/// "": the system does not tell.
std::filesystem::path executableFolder() {
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? std::filesystem::path{} : program.parent_path();
}

std::vector<std::filesystem::path> dataFolders() {
  std::vector<std::filesystem::path> folders;
  if (const char* named = std::getenv("SINEW_DATA_DIR"); named != nullptr && *named != '\0')
    folders.emplace_back(named);
  const std::filesystem::path beside = executableFolder();
  // Before the source tree, which an installed program must not use.
  if (!beside.empty()) folders.push_back(beside.parent_path() / "share" / "sinew");
  folders.emplace_back(SINEW_SOURCE_DATA_DIR);
  folders.emplace_back(SINEW_INSTALLED_DATA_DIR);
  if (!beside.empty()) folders.push_back(beside);
  return folders;
}

}  // namespace

std::filesystem::path pagesFolder() {
  for (const std::filesystem::path& folder : dataFolders()) {
    std::error_code failed;
    for (const auto& pages : {folder.parent_path() / "doc" / "sinew" / "docs", folder / "docs"}) {
      if (std::filesystem::is_directory(pages, failed)) return pages;
    }
  }
  return {};
}

std::filesystem::path dataFile(const std::filesystem::path& relative) {
  const std::vector<std::filesystem::path> folders = dataFolders();
  for (const std::filesystem::path& folder : folders) {
    std::error_code failed;
    if (std::filesystem::exists(folder / relative, failed)) return folder / relative;
  }
  return folders.front() / relative;
}

}  // namespace sinew::app
