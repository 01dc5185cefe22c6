// core/rig/rig_numbers.cpp: the numbers of a rig, read out of it and found among themselves.
#include "core/rig/rig_numbers.h"

#include "core/geometry/at.h"

namespace sinew {

RigNumbers drawnNumbers(const Rig& rig) {
  RigNumbers numbers;
  numbers.skinBlend = rig.surface.skinBlend;
  numbers.lines.reserve(rig.lines.size());
  for (const MuscleLine& line : rig.lines) numbers.lines.push_back(line.settings);
  numbers.primitives.reserve(rig.primitives.size());
  for (const Primitive& primitive : rig.primitives) {
    numbers.primitives.push_back({primitive.placement, primitive.reach, primitive.amount});
  }
  for (const MorphWeight& morph : rig.morphs) numbers.morphs.push_back(morph.weight);
  return numbers;
}

float& numberIn(RigNumbers& numbers, const NumberRef& ref) {
  switch (ownerOf(ref.parameter)) {
    case ParameterOwner::kPrimitive:
      return *numberIn(at(numbers.primitives, ref.owner), ref.parameter);
    case ParameterOwner::kLine:
      return *numberIn(at(numbers.lines, ref.owner), ref.parameter);
    case ParameterOwner::kMorph:
      return at(numbers.morphs, ref.owner);
    case ParameterOwner::kSurface:
      break;
  }
  return numbers.skinBlend;
}

float numberOf(const RigNumbers& numbers, const NumberRef& ref) {
  return numberIn(const_cast<RigNumbers&>(numbers), ref);  // Finding changes nothing.
}

}  // namespace sinew
