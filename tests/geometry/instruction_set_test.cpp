// tests/geometry/instruction_set_test.cpp: choice of the instruction set, and machines that lack some.
#include "core/geometry/instruction_set.h"

#include <gtest/gtest.h>

#include "hwy/targets.h"

namespace sinew::test {
namespace {

TEST(InstructionSetScope, RestoresThePreviousChoice) {
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

TEST(Processor, IsRefusedWithoutSse4) {
  EXPECT_TRUE(checkProcessor());
  hwy::SetSupportedTargetsForTest(HWY_SCALAR);
  const Result<void> refused = checkProcessor();
  hwy::SetSupportedTargetsForTest(0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), "this processor lacks SSE4.2 with AES and CLMUL, which Sinew needs");
}

}  // namespace
}  // namespace sinew::test
