// core/rig/references.h: names by which parts of a rig refer to each other, and identities that outlive the names.
//
// Names are unique within one rig. Between two rigs, parts are matched by identity or index, and references are renamed
// before rigs are compared or merged.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew/rig/rig.h"

namespace sinew {

/// Assigns identities, each once.
class IdentitySource {
 public:
  /// Gives every primitive, group and line of a rig that was edited from `before` an identity of its own. An item
  /// without identity, or with that of another (a copy), takes the one that its name had in `before` if it is free,
  /// else a new one.
  void identify(Rig& rig, const Rig& before);

 private:
  std::uint32_t lastPrimitive_ = 0;
  std::uint32_t lastGroup_ = 0;  ///< Counts only groups: those of a rig just read are 1, 2, 3 ... in its order.
  std::uint32_t lastLine_ = 0;
};

/// `before` with the names that items have in `edited`, without primitives, groups and lines that were removed there.
/// Nothing: `edited` only adds. Items without identity, such as channels, stay as they are.
[[nodiscard]] std::optional<Rig> withNamesOf(const Rig& before, const Rig& edited);

enum class Named { kPrimitive, kGroup, kLine, kChannel };  ///< The kind of thing that a reference names.

/// Calls visit(Named, std::string&) for each reference that is not empty; it may change the name.
template <class Visit>
void eachReference(std::vector<AnimatedNumber>& animated, Visit visit) {
  for (AnimatedNumber& number : animated) {
    for (Driver& driver : number.drivers) {
      if (!driver.input.line.empty()) visit(Named::kLine, driver.input.line);
      if (!driver.input.channel.empty()) visit(Named::kChannel, driver.input.channel);
    }
  }
}

template <class Visit>
void eachReference(Primitive& primitive, Visit visit) {
  if (!primitive.group.empty()) visit(Named::kGroup, primitive.group);
  if (!primitive.line.empty()) visit(Named::kLine, primitive.line);
  if (!primitive.mirror.empty()) visit(Named::kPrimitive, primitive.mirror);
  eachReference(primitive.animated, visit);
}

template <class Visit>
void eachReference(MuscleLine& line, Visit visit) {
  if (!line.mirror.empty()) visit(Named::kLine, line.mirror);
  eachReference(line.animated, visit);
}

template <class Visit>
void eachReference(Rig& rig, Visit visit) {
  for (Link& link : rig.links) {
    for (std::string& group : link.groups) visit(Named::kGroup, group);
    eachReference(link.animated, visit);
  }
  eachReference(rig.surface.animated, visit);
  for (MuscleSheet& sheet : rig.sheets) visit(Named::kGroup, sheet.group);
  for (MuscleLine& line : rig.lines) eachReference(line, visit);
  for (Primitive& primitive : rig.primitives) eachReference(primitive, visit);
  for (MorphWeight& morph : rig.morphs) eachReference(morph.animated, visit);
}

inline void renameReferences(Rig& rig, Named kind, const std::string& from, const std::string& to) {
  eachReference(rig, [&](Named named, std::string& name) {
    if (named == kind && name == from) name = to;
  });
}

}  // namespace sinew
