// core/geometry/instruction_set.h: which vector instructions are used.
#pragma once

#include <span>

#include "sinew/geometry/result.h"

namespace sinew {

/// kAuto: the widest this machine has. kScalar: the projection goes vertex by vertex, in double precision: the
/// reference of its vectors, and the way for what they give up; all other stages take it for kAuto.
enum class InstructionSet { kAuto, kScalar, kSse4, kAvx2, kAvx512 };

[[nodiscard]] const char* nameOf(InstructionSet set);

/// Error: this processor lacks SSE4, without which no kernel runs.
[[nodiscard]] Result<void> checkProcessor();

/// Those that this machine runs, kScalar first; kAuto is not among them.
[[nodiscard]] std::span<const InstructionSet> availableInstructionSets();

/// What kAuto means to this process. For tests and measurements: all sets but kScalar give the same bits.
[[nodiscard]] InstructionSet chosenInstructionSet();
/// The same for stages that have kernels alone. checkProcessor() must have succeeded.
[[nodiscard]] InstructionSet chosenVectorSet();
/// Returns what was chosen before.
InstructionSet chooseInstructionSet(InstructionSet set);

/// Chooses a set while it lives; then what was chosen before.
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
