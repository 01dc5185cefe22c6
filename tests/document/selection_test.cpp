// tests/document/selection_test.cpp: picking by name.

#include "app/document/selection.h"

#include <gtest/gtest.h>

namespace sinew::app {
namespace {

TEST(Selection, TheLastPickedIsActive) {
  Selection selection;
  EXPECT_EQ(selection.active(), "");
  selection.toggle("a");
  selection.toggle("b");
  EXPECT_EQ(selection.active(), "b");
  selection.toggle("b");
  EXPECT_EQ(selection.active(), "a");
  EXPECT_FALSE(selection.contains("b"));
}

TEST(Selection, SetLeavesOnlyThatOne) {
  Selection selection;
  selection.toggle("a");
  selection.toggle("b");
  selection.set("c");
  EXPECT_EQ(selection.primitives, std::vector<std::string>{"c"});
}

TEST(Selection, ClearLetsGoOfTheBoneToo) {
  Selection selection;
  selection.toggle("a");
  selection.bone = 3;
  selection.clear();
  EXPECT_TRUE(selection.primitives.empty());
  EXPECT_EQ(selection.bone, -1);
}

}  // namespace
}  // namespace sinew::app
