// app/document/muscle_sets.cpp: the folders that sets of muscles are read from.
#include "app/document/muscle_sets.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/document/preferences.h"
#include "app/platform/data_files.h"
#include "core/io/preset_json.h"

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

int indexOr(const std::vector<Preset>& sets, std::vector<Preset>::const_iterator found) {
  return found == sets.end() ? -1 : static_cast<int>(found - sets.begin());
}

}  // namespace

int MuscleSets::named(std::string_view name) const {
  return indexOr(sets, std::ranges::find(sets, name, &Preset::name));
}

int MuscleSets::firstFor(BodyKind body) const { return indexOr(sets, std::ranges::find(sets, body, &Preset::body)); }

fs::path ownSetsFolder() { return preferencesFile().parent_path() / "sets"; }

MuscleSets muscleSets() {
  MuscleSets all;
  for (const fs::path& folder : {dataFile(fs::path("assets") / "presets"), ownSetsFolder()}) {
    for (const fs::path& file : setFilesIn(folder)) {
      Result<Preset> set = loadPreset(file);
      if (!set) all.refused.push_back(set.error());
      else if (all.named(set->name) < 0) all.sets.push_back(std::move(set).value());
    }
  }
  return all;
}

}  // namespace sinew::app
