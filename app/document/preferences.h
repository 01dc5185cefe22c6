// app/document/preferences.h: what the editor remembers from one start to the next.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/picture_look.h"
#include "app/ui/window_place.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

enum class Keymap { kMaya, kBlender };
inline constexpr std::array kKeymaps{Keymap::kMaya, Keymap::kBlender};

[[nodiscard]] const char* nameOf(Keymap keymap);  ///< "maya", "blender": what the file says.

/// Who computes the surface in the picture. Automatic: the graphics card where it was measured to be faster.
enum class SurfaceBy { kAutomatic, kProcessor, kCard };
inline constexpr std::array kSurfaceBys{SurfaceBy::kAutomatic, SurfaceBy::kProcessor, SurfaceBy::kCard};

[[nodiscard]] const char* nameOf(SurfaceBy by);  ///< "automatic", "processor", "card": what the file says.

/// Keys in place of the keymap's, "Ctrl+D", by the action's id: at most two, an empty list for no key. What actions and
/// keys there are is known to app/editor/bindings.h.
using KeyChanges = std::map<std::string, std::vector<std::string>>;

/// Sizes of the panels in design pixels, and which are there.
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
  std::vector<std::string> folded;  ///< Ids of the panels that show their title alone.

  friend bool operator==(const LayoutState&, const LayoutState&) = default;
};

inline constexpr std::size_t kMostRecentFiles = 15;
inline constexpr std::size_t kMostRecentActions = 20;
inline constexpr double kLeastAutosaveSeconds = 1.0;
inline constexpr double kMostAutosaveSeconds = 600.0;

struct Preferences {
  Keymap keymap = Keymap::kMaya;
  std::array<KeyChanges, kKeymaps.size()> keys;  ///< By keymap.
  float scale = 0.0f;                            ///< The interface's, 0.5..4; 0: what the system says.
  double autosaveSeconds = 30.0;
  std::vector<std::filesystem::path> recentFiles;  ///< Absolute, newest first, each once.
  std::vector<std::string> recentActions;          ///< Ids, newest first: what the palette offers first.
  bool hiddenFiles = false;                        ///< The file browser shows names that begin with a dot.
  bool newestFirst = false;                        ///< ... and sorts by date.
  PictureLook look;
  bool fullWhileMoving = false;  ///< Never a lower resolution for what moves.
  SurfaceBy surfaceBy = SurfaceBy::kAutomatic;
  std::filesystem::path pictureFolder;  ///< Where the last picture was saved; "": never.
  WindowPlace window;
  LayoutState layout;

  /// Those of the chosen keymap.
  [[nodiscard]] KeyChanges& keyChanges() { return keys[static_cast<std::size_t>(keymap)]; }
  [[nodiscard]] const KeyChanges& keyChanges() const { return keys[static_cast<std::size_t>(keymap)]; }

  friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// $XDG_CONFIG_HOME/sinew, else ~/.config/sinew. Need not exist.
[[nodiscard]] std::filesystem::path configFolder();
/// configFolder()/preferences.json.
[[nodiscard]] std::filesystem::path preferencesFile();

/// Indented, keys in a fixed order.
[[nodiscard]] std::string preferencesToJson(const Preferences& preferences);
/// A key that is absent, of another type or out of its range keeps its default. Error: no JSON object at all.
[[nodiscard]] Result<Preferences> preferencesFromJson(std::string_view text);

struct LoadedPreferences {
  Preferences preferences;
  std::string complaint;  ///< For the messages; "" if all is well.
};

/// What two windows have changed, together: of each setting the one that differs from `base` counts, mine if both do.
/// The lists of recent files and actions hold what either has added, mine first, without what I have cleared.
/// @param base  mine when it was read or written last
[[nodiscard]] Preferences mergedPreferences(const Preferences& base, const Preferences& mine,
                                            const Preferences& theirs);

/// No file: defaults. A damaged file: defaults, a complaint, and the file is kept as FILE.bad.
[[nodiscard]] LoadedPreferences loadPreferences(const std::filesystem::path& file);
/// Atomic; makes the folder.
[[nodiscard]] Result<void> savePreferences(const Preferences& preferences, const std::filesystem::path& file);
/// Writes mine together with what other editors have written since (mergedPreferences); one editor at a time.
[[nodiscard]] Result<void> saveMergedPreferences(const Preferences& base, const Preferences& mine,
                                                 const std::filesystem::path& file);

/// Puts the file first; made absolute, kMostRecentFiles at most.
void rememberFile(std::vector<std::filesystem::path>& recent, const std::filesystem::path& file);
void rememberAction(std::vector<std::string>& recent, const std::string& id);

}  // namespace sinew::app
