// tests/panels/soak_test.cpp: long session: rounds of playback and editing that end in their initial state.
//
// Environment: SINEW_SOAK_FRAMES, number of frames (2,000). tests/limits/soak.py runs many and prints a summary.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <numeric>

#include <malloc.h>
#include <unistd.h>

#include "sinew/files/rig_json.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

constexpr std::size_t kWarmUp = 4;    ///< Rounds until everything was shown and done once and the used heap is stable.
constexpr double kWarmUpShare = 0.1;  ///< Fraction of all frames until heap fragmentation is stable too.
constexpr double kMostGrowth = 0.02;
constexpr std::array kBones{0, 5};  ///< For muscles, alternating.

/// Bytes. Resident memory exceeds used memory: freed blocks, and program pages loaded on first use.
struct Memory {
  double inUse = 0.0;      ///< Used heap.
  double resident = 0.0;   ///< Resident set.
  double ofFiles = 0.0;    ///< Part of it that maps the program and its libraries.
  double withoutFree = 0;  ///< Resident without file pages, after the heap released free memory.
};

/// Frame times, stored in the same memory after 100,000 frames as after one, so that all growth is the editor's.
class Times {
 public:
  void add(double seconds) {
    ++counts_[stepOf(seconds)];
    longest_ = std::max(longest_, seconds);
  }
  void add(const Times& others) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += others.counts_[i];
    longest_ = std::max(longest_, others.longest_);
  }
  [[nodiscard]] std::size_t count() const { return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0}); }
  [[nodiscard]] double longest() const { return longest_; }
  [[nodiscard]] double median() const {  ///< Accurate to 3 %.
    std::size_t step = 0;
    for (std::size_t below = counts_[0]; 2 * below < count(); below += counts_[step]) ++step;
    return kShortest * std::exp2((static_cast<double>(step) + 0.5) / kSteps);
  }
  [[nodiscard]] std::size_t over(double seconds) const {
    return std::accumulate(counts_.begin() + static_cast<std::ptrdiff_t>(stepOf(seconds)), counts_.end(),
                           std::size_t{0});
  }

 private:
  [[nodiscard]] std::size_t stepOf(double seconds) const {
    const double step = kSteps * std::log2(std::max(seconds, kShortest) / kShortest);
    return std::min(static_cast<std::size_t>(step), counts_.size() - 1);
  }

  static constexpr double kShortest = 1e-6;
  static constexpr double kSteps = 12.0;  ///< Bins for each doubling.
  std::array<std::size_t, 300> counts_{};
  double longest_ = 0.0;
};

double bytesInUse() {
  const struct mallinfo2 heap = ::mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

/// Bytes: all, resident, of files.
std::array<double, 3> bytesHeld() {
  std::ifstream file("/proc/self/statm");
  std::array<double, 3> numbers{};
  for (double& each : numbers) {
    file >> each;
    each *= static_cast<double>(::sysconf(_SC_PAGESIZE));
  }
  return numbers;
}

double bytesResident() { return bytesHeld()[1]; }

Memory memoryNow() {
  const auto before = bytesHeld();
  const double inUse = bytesInUse();
  ::malloc_trim(0);
  const auto after = bytesHeld();
  return {inUse, before[1], before[2], after[1] - after[2]};
}

/// Time of this thread, so that other programs do not count.
double processorSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Soak : public HeadlessEditor {
 protected:
  /// Runs and times frames of one kind of action.
  void pass(const std::string& what, std::size_t count = 1) {
    for (std::size_t i = 0; i < count; ++i) {
      const double before = processorSeconds();
      frame();
      times[what].add(processorSeconds() - before);
      ++frames;
    }
  }
  void finish(const std::string& what) {
    while (queue.pending()) pass(what);
    pass(what, 2);
  }
  void act(const char* id) {
    run(action(id), state);
    pass(id);
  }
  void pull(const std::string& what, const glm::vec2& from, const glm::vec2& pace, int button) {
    queue.move(from);
    finish(what);
    queue.button(button, true);
    for (int i = 1; i <= 12; ++i) {
      queue.move(from + static_cast<float>(i) * pace);
      pass(what);
    }
    queue.button(button, false);
    finish(what);
  }
  void keys(const std::string& what, std::initializer_list<int> pressed) {
    for (const int key : pressed) {
      queue.key(key, true);
      queue.key(key, false);
      finish(what);
    }
  }

  void play() {
    const auto clips = state.character().clips.size();
    if (clips > 0)
      chooseClip(state.open.transport, static_cast<int>(inUse.size() % std::min<std::size_t>(clips, 2)),
                 state.character());
    state.open.transport.playing = true;
    pass("play", 120);
  }
  void look() {
    const glm::vec4 box = state.frame.viewport;
    const glm::vec2 corner(box.x + 0.5f * box.z, box.y + box.w - 12.0f);
    pull("orbit", corner, {5.0f, -0.5f}, 1);
    queue.move(glm::vec2(box) + 0.5f * glm::vec2(box.z, box.w));
    queue.scroll({0.0f, 2.0f});
    finish("zoom");
    act("view/frame-all");
    pass("frame all", 30);
  }
  void build() {
    addMuscle(state, kBones[inUse.size() % kBones.size()]);
    pass("add a muscle", 5);
    if (shown("inspector/radius.x")) pull("pull a number", center("inspector/radius.x"), {2.0f, 0.0f}, 0);
    act("edit/duplicate");
    act("edit/mirror");
    act("edit/group");
    keys("name a group", {kEnter});
    act("edit/select-all");
    act("view/flex");
    pass("play flexed", 30);
    act("view/flex");
    act("view/hide");
    pass("play without muscles", 10);
    act("view/show-all");
    act("edit/delete");
    pass("play", 10);
  }
  void browse() {
    for (const LeftTab tab : {LeftTab::kGroups, LeftTab::kLibrary, LeftTab::kShapes, LeftTab::kMuscles}) {
      state.view.outliner.tab = tab;
      pass("a tab of the left column", 3);
    }
    act("help/palette");
    queue.character('b');
    finish("the palette");
    keys("the palette", {kEscape});
    for (const char* id : {"view/clay", "view/heat", "view/textured"}) act(id);
  }
  void takeBack() {
    const std::size_t steps = state.document.commands.position();
    for (std::size_t i = 0; i < steps; ++i) act("edit/undo");
    for (std::size_t i = 0; i < steps; ++i) act("edit/redo");
    jumpTo(state, 0);
    pass("jump to the start");
    // The same step each time: redo keeps nothing of this round.
    addMuscle(state, 0);
    pass("add a muscle");
    act("edit/undo");
    selectNothing(state);
    state.open.transport.playing = false;
    finish("rest");
  }
  void round() {
    play();
    look();
    build();
    browse();
    takeBack();
    inUse.push_back(bytesInUse());
    resident.push_back(bytesResident());
    if (warm.inUse == 0.0 && inUse.size() >= kWarmUp && frames >= warmUpFrames) warm = memoryNow();
  }

  /// Prints a line "soak: ..." for each.
  void print() const {
    Times all;
    for (const auto& [what, each] : times) all.add(each);
    const double median = all.median();
    std::printf("soak: %zu frames, %zu rounds; median %.3f ms\n", frames, inUse.size(), 1e3 * median);
    for (const auto& [what, each] : times) {
      std::printf("soak: %-26s %7zu frames, median %8.3f ms, longest %8.3f ms, %6zu over 10 medians of all\n",
                  what.c_str(), each.count(), 1e3 * each.median(), 1e3 * each.longest(), each.over(10.0 * median));
    }
    printTenths("heap in use", inUse);
    printTenths("resident", resident);
    const Memory last = memoryNow();
    printGrowth("in use", warm.inUse, last.inUse);
    printGrowth("held", warm.withoutFree, last.withoutFree);
    printGrowth("resident", warm.resident, last.resident);
    printGrowth("of files", warm.ofFiles, last.ofFiles);
  }
  static void printTenths(const char* what, const std::vector<double>& rounds) {
    std::printf("soak: %s in KiB, at tenths:", what);
    for (std::size_t tenth = 1; tenth <= 10; ++tenth) {
      std::printf(" %.1f", rounds[(rounds.size() - 1) * tenth / 10] / 1024.0);
    }
    std::printf("\n");
  }
  static void printGrowth(const char* what, double before, double after) {
    std::printf("soak: %-8s %9.1f KiB after warm-up, %9.1f KiB at the end, %.2f %% more\n", what, before / 1024.0,
                after / 1024.0, 100.0 * (after / before - 1.0));
  }

  std::map<std::string, Times> times;  ///< By kind of action.
  std::vector<double> inUse;           ///< Used heap in bytes after each round.
  std::vector<double> resident;        ///< Resident bytes after each round.
  Memory warm;
  std::size_t warmUpFrames = 0;
  std::size_t frames = 0;
};

TEST_F(Soak, EveryRoundRestoresTheRig) {
  const char* const asked = std::getenv("SINEW_SOAK_FRAMES");
  const std::size_t wanted = asked == nullptr ? 2000 : static_cast<std::size_t>(std::atoll(asked));
  const std::string before = rigToJson(state.document.rig());
  warmUpFrames = static_cast<std::size_t>(kWarmUpShare * static_cast<double>(wanted));
  inUse.reserve(wanted / 100 + kWarmUp + 2);
  resident.reserve(wanted / 100 + kWarmUp + 2);
  while (frames < wanted || inUse.size() < kWarmUp + 2) {
    round();
    ASSERT_EQ(rigToJson(state.document.rig()), before) << "round " << inUse.size();
    ASSERT_FALSE(HasFailure()) << "round " << inUse.size();
  }
  print();
  EXPECT_LE(inUse.back(), (1.0 + kMostGrowth) * inUse[kWarmUp - 1]);
}

}  // namespace
}  // namespace sinew::app
