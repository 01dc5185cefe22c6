// core/rig/references.h: the names by which parts of a rig refer to each other, in one place.
//
// A reference is a name, in memory as in the file, and within one rig a name means one thing of its kind. Between two
// rigs it does not: there things go by identity (identity.h) or index, and references are renamed before they are
// compared or move over.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew/rig/rig.h"

namespace sinew {

// Gives primitives, groups and lines identities that outlive their names.

/// Source of identities: each is given once.
class IdentitySource {
 public:
  /// Completes a rig that edits have made from `before`: every primitive, group and line has an identity of its own
  /// afterwards. One that has none, or shares its with another (a copy), keeps the identity that its name had in
  /// `before` if nobody else has it, else gets a new one.
  void identify(Rig& rig, const Rig& before);

 private:
  std::uint32_t lastPrimitive_ = 0;
  std::uint32_t lastGroup_ = 0;  ///< Counts groups alone: of a rig just read they are 1, 2, 3 ... in its order.
  std::uint32_t lastLine_ = 0;
};

/// `before` as it would be had what `edited` still has been called as there, without primitives, groups and lines that
/// it has no more. Nothing: `edited` at most adds. What has no identity stays as it is; channels have none.
[[nodiscard]] std::optional<Rig> withNamesOf(const Rig& before, const Rig& edited);

/// What a reference names.
enum class Named { kPrimitive, kGroup, kLine, kChannel };

/// visit(Named, std::string&) for each reference that is not empty. It may change the name.
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
  for (auto& link : rig.links) {
    for (std::string& group : link) visit(Named::kGroup, group);
  }
  eachReference(rig.surface.animated, visit);
  for (MuscleLine& line : rig.lines) eachReference(line, visit);
  for (Primitive& primitive : rig.primitives) eachReference(primitive, visit);
  for (MorphWeight& morph : rig.morphs) eachReference(morph.animated, visit);
}

/// References to `from` become references to `to`.
inline void renameReferences(Rig& rig, Named kind, const std::string& from, const std::string& to) {
  eachReference(rig, [&](Named named, std::string& name) {
    if (named == kind && name == from) name = to;
  });
}

}  // namespace sinew
