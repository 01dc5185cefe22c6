// app/ui/data_files.cpp: the folders the program's own files are looked for in.
#include "app/ui/data_files.h"

#include <cstdlib>
#include <system_error>
#include <vector>

namespace sinew::app {
namespace {

std::vector<std::filesystem::path> dataFolders() {
  std::vector<std::filesystem::path> folders;
  if (const char* named = std::getenv("SINEW_DATA_DIR"); named != nullptr && *named != '\0')
    folders.emplace_back(named);
  const std::filesystem::path beside = executableFolder();
  // Before the source tree, which an installed program must not depend on, even where it is there and older.
  if (!beside.empty()) folders.push_back(beside.parent_path() / "share" / "sinew");
  folders.emplace_back(SINEW_SOURCE_DATA_DIR);
  folders.emplace_back(SINEW_INSTALLED_DATA_DIR);
  if (!beside.empty()) folders.push_back(beside);
  return folders;
}

}  // namespace

std::filesystem::path executableFolder() {
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? std::filesystem::path{} : program.parent_path();
}

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
