// core/lanes/instruction_set.h: which vector instructions are used.
#pragma once

#include <span>

namespace sinew {

/// kAuto: the widest this machine has. kPlain: the same operations, one lane at a time, where there are no others.
/// kScalar: vertex after vertex, without lanes, the references of tests: the projection's in double precision,
/// skinning's and the patches' with the same bits; to the rest it means kAuto.
enum class InstructionSet { kAuto, kScalar, kPlain, kSse4, kAvx2, kAvx512 };

[[nodiscard]] const char* nameOf(InstructionSet set);

/// Those that this machine runs, kScalar first; kAuto is not among them.
[[nodiscard]] std::span<const InstructionSet> availableInstructionSets();

/// What kAuto means to this process. For tests and measurements: all sets but kScalar give the same bits.
[[nodiscard]] InstructionSet chosenInstructionSet();
/// The same for kernels without a scalar reference.
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
