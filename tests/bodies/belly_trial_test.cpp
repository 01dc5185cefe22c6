// tests/bodies/belly_trial_test.cpp: a trial of one muscle gives the same result as check() of its rig, wherever it
// starts.

#include "core/bodies/check.h"

#include <gtest/gtest.h>

#include "core/bodies/motions.h"
#include "core/rig/line_edit.h"
#include "tests/bodies/drawn_muscles.h"

namespace sinew::test {
namespace {

struct BellyTrials : testing::Test {
  const std::shared_ptr<const Character> character = bundledCharacter("humanoid.glb");
  const Motions motions{character};
  const std::vector<BellyChoice> drawn = drawnMuscles(*character, 2, 3);
};

TEST_F(BellyTrials, AgreeWithTheCheck) {
  int clean = 0;
  for (const BellyChoice& choice : drawn) {
    const BellyTrial trial(choice, SurfaceSettings{}, motions);
    ASSERT_TRUE(trial.canTell());
    const bool isClean = trial.trouble() <= 1.0f;
    EXPECT_EQ(isClean, check(rigOf(choice), motions).empty()) << choice.line->insertion.bone;
    clean += isClean ? 1 : 0;
  }
  EXPECT_GT(clean, 0);
  EXPECT_LT(clean, static_cast<int>(drawn.size())) << "else this says nothing";
}

TEST_F(BellyTrials, DoNotDependOnTheFirstPose) {
  std::mt19937 random(9);
  for (const BellyChoice& choice : drawn) {
    const BellyTrial trial(choice, SurfaceSettings{}, motions);
    const float whole = trial.trouble();
    std::size_t first = random() % motions.poses().size();
    const float enough = kMendedMargin;
    EXPECT_EQ(trial.trouble(enough, &first) > enough, whole > enough);
    // That pose alone is enough, and gives no more than all poses.
    const float again = trial.trouble(enough, &first);
    EXPECT_LE(again, whole);
    EXPECT_EQ(again > enough, whole > enough);
    EXPECT_LT(first, motions.poses().size());
  }
}

TEST_F(BellyTrials, LinesLearnTheSameFromPosesAsFromClips) {
  const Character& moving = motions.character();
  int shortened = 0;
  for (const BellyChoice& choice : drawn) {
    MuscleLine line = *choice.line;
    line.settings.full = 0.123f;
    learnFull(line, motions);
    const LineLengths lengths = lengthsOver(lineRest(*choice.line, moving).value(), moving, moving.clips);
    const bool shortens = lengths.secondPercentile < kMostFull;
    EXPECT_EQ(line.settings.full, shortens ? std::max(lengths.secondPercentile, kLeastFull) : 0.123f);
    shortened += shortens ? 1 : 0;
  }
  EXPECT_GT(shortened, 0);
}

}  // namespace
}  // namespace sinew::test
