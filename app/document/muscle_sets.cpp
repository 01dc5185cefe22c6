// app/document/muscle_sets.cpp: the folders that sets of muscles are read from.
#include "app/document/muscle_sets.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/document/preferences.h"
#include "app/ui/data_files.h"
#include "core/files/preset_json.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> setFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed); !failed && it != fs::directory_iterator(); it.increment(failed)) {
    if (it->path().extension() == ".json") files.push_back(it->path());
  }
  std::ranges::sort(files);
  return files;
}

constexpr std::size_t kLongestName = 60;
constexpr std::string_view kRefused = "/\\:*?\"<>|";

fs::path shippedFolder() { return dataFile(fs::path("assets") / "presets"); }

fs::path fileIn(const fs::path& folder, std::string_view name) { return folder / (std::string(name) + ".json"); }

bool isFile(const fs::path& file) {
  std::error_code failed;
  return fs::is_regular_file(file, failed);
}

int indexOr(const std::vector<Preset>& sets, std::vector<Preset>::const_iterator found) {
  return found == sets.end() ? -1 : static_cast<int>(found - sets.begin());
}

}  // namespace

int MuscleSets::named(std::string_view name) const {
  return indexOr(sets, std::ranges::find(sets, name, &Preset::name));
}

int MuscleSets::firstFor(BodyKind body) const { return indexOr(sets, std::ranges::find(sets, body, &Preset::body)); }

fs::path ownSetsFolder() { return preferencesFile().parent_path() / "sets"; }

bool isShippedSet(std::string_view name) { return isFile(fileIn(shippedFolder(), name)); }

bool isOwnSet(std::string_view name) { return !isShippedSet(name) && isFile(fileIn(ownSetsFolder(), name)); }

std::string setNameFor(std::string_view title) {
  std::string name;
  for (const char c : title.substr(0, kLongestName)) {
    const bool taken = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f && kRefused.find(c) == std::string_view::npos;
    name += taken ? c : '-';
  }
  const auto blank = [](char c) { return c == ' ' || c == '.'; };
  while (!name.empty() && blank(name.back())) name.pop_back();
  while (!name.empty() && blank(name.front())) name.erase(0, 1);
  return name;
}

Result<void> saveOwnSet(const Preset& set) {
  std::error_code failed;
  fs::create_directories(ownSetsFolder(), failed);
  if (failed) return Error{ownSetsFolder().string(), "", failed.message(), "cannot be made"};
  return savePreset(set, fileIn(ownSetsFolder(), set.name));
}

Result<void> removeOwnSet(std::string_view name) {
  const fs::path file = fileIn(ownSetsFolder(), name);
  fs::path kept = file;
  kept += "~";
  std::error_code failed;
  fs::rename(file, kept, failed);
  if (failed) return Error{file.string(), "", failed.message(), "cannot be removed"};
  return {};
}

MuscleSets muscleSets() {
  MuscleSets all;
  for (const fs::path& folder : {shippedFolder(), ownSetsFolder()}) {
    for (const fs::path& file : setFilesIn(folder)) {
      Result<Preset> set = loadPreset(file);
      if (!set) all.refused.push_back(set.error());
      else if (all.named(set->name) < 0) all.sets.push_back(std::move(set).value());
    }
  }
  return all;
}

}  // namespace sinew::app
