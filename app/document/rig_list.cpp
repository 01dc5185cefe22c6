// app/document/rig_list.cpp: rigs of a folder, and their names as a farm job says them.
#include "app/document/rig_list.h"

#include <algorithm>
#include <system_error>

#include "app/document/character_files.h"

namespace sinew::app {

namespace fs = std::filesystem;

std::string nameWithoutEnding(const fs::path& file) {
  return withoutEnding(file.filename().string()).value_or(file.stem().string());
}

std::vector<fs::path> rigsIn(const fs::path& folder) {
  std::vector<fs::path> rigs;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed); !failed && it != fs::directory_iterator(); it.increment(failed)) {
    const std::string name = it->path().filename().string();
    std::error_code unknown;
    if (name.ends_with(".rig.json") && name.find('\n') == std::string::npos && it->is_regular_file(unknown)) {
      rigs.push_back(it->path());
    }
  }
  std::ranges::sort(rigs);
  return rigs;
}

std::string pathWord(const fs::path& folder, const fs::path& file) {
  const fs::path relative = file.lexically_relative(folder);
  if (relative.empty() || *relative.begin() == "..") return file.string();
  const std::string word = relative.string();
  return std::string("-# \t").find(word.front()) == std::string::npos ? word : "./" + word;
}

std::string listText(const fs::path& folder, const std::vector<fs::path>& rigs) {
  std::string text;
  for (const fs::path& rig : rigs) text += pathWord(folder, rig) + '\n';
  return text;
}

}  // namespace sinew::app
