// core/geometry/instruction_set.cpp: detects and chooses instruction sets.
#include "core/geometry/instruction_set.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <vector>

#include "hwy/targets.h"

namespace sinew {
namespace {

std::vector<InstructionSet> findAvailable() {
  std::vector<InstructionSet> sets{InstructionSet::kScalar};
  const std::int64_t targets = hwy::SupportedTargets();
  if (targets & HWY_SSE4) sets.push_back(InstructionSet::kSse4);
  if (targets & HWY_AVX2) sets.push_back(InstructionSet::kAvx2);
  if (targets & HWY_AVX3) sets.push_back(InstructionSet::kAvx512);
  return sets;
}

std::atomic<InstructionSet> chosen = InstructionSet::kAuto;

}  // namespace

const char* nameOf(InstructionSet set) {
  constexpr std::array kNames{"auto", "scalar", "sse4", "avx2", "avx512"};
  return kNames[static_cast<std::size_t>(set)];
}

Result<void> checkProcessor() {
  if (hwy::SupportedTargets() & HWY_SSE4) return {};
  return errorAt("", "this processor lacks SSE4.2 with AES and CLMUL, which Sinew needs");
}

std::span<const InstructionSet> availableInstructionSets() {
  static const std::vector<InstructionSet> sets = findAvailable();
  return sets;
}

InstructionSet chosenInstructionSet() {
  const InstructionSet set = chosen;
  return set == InstructionSet::kAuto ? availableInstructionSets().back() : set;
}

InstructionSet chosenVectorSet() {
  const InstructionSet set = chosenInstructionSet();
  if (set != InstructionSet::kScalar) return set;
  assert(checkProcessor());
  return availableInstructionSets().back();
}

InstructionSet chooseInstructionSet(InstructionSet set) {
  assert(set == InstructionSet::kAuto || std::ranges::count(availableInstructionSets(), set) == 1);
  return chosen.exchange(set);
}

}  // namespace sinew
