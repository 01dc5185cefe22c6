// tests/lanes/instruction_set_test.cpp: which instructions are chosen.
#include "core/lanes/instruction_set.h"

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

TEST(InstructionSetScope, LeavesWhatWasChosenBefore) {
  const InstructionSet widest = chosenInstructionSet();
  {
    const InstructionSetScope outer(InstructionSet::kScalar);
    {
      const InstructionSetScope inner(InstructionSet::kSse4);
      EXPECT_EQ(chosenInstructionSet(), InstructionSet::kSse4);
    }
    EXPECT_EQ(chosenInstructionSet(), InstructionSet::kScalar);
    EXPECT_EQ(chosenVectorSet(), widest);
  }
  EXPECT_EQ(chosenInstructionSet(), widest);
}

}  // namespace
}  // namespace sinew::test
