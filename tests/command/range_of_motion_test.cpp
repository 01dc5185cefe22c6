// tests/command/range_of_motion_test.cpp: the generated range-of-motion clip, selected by name.

#include "tests/command/program.h"

namespace sinew::test {
namespace {

class RangeOfMotion : public Program {
 protected:
  /// File written by `sinew smooth`.
  std::string surface(std::vector<std::string> options) {
    std::vector<std::string> arguments{"smooth", demo("demo.glb"), "-o", "out.obj", "--depth", "1"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return readWholeFile(folder_ / "out.obj", 1 << 26).value();
  }
};

TEST_F(RangeOfMotion, StartsInTheBindPoseAndMoves) {
  const std::string bound = surface({});
  EXPECT_EQ(surface({"--clip", "Range of motion"}), bound);
  const std::string moved = surface({"--clip", "Range of motion", "--time", "0.375"});
  EXPECT_NE(moved, bound);
  EXPECT_EQ(surface({"--clip", "Range of motion", "--time", "0.375"}), moved);
}

TEST_F(RangeOfMotion, NameIsCaseSensitive) {
  const Outcome outcome = run({"smooth", demo("demo.glb"), "-o", "out.obj", "--clip", "range of motion"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.oneErrorLine()) << outcome.error;
}

}  // namespace
}  // namespace sinew::test
