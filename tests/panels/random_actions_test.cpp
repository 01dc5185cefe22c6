// tests/panels/random_actions_test.cpp: random actions in any order: undo restores every history step byte for byte.
//
// Environment: SINEW_SOAK_ACTIONS, number of actions (150, in the long run 250); SINEW_SOAK_SEED, their seed.

#include <cstdlib>
#include <iostream>
#include <map>
#include <random>

#include "app/editor/blending_edit.h"
#include "app/editor/edit.h"
#include "app/editor/outliner.h"
#include "core/rig/validation.h"
#include "sinew/files/rig_json.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/long_run.h"

namespace sinew::app {
namespace {

constexpr std::size_t kMostMuscles = 14;  ///< More make the test slow, not better.
constexpr int kSeldom = 12;               ///< Factor by which slow actions are rarer.

/// Excluded: they open a document, which starts another history.
const std::set<std::string_view> kOpen{"file/reopen", "help/first-steps"};
/// Slow: a whole set, a check of all clips, a character of a hundred thousand triangles.
const std::set<std::string_view> kSlow{"muscles/add-set", "play/check", "view/auto-depth"};

std::size_t numberFrom(const char* variable, std::size_t otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : static_cast<std::size_t>(std::atoll(text));
}

/// State that a history step restores.
struct Moment {
  std::string rig;
  PoseOverrides pose;
  KeptPlayRanges ranges;

  friend bool operator==(const Moment&, const Moment&) = default;
};

bool asks(const Dialogs& dialogs) {
  return dialogs.conflict.found != OnDisk::kSame || dialogs.question.kind != IntentKind::kNone ||
         dialogs.exportQuestion || dialogs.file.kind != DialogKind::kNone ||
         dialogs.exporting.shown != ExportDialog::kNone || !dialogs.locate.rigFile.empty() ||
         !dialogs.keepMuscles.empty() || dialogs.recovery || dialogs.preferences || dialogs.palette.shown ||
         dialogs.keySheet;
}

class RandomActions : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    for (const Action& each : actions()) {
      if (!kOpen.contains(each.id)) table.push_back(&each);
    }
    moments = {now()};
  }

  std::size_t below(std::size_t count) { return random() % count; }
  bool oneIn(std::size_t count) { return below(count) == 0; }
  float within(float low, float high) {
    return low + (high - low) * static_cast<float>(random()) / static_cast<float>(std::mt19937::max());
  }
  [[nodiscard]] std::size_t muscles() const { return state.document.rig().primitives.size(); }

  [[nodiscard]] Moment now() const {
    const CommandStack& commands = state.document.commands;
    return {rigToJson(commands.rig()), commands.pose(), commands.ranges()};
  }

  // Choice of actions -----------------------------------------------------------------------------------------------

  void chooseMuscles(std::size_t most) {
    state.document.selection.clear();
    if (muscles() == 0) return;
    for (std::size_t i = 1 + below(most); i > 0; --i) {
      state.document.selection.toggle(state.document.idAt(static_cast<int>(below(muscles()))));
    }
  }
  void chooseSomething() {
    const std::size_t bones = state.character().skeleton.bones.size();
    const auto& groups = state.document.rig().groups;
    switch (below(8)) {
      case 0:
      case 1:
      case 2:
        return chooseMuscles(3);
      case 3:
      case 4:
        state.document.selection.clear();
        state.document.selection.bone = static_cast<int>(below(bones));
        return;
      case 5:
        state.open.blending.group = groups.empty() ? GroupId{} : groups[below(groups.size())].id();
        return;
      case 6:
        chooseClip(state.open.transport, static_cast<int>(below(state.character().clips.size() + 1)) - 1,
                   state.character());
        state.open.transport.time = within(0.0f, 0.9f) * clipDuration(state.open.transport, state.character());
        return;
      default:
        state.view.outliner.tab = static_cast<LeftTab>(below(4));
    }
  }

  // Execution -------------------------------------------------------------------------------------------------------

  std::string turnJoint() {
    const auto bone = static_cast<int>(below(state.character().skeleton.bones.size()));
    const glm::vec3 axis(within(-1, 1), within(-1, 1), 1.5f);
    state.open.transport.overrides.set(bone, glm::angleAxis(within(-0.5f, 0.5f), glm::normalize(axis)));
    keepPose(state, "Turn joint");
    return "a turned joint";
  }
  std::string placeMuscle() {
    if (muscles() == 0) return "";
    const auto index = static_cast<int>(below(muscles()));
    Placement placement = state.document.rig().primitives[static_cast<std::size_t>(index)].placement;
    placement.center += 0.02f * glm::vec3(within(-1, 1), within(-1, 1), within(-1, 1));
    placement.radii *= within(0.8f, 1.2f);
    edit(state, "Place muscle", setPlacement(state.document.rig(), index, placement));
    return "a placed muscle";
  }
  std::string moveToBone() {
    const std::vector<int> chosen = selectedIndices(state.document);
    if (chosen.empty()) return "";
    reparentMuscles(state, chosen, static_cast<int>(below(state.character().skeleton.bones.size())));
    return "another bone";
  }
  std::string link() {
    const std::size_t groups = state.document.rig().groups.size();
    if (groups < 2) return "";
    const auto one = static_cast<int>(below(groups));
    const auto other = static_cast<int>(below(groups));
    if (one != other) toggleLink(state, one, other);
    return "a link";
  }
  std::string travel() {
    jumpTo(state, below(state.document.commands.stepCount() + 1));
    travels = true;
    return "a jump in the history";
  }
  std::string fromTable() {
    const Action& action = *table[below(table.size())];
    if (kSlow.contains(action.id) && !oneIn(kSlow.size() * kSeldom)) return "";
    if (!action.enabled(state)) return "";
    travels = action.id == std::string_view("edit/undo") || action.id == std::string_view("edit/redo");
    run(action, state);
    return action.id;
  }
  /// @return description of the action; "": none was possible
  std::string act() {
    travels = false;
    if (muscles() > kMostMuscles) {
      chooseMuscles(muscles());
      deleteSelection(state);
      return "many deleted";
    }
    switch (below(16)) {
      case 0:
        return turnJoint();
      case 1:
        return placeMuscle();
      case 2:
        return moveToBone();
      case 3:
        return link();
      case 4:
        return oneIn(4) ? travel() : "";
      default:
        return fromTable();
    }
  }

  /// Finishes open interactions: drags and names are kept or canceled, dialogs closed.
  void answer() {
    for (int tries = 0; tries < 8; ++tries) {
      if (ownsKeyboard(state.view.tools)) {
        queue.move(glm::vec2(state.frame.viewport) + glm::vec2(within(100, 400), within(100, 400)));
        frame();
        press(oneIn(3) ? kEscape : kEnter);
      } else if (asks(state.dialogs) || state.open.library.naming) {
        press(kEscape);
      } else if (ImGui::IsAnyItemActive() || state.open.gestureItem != 0) {
        press(oneIn(3) ? kEscape : kEnter);
      } else {
        break;
      }
    }
    state.session.quit = false;
    state.session.pictureWanted.reset();  // The window would write it.
  }

  // Invariants ------------------------------------------------------------------------------------------------------

  /// Compares every step with its state when it was made.
  void expectHistory(std::size_t before) {
    const CommandStack& commands = state.document.commands;
    const std::size_t at = commands.position();
    if (!travels && at != before) {
      ASSERT_EQ(at, before + 1) << "one action, one step";
      ASSERT_EQ(commands.stepCount(), at) << "a new step is the last";
      EXPECT_FALSE(commands.label(at).empty());
      moments.resize(at);
      moments.push_back(now());
      return;
    }
    ASSERT_EQ(commands.stepCount() + 1, moments.size());
    EXPECT_TRUE(now() == moments[at]) << "step " << at << " is another than it was";
  }
  void expectSound(const std::string& what) {
    EXPECT_FALSE(asks(state.dialogs)) << "a dialog does not close";
    EXPECT_FALSE(state.document.commands.inGesture());
    const auto valid = validate(state.document.rig());
    EXPECT_TRUE(valid.ok()) << valid.error().text();
    for (const glm::vec3& point : state.live->surface().positions) {
      ASSERT_TRUE(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
    }
    // A refused edit is reported quietly; an open list of messages means an error.
    const std::vector<Message>& messages = state.session.messages;
    if (state.session.messagesShown && what != "window/messages" && !messages.empty()) {
      EXPECT_NE(messages.back().kind, MessageKind::kError) << messages.back().text;
    }
  }

  std::vector<const Action*> table;
  std::vector<Moment> moments;  ///< [steps]
  bool travels = false;         ///< The last action moves in the history and adds no step.
  std::mt19937 random;
};

TEST_F(RandomActions, UndoToTheOriginalBytes) {
  const std::size_t seed = numberFrom("SINEW_SOAK_SEED", 11);
  const std::size_t count = numberFrom("SINEW_SOAK_ACTIONS", test::longRun() ? 250 : 150);
  random.seed(static_cast<std::mt19937::result_type>(seed));
  std::map<std::string, int> done;
  std::size_t most = 0;
  for (std::size_t number = 0; number < count;) {
    chooseSomething();
    state.session.messages.clear();
    state.session.messagesShown = false;
    const std::size_t before = state.document.commands.position();
    const std::string what = act();
    if (what.empty()) continue;
    frame();
    answer();
    const std::string trace = "seed " + std::to_string(seed) + ", action " + std::to_string(number) + ": " + what;
    SCOPED_TRACE(trace);
    expectHistory(before);
    expectSound(what);
    if (HasFailure()) break;
    ++done[what];
    ++number;
    most = std::max(most, moments.size());
  }
  // Undo step by step, redo all at once.
  CommandStack& commands = state.document.commands;
  const Moment last = now();
  const std::size_t end = commands.position();
  while (commands.canUndo()) {
    undo(state);
    ASSERT_TRUE(now() == moments[commands.position()]) << "seed " << seed << ", step " << commands.position();
  }
  EXPECT_EQ(now().rig, moments.front().rig);
  EXPECT_FALSE(commands.modified());
  jumpTo(state, end);
  EXPECT_TRUE(now() == last);
  frame();
  std::cout << "seed " << seed << ": " << count << " actions of " << done.size() << " kinds, up to " << most - 1
            << " steps, all undone\n";
}

}  // namespace
}  // namespace sinew::app
