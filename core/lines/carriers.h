// core/lines/carriers.h: the matrices that place primitives in a pose: those of bones, and of bones as lines carry
// them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/lines/line_pose.h"
#include "core/lines/via_bend.h"
#include "core/rig/attachment.h"

namespace sinew {

/// Made once per edit; used once per pose.
class Carriers {
 public:
  Carriers() = default;
  Carriers(const Rig& rig, const Character& character, std::span<const LineCarrier> onLines);

  /// Takes the lines' settings from a rig that has the same lines otherwise.
  void settle(const Rig& rig);
  /// Places all primitives in a pose.
  /// @param primitives  whose carriers are these.  @param out [primitives]
  void pose(std::span<const FieldPrimitive> primitives, const Pose& pose, const Skeleton& skeleton,
            std::vector<PosedPrimitive>& out);
  /// The same in the bind pose with nothing flexed, where lines deform nothing.
  [[nodiscard]] std::vector<glm::mat4> inBind(const Skeleton& skeleton) const;

 private:
  std::vector<std::optional<LineRest>> rests_;  ///< [Rig::lines]
  std::vector<LineCarrier> onLines_;
  LineScratch scratch_;
  std::vector<PosedLine> lines_;     ///< Memory kept from pose to pose, as is the next.
  std::vector<glm::mat4> matrices_;  ///< [bones + onLines]
};

/// [Rig::lines] in a pose.
[[nodiscard]] std::vector<PosedLine> posedLines(const Rig& rig, const Character& character, const Pose& pose);
/// [Rig::primitives] what each rides: its bone's space in the bind pose -> world now, shifted whole by via points.
/// nullopt: unattached.
/// @param lines  posedLines of the same
[[nodiscard]] std::vector<std::optional<glm::mat4>> carriersOf(const Rig& rig, const Character& character,
                                                               const Pose& pose, std::span<const PosedLine> lines);
[[nodiscard]] std::vector<std::optional<glm::mat4>> carriersOf(const Rig& rig, const Character& character,
                                                               const Pose& pose);
/// [Rig::primitives] as the field has them; nullopt: unattached. @param lines  posedLines of the same
[[nodiscard]] std::vector<std::optional<BentMuscle>> carriedMuscles(const Rig& rig, const Character& character,
                                                                    const Pose& pose, std::span<const PosedLine> lines);
/// What one of the rig's primitives rides.
[[nodiscard]] std::optional<glm::mat4> carrierOf(const Rig& rig, const Primitive& primitive, const Character& character,
                                                 const Pose& pose);

}  // namespace sinew
