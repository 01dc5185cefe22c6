// app/document/preferences.cpp: preferences as a JSON file, read leniently.
#include "app/document/preferences.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <system_error>

#include "app/document/file_stamp.h"
#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"

namespace sinew::app {
namespace {

constexpr std::uintmax_t kLargestPreferences = 1u << 20;
constexpr float kWidestPanel = 4000.0f;
constexpr int kFarthestPixel = 100000;

/// Takes a number within the range; else keeps the value.
template <class Number>
void read(const Json& json, const std::string& key, double least, double most, Number& value) {
  const double number = json.at(key).number(std::nan(""));
  if (number >= least && number <= most) value = static_cast<Number>(number);
}

void read(const Json& json, const std::string& key, bool& value) { value = json.at(key).boolean(value); }

Json layoutToJson(const LayoutState& layout) {
  Json folded = Json::array();
  for (const std::string& id : layout.folded) folded.push(id);
  return Json::object()
      .set("left", layout.left)
      .set("right", layout.right)
      .set("history", layout.history)
      .set("bottom", layout.bottom)
      .set("overlay", layout.overlay)
      .set("stages", layout.stages)
      .set("left_shown", layout.leftShown)
      .set("right_shown", layout.rightShown)
      .set("bottom_shown", layout.bottomShown)
      .set("folded", folded);
}

LayoutState layoutFromJson(const Json& json) {
  LayoutState layout;
  read(json, "left", 1.0, kWidestPanel, layout.left);
  read(json, "right", 1.0, kWidestPanel, layout.right);
  read(json, "history", 1.0, kWidestPanel, layout.history);
  read(json, "bottom", 1.0, kWidestPanel, layout.bottom);
  read(json, "overlay", layout.overlay);
  read(json, "stages", layout.stages);
  read(json, "left_shown", layout.leftShown);
  read(json, "right_shown", layout.rightShown);
  read(json, "bottom_shown", layout.bottomShown);
  for (const Json& id : json.at("folded").items()) layout.folded.push_back(id.text(""));
  std::erase(layout.folded, "");
  return layout;
}

Json windowToJson(const WindowPlace& window) {
  return Json::object()
      .set("x", window.x)
      .set("y", window.y)
      .set("width", window.width)
      .set("height", window.height)
      .set("maximised", window.maximized);
}

WindowPlace windowFromJson(const Json& json) {
  WindowPlace window;
  read(json, "x", -kFarthestPixel, kFarthestPixel, window.x);
  read(json, "y", -kFarthestPixel, kFarthestPixel, window.y);
  read(json, "width", 0, kFarthestPixel, window.width);
  read(json, "height", 0, kFarthestPixel, window.height);
  read(json, "maximised", window.maximized);
  return window;
}

Json pictureToJson(const Preferences& preferences) {
  const PictureLook& look = preferences.look;
  return Json::object()
      .set("light", nameOf(look.light))
      .set("background", nameOf(look.backdrop))
      .set("ao", look.occlusion)
      .set("moving", preferences.fullWhileMoving ? "full" : "automatic")
      .set("surface", nameOf(preferences.surfaceBy))
      .set("folder", preferences.pictureFolder.string());
}

void readPicture(const Json& json, Preferences& preferences) {
  PictureLook& look = preferences.look;
  look.light = lightNamed(json.at("light").text("")).value_or(look.light);
  look.backdrop = backdropNamed(json.at("background").text("")).value_or(look.backdrop);
  read(json, "ao", look.occlusion);
  preferences.fullWhileMoving = json.at("moving").text("") == "full";
  for (const SurfaceBy by : kSurfaceBys) {
    if (json.at("surface").text("") == nameOf(by)) preferences.surfaceBy = by;
  }
  if (const std::string folder = json.at("folder").text(""); folder.starts_with('/')) {
    preferences.pictureFolder = folder;
  }
}

Json keysToJson(const Preferences& preferences) {
  Json all = Json::object();
  for (const Keymap keymap : kKeymaps) {
    Json changes = Json::object();
    for (const auto& [id, keys] : preferences.keys[static_cast<std::size_t>(keymap)]) {
      Json texts = Json::array();
      for (const std::string& key : keys) texts.push(key);
      changes.set(id, texts);
    }
    all.set(nameOf(keymap), changes);
  }
  return all;
}

KeyChanges keysFromJson(const Json& json) {
  KeyChanges changes;
  for (const std::string& id : json.keys()) {
    const Json& texts = json.at(id);
    if (texts.kind != Json::Kind::kArray) continue;
    std::vector<std::string>& keys = changes[id];
    for (const Json& key : texts.items()) keys.push_back(key.text("?"));  // "?" is dropped later, with a note.
  }
  return changes;
}

/// Number of items at the front of `mine` that are new or moved: the rest is in `base` in the same order.
template <class Item>
std::size_t addedTo(const std::vector<Item>& base, const std::vector<Item>& mine) {
  auto from = base.end();
  std::size_t added = mine.size();
  while (added > 0) {
    const auto found = std::find(base.begin(), from, mine[added - 1]);
    if (found == from) break;
    from = found;
    --added;
  }
  return added;
}

template <class Item>
std::vector<Item> mergedList(const std::vector<Item>& base, const std::vector<Item>& mine,
                             const std::vector<Item>& theirs, std::size_t most) {
  const auto holds = [](const std::vector<Item>& list, const Item& item) {
    return std::ranges::find(list, item) != list.end();
  };
  std::vector<Item> merged(mine.begin(), mine.begin() + static_cast<std::ptrdiff_t>(addedTo(base, mine)));
  // A full list loses its oldest item without being cleared.
  const bool cleared = mine.size() < std::min(base.size(), most);
  for (const Item& item : theirs) {
    const bool gone = cleared && holds(base, item) && !holds(mine, item);
    if (!gone && !holds(merged, item)) merged.push_back(item);
  }
  if (merged.size() > most) merged.resize(most);
  return merged;
}

std::string keptAside(const std::filesystem::path& file) {
  std::filesystem::path aside = file;
  aside += ".bad";
  std::error_code failed;
  std::filesystem::rename(file, aside, failed);
  return failed ? "" : "; it is kept as " + aside.filename().string();
}

}  // namespace

const char* nameOf(Keymap keymap) { return keymap == Keymap::kBlender ? "blender" : "maya"; }

const char* nameOf(SurfaceBy by) {
  switch (by) {
    case SurfaceBy::kProcessor:
      return "processor";
    case SurfaceBy::kCard:
      return "card";
    case SurfaceBy::kAutomatic:
      break;
  }
  return "automatic";
}

std::filesystem::path userFolder(const char* variable, const char* inHome) {
  // The XDG base directory specification ignores relative paths.
  if (const char* folder = std::getenv(variable); folder != nullptr && *folder == '/') return folder;
  const char* home = std::getenv("HOME");
  std::error_code ignored;
  const std::filesystem::path base =
      home != nullptr && *home != '\0' ? std::filesystem::path(home) : std::filesystem::temp_directory_path(ignored);
  return base / inHome;
}

std::filesystem::path configFolder() { return userFolder("XDG_CONFIG_HOME", ".config") / "sinew"; }

std::filesystem::path preferencesFile() { return configFolder() / "preferences.json"; }

std::string preferencesToJson(const Preferences& preferences) {
  Json files = Json::array();
  for (const std::filesystem::path& file : preferences.recentFiles) files.push(file.string());
  Json actions = Json::array();
  for (const std::string& id : preferences.recentActions) actions.push(id);
  return Json::object()
             .set("format", "sinew-preferences")
             .set("version", 1)
             .set("keymap", nameOf(preferences.keymap))
             .set("keys", keysToJson(preferences))
             .set("scale", preferences.scale)
             .set("autosave_seconds", preferences.autosaveSeconds)
             .set("recent_files", files)
             .set("recent_actions", actions)
             .set("hidden_files", preferences.hiddenFiles)
             .set("newest_first", preferences.newestFirst)
             .set("picture", pictureToJson(preferences))
             .set("window", windowToJson(preferences.window))
             .set("layout", layoutToJson(preferences.layout))
             .dump(true) +
         "\n";
}

Result<Preferences> preferencesFromJson(std::string_view text) {
  const Result<Json> parsed = Json::parse(text);
  if (!parsed) return parsed.error();
  const Json& json = parsed.value();
  if (json.at("format").text("") != "sinew-preferences") return errorAt("format", "expected \"sinew-preferences\"");
  Preferences preferences;
  if (json.at("keymap").text("") == nameOf(Keymap::kBlender)) preferences.keymap = Keymap::kBlender;
  for (const Keymap keymap : kKeymaps) {
    preferences.keys[static_cast<std::size_t>(keymap)] = keysFromJson(json.at("keys").at(nameOf(keymap)));
  }
  read(json, "scale", 0.5, 4.0, preferences.scale);
  read(json, "autosave_seconds", kLeastAutosaveSeconds, kMostAutosaveSeconds, preferences.autosaveSeconds);
  const std::vector<Json> files = json.at("recent_files").items();
  for (auto file = files.rbegin(); file != files.rend(); ++file) {
    if (const std::string path = file->text(""); path.starts_with('/')) rememberFile(preferences.recentFiles, path);
  }
  const std::vector<Json> actions = json.at("recent_actions").items();
  for (auto id = actions.rbegin(); id != actions.rend(); ++id) {
    if (const std::string name = id->text(""); !name.empty()) rememberAction(preferences.recentActions, name);
  }
  read(json, "hidden_files", preferences.hiddenFiles);
  read(json, "newest_first", preferences.newestFirst);
  readPicture(json.at("picture"), preferences);
  preferences.window = windowFromJson(json.at("window"));
  preferences.layout = layoutFromJson(json.at("layout"));
  return preferences;
}

LoadedPreferences loadPreferences(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) return {};
  const Result<std::string> text = readWholeFile(file, kLargestPreferences);
  if (!text) return {{}, text.error().text() + "; the default preferences are used" + keptAside(file)};
  Result<Preferences> preferences = preferencesFromJson(text.value());
  if (preferences) return {std::move(preferences).value(), ""};
  Error error = preferences.error();
  error.file = file.string();
  return {{}, error.text() + "; the default preferences are used" + keptAside(file)};
}

Preferences mergedPreferences(const Preferences& base, const Preferences& mine, const Preferences& theirs) {
  Preferences merged = mine;
  const auto merge = [&](auto Preferences::*setting) {
    if (mine.*setting == base.*setting) merged.*setting = theirs.*setting;
  };
  merge(&Preferences::keymap);
  merge(&Preferences::keys);
  merge(&Preferences::scale);
  merge(&Preferences::autosaveSeconds);
  merge(&Preferences::hiddenFiles);
  merge(&Preferences::newestFirst);
  merge(&Preferences::look);
  merge(&Preferences::fullWhileMoving);
  merge(&Preferences::surfaceBy);
  merge(&Preferences::pictureFolder);
  merge(&Preferences::window);
  merge(&Preferences::layout);
  merged.recentFiles = mergedList(base.recentFiles, mine.recentFiles, theirs.recentFiles, kMostRecentFiles);
  merged.recentActions = mergedList(base.recentActions, mine.recentActions, theirs.recentActions, kMostRecentActions);
  return merged;
}

Result<void> savePreferences(const Preferences& preferences, const std::filesystem::path& file) {
  std::error_code failed;
  std::filesystem::create_directories(file.parent_path(), failed);
  return writeFileAtomically(file, preferencesToJson(preferences));
}

Result<void> saveMergedPreferences(const Preferences& base, const Preferences& mine,
                                   const std::filesystem::path& file) {
  std::error_code failed;
  std::filesystem::create_directories(file.parent_path(), failed);
  const FileLock lock = lockFolder(file.parent_path());
  if (!std::filesystem::exists(file, failed)) return savePreferences(mine, file);
  return savePreferences(mergedPreferences(base, mine, loadPreferences(file).preferences), file);
}

void rememberFile(std::vector<std::filesystem::path>& recent, const std::filesystem::path& file) {
  std::error_code failed;
  std::filesystem::path whole = std::filesystem::absolute(file, failed).lexically_normal();
  if (failed) return;
  std::erase(recent, whole);
  recent.insert(recent.begin(), std::move(whole));
  if (recent.size() > kMostRecentFiles) recent.resize(kMostRecentFiles);
}

void rememberAction(std::vector<std::string>& recent, const std::string& id) {
  std::string kept = id;  // It may be one of those erased.
  std::erase(recent, kept);
  recent.insert(recent.begin(), std::move(kept));
  if (recent.size() > kMostRecentActions) recent.resize(kMostRecentActions);
}

}  // namespace sinew::app
