// app/document/preferences.h: what the editor remembers between runs.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/picture_look.h"
#include "app/ui/window.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

enum class Keymap { kMaya, kBlender };
inline constexpr std::array kKeymaps{Keymap::kMaya, Keymap::kBlender};

[[nodiscard]] const char* nameOf(Keymap keymap);  ///< "maya", "blender": in the file.

/// Who computes the surface. Automatic: the graphics card where it measures faster.
enum class SurfaceBy { kAutomatic, kProcessor, kCard };
inline constexpr std::array kSurfaceBys{SurfaceBy::kAutomatic, SurfaceBy::kProcessor, SurfaceBy::kCard};

[[nodiscard]] const char* nameOf(SurfaceBy by);  ///< "automatic", "processor", "card": in the file.

/// Keys in place of the keymap's ("Ctrl+D"), by action id: at most two; an empty list for no key.
using KeyChanges = std::map<std::string, std::vector<std::string>>;

/// Sizes of the panels in design pixels, and which are shown.
struct LayoutState {
  float left = 264.0f;
  float right = 304.0f;
  float history = 170.0f;  ///< Height, in the left column.
  float bottom = 84.0f;    ///< Height of the timeline.
  bool overlay = true;     ///< Numbers over the viewport.
  bool stages = false;     ///< ... with the times of the stages and all counts.
  bool leftShown = true;
  bool rightShown = true;
  bool bottomShown = true;
  std::vector<std::string> folded;  ///< Ids of the folded panels.

  friend bool operator==(const LayoutState&, const LayoutState&) = default;
};

inline constexpr std::size_t kMostRecentFiles = 15;
inline constexpr std::size_t kMostRecentActions = 20;
inline constexpr double kLeastAutosaveSeconds = 1.0;
inline constexpr double kMostAutosaveSeconds = 600.0;

struct Preferences {
  Keymap keymap = Keymap::kMaya;
  std::array<KeyChanges, kKeymaps.size()> keys;  ///< By keymap.
  float scale = 0.0f;                            ///< Of the interface, 0.5..4; 0: the system's.
  double autosaveSeconds = 30.0;
  std::vector<std::filesystem::path> recentFiles;  ///< Absolute, newest first, each once.
  std::vector<std::string> recentActions;          ///< Ids, newest first; the palette lists them first.
  bool hiddenFiles = false;                        ///< The file browser shows names that begin with a dot.
  bool newestFirst = false;                        ///< ... and sorts by date.
  PictureLook look;
  bool fullWhileMoving = false;  ///< Never lower the resolution of a moving picture.
  SurfaceBy surfaceBy = SurfaceBy::kAutomatic;
  std::filesystem::path pictureFolder;  ///< Where the last picture was saved; "": never.
  WindowPlace window;
  LayoutState layout;

  /// Those of the chosen keymap.
  [[nodiscard]] KeyChanges& keyChanges() { return keys[static_cast<std::size_t>(keymap)]; }
  [[nodiscard]] const KeyChanges& keyChanges() const { return keys[static_cast<std::size_t>(keymap)]; }

  friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// $VARIABLE if it is an absolute path, else ~/inHome. Need not exist.
[[nodiscard]] std::filesystem::path userFolder(const char* variable, const char* inHome);
[[nodiscard]] std::filesystem::path configFolder();     ///< $XDG_CONFIG_HOME/sinew, else ~/.config/sinew.
[[nodiscard]] std::filesystem::path preferencesFile();  ///< configFolder()/preferences.json.

[[nodiscard]] std::string preferencesToJson(const Preferences& preferences);  ///< Indented, keys in a fixed order.
/// Missing or unusable values keep their defaults. Error: not a preferences file.
[[nodiscard]] Result<Preferences> preferencesFromJson(std::string_view text);

struct LoadedPreferences {
  Preferences preferences;
  std::string complaint;  ///< For the messages; "": none.
};

/// Merges the changes of two windows: each setting that differs from `base`, mine if both do. Recent files and actions
/// of both, mine first, without those that I cleared.  @param base  mine when it was last read or written
[[nodiscard]] Preferences mergedPreferences(const Preferences& base, const Preferences& mine,
                                            const Preferences& theirs);

/// Defaults if there is no file; for a damaged one, which is kept as FILE.bad, with a complaint.
[[nodiscard]] LoadedPreferences loadPreferences(const std::filesystem::path& file);
/// Atomic; makes the folder.
[[nodiscard]] Result<void> savePreferences(const Preferences& preferences, const std::filesystem::path& file);
/// Writes mine merged with what other editors have written since; locks the folder meanwhile.
[[nodiscard]] Result<void> saveMergedPreferences(const Preferences& base, const Preferences& mine,
                                                 const std::filesystem::path& file);

/// Puts the file first, as an absolute path.
void rememberFile(std::vector<std::filesystem::path>& recent, const std::filesystem::path& file);
void rememberAction(std::vector<std::string>& recent, const std::string& id);

}  // namespace sinew::app
