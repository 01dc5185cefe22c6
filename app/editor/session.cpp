// app/editor/session.cpp: samples, recent files, recovery, help and first steps.
#include "app/editor/session.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <system_error>
#include <utility>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "app/document/folder_listing.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/open_file.h"
#include "app/ui/data_files.h"
#include "core/geometry/at.h"

namespace sinew::app {

namespace {

constexpr float kTurned = 0.15f;  ///< Radians.
constexpr float kScaled = 0.03f;  ///< Of a radius.

bool isScaled(const Rig& before, const Rig& now) {
  return std::ranges::any_of(now.primitives, [&](const Primitive& muscle) {
    const int index = findPrimitive(before, muscle.id());
    if (index < 0) return false;
    const glm::vec3 radii = at(before.primitives, index).placement.radii;
    return glm::any(glm::greaterThan(glm::abs(muscle.placement.radii - radii), kScaled * radii));
  });
}

}  // namespace

void toggleFirstSteps(EditorState& state) {
  FirstStepsState& steps = state.view.firstSteps;
  if (steps.shown) {
    steps.shown = false;
    return;
  }
  steps = {};
  steps.shown = true;
  if (const std::filesystem::path sample = firstSample(); !sample.empty())
    request(state, {IntentKind::kOpenFile, sample});
}

void followFirstSteps(EditorState& state) {
  FirstStepsState& steps = state.view.firstSteps;
  if (!steps.shown || !state.hasCharacter()) return;
  const Camera& camera = state.view.tools.camera;
  // Starts after the first frame, which frames the character.
  if (steps.document != state.session.documentsOpened || state.open.frameWanted) {
    steps.document = state.session.documentsOpened;
    steps.stand = camera.stand;
    steps.rig = std::make_shared<const Rig>(state.document.rig());
    return;
  }
  const auto tick = [&](FirstStep step, bool done) {
    bool& own = steps.done[static_cast<std::size_t>(step)];
    own = own || done;
  };
  const float turned =
      std::max(std::abs(camera.stand.yaw - steps.stand.yaw), std::abs(camera.stand.pitch - steps.stand.pitch));
  tick(FirstStep::kTurn, turned > kTurned && !camera.transition);
  tick(FirstStep::kSelect, !state.document.selection.primitives.empty());
  const Rig& rig = state.document.rig();
  const bool idle = !state.document.commands.inGesture();
  tick(FirstStep::kScale, idle && isScaled(*steps.rig, rig));
  tick(FirstStep::kAdd, idle && rig.primitives.size() > steps.rig->primitives.size());
  tick(FirstStep::kCompare, state.document.visibility.bare);
}

bool firstStepsDone(const FirstStepsState& steps) {
  return std::ranges::all_of(steps.done, [](bool done) { return done; });
}

namespace {

namespace fs = std::filesystem;

struct KnownSample {
  const char* stem;
  const char* name;
};

/// In menu order. Other files are named after their stems.
constexpr std::array kKnownSamples{
    KnownSample{"humanoid", "Humanoid"},
    KnownSample{"humanoid-flex", "Humanoid flexing"},
    KnownSample{"humanoid-wrapped", "Humanoid wrapped"},
    KnownSample{"horse", "Horse"},
    KnownSample{"horse-flex", "Horse flexing"},
    KnownSample{"horse-wrapped", "Horse wrapped"},
    KnownSample{"demo", "Lizard"},
    KnownSample{"wrapped", "Wrapped body"},
    KnownSample{"tangle", "Tangle"},
};

std::string stemOf(const fs::path& file) { return withoutEnding(file.filename().string()).value_or(std::string()); }

std::string titleOfStem(std::string stem) {
  std::ranges::replace(stem, '_', ' ');
  std::ranges::replace(stem, '-', ' ');
  if (!stem.empty()) stem[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(stem[0])));
  return stem;
}

std::size_t rankOf(const std::string& stem) {
  const auto known = std::ranges::find(kKnownSamples, stem, &KnownSample::stem);
  return static_cast<std::size_t>(known - kKnownSamples.begin());
}

/// The first heading.
std::string headingOf(const fs::path& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("# ")) return line.substr(2);
  }
  return file.stem().string();
}

std::vector<HelpPage> readPages() {
  std::vector<HelpPage> pages;
  const fs::path folder = pagesFolder();
  std::error_code failed;
  if (folder.empty()) return pages;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
    const fs::path& file = entry.path();
    if (file.extension() == ".md") pages.push_back({file.stem().string(), headingOf(file), file});
  }
  std::ranges::sort(pages, {}, &HelpPage::title);
  return pages;
}

void sayWhereItLies(EditorState& state, const fs::path& file) {
  addMessage(state.session, MessageKind::kWarning, "No program opens this page: " + file.string(),
             MessageAbout::kProgram);
}

/// Removes it from the list and returns it.
LeftBehind takeLeftBehind(EditorState& state, const fs::path& file) {
  const auto found = std::ranges::find(state.session.leftBehind, file, &LeftBehind::file);
  if (found == state.session.leftBehind.end()) return {};
  LeftBehind left = std::move(*found);
  state.session.leftBehind.erase(found);
  return left;
}

}  // namespace

std::vector<Sample> samples() {
  std::vector<std::pair<std::string, fs::path>> rigs;
  std::vector<std::pair<std::string, fs::path>> characters;
  std::error_code failed;
  for (fs::directory_iterator it(dataFile("assets"), failed); !failed && it != fs::directory_iterator();
       it.increment(failed)) {
    const std::string stem = stemOf(it->path());
    if (stem.empty()) continue;
    (it->path().extension() == ".json" ? rigs : characters).emplace_back(stem, it->path());
  }
  std::erase_if(characters, [&](const auto& character) {
    return std::ranges::any_of(rigs, [&](const auto& rig) { return rig.first == character.first; });
  });
  rigs.insert(rigs.end(), characters.begin(), characters.end());
  std::ranges::sort(rigs, [](const auto& a, const auto& b) {
    return std::pair(rankOf(a.first), a.first) < std::pair(rankOf(b.first), b.first);
  });
  std::vector<Sample> found;
  for (const auto& [stem, file] : rigs) {
    const std::size_t rank = rankOf(stem);
    found.push_back({rank < kKnownSamples.size() ? kKnownSamples[rank].name : titleOfStem(stem), file});
  }
  return found;
}

fs::path firstSample() {
  for (const char* file : {"assets/humanoid.rig.json", "assets/demo.rig.json"}) {
    std::error_code failed;
    if (fs::is_regular_file(dataFile(file), failed)) return dataFile(file);
  }
  return {};
}

bool isSample(const fs::path& file) {
  std::error_code failed;
  return !file.empty() && fs::equivalent(file.parent_path(), dataFile("assets"), failed) && !failed;
}

fs::path workFolder(const fs::path& file) {
  std::error_code ignored;
  return isSample(file) ? homeFolder() : fs::absolute(file, ignored).lexically_normal().parent_path();
}

void rememberDocument(EditorState& state) {
  const fs::path& file = state.document.file();
  if (!file.empty() && !isSample(file)) rememberFile(state.session.preferences.recentFiles, file);
}

void recover(EditorState& state, const fs::path& recoveryFile) {
  LeftBehind left = takeLeftBehind(state, recoveryFile);
  if (left.file.empty()) return;
  Result<Document> recovered = recoverDocument(left);
  if (!recovered) {
    addMessage(state.session, MessageKind::kError,
               "Not recovered: " + recovered.error().plainText() + "; it is kept as " + left.file.string());
    return;
  }
  if (showDocument(state, std::move(recovered).value())) state.session.recovered = std::move(left);
}

void discardRecovery(EditorState& state, const fs::path& recoveryFile) {
  const LeftBehind left = takeLeftBehind(state, recoveryFile);
  if (!left.file.empty()) discardLeftBehind(left);
}

const std::vector<HelpPage>& helpPages() {
  static const std::vector<HelpPage> pages = readPages();
  return pages;
}

void openHelpPage(EditorState& state, const HelpPage& page) {
  if (!state.session.opener.open(page.file)) sayWhereItLies(state, page.file);
}

void followOpenedPages(EditorState& state) {
  for (const fs::path& file : state.session.opener.failed()) sayWhereItLies(state, file);
}

void showPalette(Dialogs& dialogs) {
  dialogs.palette = {};
  dialogs.palette.shown = dialogs.palette.appearing = true;
}

void jumpToMuscle(EditorState& state, PrimitiveId primitive) {
  if (!state.hasCharacter() || findPrimitive(state.document.rig(), primitive) < 0) return;
  state.document.selection.set(primitive);
  state.document.selection.bone = -1;
  state.view.outlinerFilter.clear();
  frameSelection(state, true);
}

void jumpToBone(EditorState& state, int bone) {
  if (!state.hasCharacter() || bone < 0 || bone >= static_cast<int>(state.character().skeleton.bones.size())) return;
  state.document.selection.clear();
  state.document.selection.bone = bone;
  state.view.outlinerFilter.clear();
  // With surroundings of a tenth of the character's height.
  const glm::vec3 center(at(state.live->pose().boneInWorld, bone)[3]);
  Bounds bounds;
  bounds.add(center - glm::vec3(0.1f * state.character().height));
  bounds.add(center + glm::vec3(0.1f * state.character().height));
  frameInPicture(state, bounds, true);
}

Preferences currentPreferences(const EditorState& state) {
  Preferences preferences = state.session.preferences;
  preferences.layout = state.view.layout;
  return preferences;
}

}  // namespace sinew::app
