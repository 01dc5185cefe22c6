// tests/document/selection_test.cpp: picking.

#include "app/document/document.h"

#include <gtest/gtest.h>

namespace sinew::app {
namespace {

constexpr PrimitiveId kA{1};
constexpr PrimitiveId kB{2};
constexpr PrimitiveId kC{3};

TEST(Selection, LastPickedIsActive) {
  Selection selection;
  EXPECT_FALSE(selection.active());
  selection.toggle(kA);
  selection.toggle(kB);
  EXPECT_EQ(selection.active(), kB);
  selection.toggle(kB);
  EXPECT_EQ(selection.active(), kA);
  EXPECT_FALSE(selection.contains(kB));
}

TEST(Selection, SetReplacesTheSelection) {
  Selection selection;
  selection.toggle(kA);
  selection.toggle(kB);
  selection.set(kC);
  EXPECT_EQ(selection.primitives, std::vector<PrimitiveId>{kC});
}

TEST(Selection, ClearAlsoDeselectsTheBone) {
  Selection selection;
  selection.toggle(kA);
  selection.bone = 3;
  selection.clear();
  EXPECT_TRUE(selection.primitives.empty());
  EXPECT_EQ(selection.bone, -1);
}

}  // namespace
}  // namespace sinew::app
