// tests/panels/soak_test.cpp: a long session: rounds of playing and editing that end where they began.
//
// SINEW_SOAK_FRAMES in the environment: how many frames, 2,000 without it. tests/limits/soak.py runs many and prints
// what they come to.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>

#include <malloc.h>
#include <unistd.h>

#include "sinew/io/rig_json.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

constexpr std::size_t kWarmUp = 4;  ///< Rounds until everything has been shown and done once.
constexpr std::array kBones{0, 5};  ///< For muscles, in turn.

struct RoundEnd {
  std::size_t frames = 0;
  double heap = 0.0;      ///< Bytes in use.
  double resident = 0.0;  ///< Bytes of memory that the process holds.
};

double bytesOnHeap() {
  const struct mallinfo2 heap = ::mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

double bytesResident() {
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Of this thread: what other programs take does not count.
double processorSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

class Soak : public HeadlessEditor {
 protected:
  /// Frames in which the hand does this; each is timed.
  void pass(const std::string& what, std::size_t count = 1) {
    for (std::size_t i = 0; i < count; ++i) {
      const double before = processorSeconds();
      frame();
      times[what].push_back(processorSeconds() - before);
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
      chooseClip(state.open.transport, static_cast<int>(rounds.size() % std::min<std::size_t>(clips, 2)),
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
    addMuscle(state, kBones[rounds.size() % kBones.size()]);
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
    rounds.push_back({frames, bytesOnHeap() - bytesOfTimes(), bytesResident()});
  }

  /// What this test itself writes down.
  [[nodiscard]] double bytesOfTimes() const {
    std::size_t numbers = 0;
    for (const auto& [what, seconds] : times) numbers += seconds.capacity();
    return static_cast<double>(numbers * sizeof(double) + rounds.capacity() * sizeof(RoundEnd));
  }
  /// "soak: ..." a line each.
  void print() const {
    std::vector<double> all;
    for (const auto& [what, seconds] : times) all.insert(all.end(), seconds.begin(), seconds.end());
    const double median = medianOf(all);
    const RoundEnd& first = rounds[kWarmUp - 1];
    const RoundEnd& last = rounds.back();
    std::printf("soak: %zu frames, %zu rounds; median %.3f ms\n", frames, rounds.size(), 1e3 * median);
    for (const auto& [what, seconds] : times) {
      const auto slow = std::ranges::count_if(seconds, [&](double each) { return each > 10.0 * median; });
      std::printf("soak: %-26s %7zu frames, median %8.3f ms, longest %8.3f ms, %6td over 10 medians of all\n",
                  what.c_str(), seconds.size(), 1e3 * medianOf(seconds), 1e3 * std::ranges::max(seconds), slow);
    }
    std::printf("soak: resident %.2f MiB after warm-up, %.2f MiB at the end, %.2f %% more\n",
                first.resident / 1048576.0, last.resident / 1048576.0, 100.0 * (last.resident / first.resident - 1.0));
    std::printf("soak: heap in KiB, at tenths:");
    for (std::size_t tenth = 1; tenth <= 10; ++tenth) {
      std::printf(" %.0f", rounds[(rounds.size() - 1) * tenth / 10].heap / 1024.0);
    }
    std::printf("\n");
    std::printf("soak: heap %.1f KiB after warm-up, %.1f KiB at the end, %.1f bytes a round\n", first.heap / 1024.0,
                last.heap / 1024.0, leftPerRound());
  }
  [[nodiscard]] double leftPerRound() const {
    return (rounds.back().heap - rounds[kWarmUp - 1].heap) / static_cast<double>(rounds.size() - kWarmUp);
  }

  std::map<std::string, std::vector<double>> times;  ///< Seconds a frame, by what was done.
  std::vector<RoundEnd> rounds;
  std::size_t frames = 0;
};

TEST_F(Soak, EveryRoundEndsWhereItBegan) {
  const char* const asked = std::getenv("SINEW_SOAK_FRAMES");
  const std::size_t wanted = asked == nullptr ? 2000 : static_cast<std::size_t>(std::atoll(asked));
  const std::string before = rigToJson(state.document.rig());
  while (frames < wanted || rounds.size() < kWarmUp + 2) {
    round();
    ASSERT_EQ(rigToJson(state.document.rig()), before) << "round " << rounds.size();
    ASSERT_FALSE(HasFailure()) << "round " << rounds.size();
  }
  print();
}

}  // namespace
}  // namespace sinew::app
