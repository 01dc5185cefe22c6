// core/rig/identity.h: gives primitives, groups and lines identities that outlive their names.
#pragma once

#include <cstdint>
#include <optional>

#include "sinew/rig/rig.h"

namespace sinew {

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

}  // namespace sinew
