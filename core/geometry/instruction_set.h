// core/geometry/instruction_set.h: the choice of vector instructions.
#pragma once

#include <span>

#include "sinew/geometry/result.h"

namespace sinew {

/// kAuto: the widest available. kScalar: projects vertex by vertex in double precision, as the reference for the vector
/// code and as its fallback; other stages treat it as kAuto.
enum class InstructionSet { kAuto, kScalar, kSse4, kAvx2, kAvx512 };

[[nodiscard]] const char* nameOf(InstructionSet set);

[[nodiscard]] Result<void> checkProcessor();  ///< Error: the processor lacks SSE4, which every kernel needs.

/// Sets that this machine runs, kScalar first, without kAuto.
[[nodiscard]] std::span<const InstructionSet> availableInstructionSets();

/// The chosen set, never kAuto. All sets but kScalar give the same results bit for bit.
[[nodiscard]] InstructionSet chosenInstructionSet();
/// The chosen set for stages that only have kernels. checkProcessor() must have succeeded.
[[nodiscard]] InstructionSet chosenVectorSet();
InstructionSet chooseInstructionSet(InstructionSet set);  ///< For tests and measurements. Returns the previous choice.

/// Chooses a set for its lifetime.
class InstructionSetScope {
 public:
  explicit InstructionSetScope(InstructionSet set) : former_(chooseInstructionSet(set)) {}
  ~InstructionSetScope() { chooseInstructionSet(former_); }
  InstructionSetScope(const InstructionSetScope&) = delete;
  InstructionSetScope& operator=(const InstructionSetScope&) = delete;

 private:
  InstructionSet former_;
};

}  // namespace sinew
