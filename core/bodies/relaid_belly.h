// core/bodies/relaid_belly.h: candidates for where a muscle could lie so that it stays in the flesh. docs/muscles.md.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/bodies/check.h"
#include "core/bodies/motions.h"
#include "core/rig/line_rest.h"
#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

struct MendedBelly {
  Rig rig;
  std::string said;  ///< "rides spine.2"; empty: nothing helps, and the rig is unchanged.
};

/// Tries to keep a belly and its twin under the skin in all poses: deeper; with one end of its line on a bone that
/// carries the skin over it; riding such a bone; between two of them, on a line that only carries it.
[[nodiscard]] Result<MendedBelly> withMendedBelly(Rig rig, int primitive, const Motions& motions,
                                                  const MirrorPlan* plan);

/// Makes the belly deeper by its lower side alone. nullopt: that does not help.
[[nodiscard]] std::optional<BellyChoice> withDeeperBelly(const BellyChoice& choice, const SurfaceSettings& surface,
                                                         const Motions& motions);

/// Removes the bone of a kReachesAcross finding from the territory, and its counterpart from the twin's.
[[nodiscard]] Rig withoutFarSkin(Rig rig, const Finding& finding, const MirrorPlan* plan);

struct OwnTriangle {
  int triangle = 0;
  SkinFrame frame;      ///< At its middle, in the bind pose.
  float weight = 0.0f;  ///< Smallest weight of the bone at its corners.
};

/// The skin that follows one bone.
class OwnSkin {
 public:
  OwnSkin(const Character& character, int bone);

  [[nodiscard]] int bone() const { return bone_; }
  /// Triangles whose weight is close to the largest; may be empty.
  [[nodiscard]] const std::vector<OwnTriangle>& firm() const { return firm_; }
  [[nodiscard]] const glm::vec3& middle() const { return middle_; }  ///< Mean of the middles of firm().
  /// The nearest place to a point in the bind pose, on skin with at least half the largest weight.
  [[nodiscard]] std::optional<SkinFrame> nearest(const glm::vec3& point) const;

 private:
  const Character& character_;
  int bone_;
  std::vector<OwnTriangle> half_;
  std::vector<OwnTriangle> firm_;
  glm::vec3 middle_{0.0f};
};

/// The bone of the line that the belly follows. The tendon at the other end crosses the joint.
enum class BellyBone { kOrigin, kInsertion };

/// Makes candidates for a drawn muscle, for BellyTrial. Lines twist with the belly's bone; girth grows from the line.
class RelaidBelly {
 public:
  /// @param drawn  on a line with a valid rest (lineRest)  @param trial  of `drawn`
  RelaidBelly(const BellyChoice& drawn, const BellyTrial& trial, const Character& character);

  /// The belly as it is. @param reach  the other end's distance from the joint, fraction of that drawn
  [[nodiscard]] BellyChoice asDrawn(BellyBone bone, float reach) const;
  /// Shorter, towards its own end. nullopt: too short, or the line runs straight out of the skin there.
  /// @param tendon  at the other end, fraction of the line
  [[nodiscard]] std::optional<BellyChoice> shorter(BellyBone bone, float reach, float tendon) const;
  /// Under skin that the bone carries, along the skin, with its own end moved there. nullopt: as shorter(), or no skin.
  /// @param share  largest half length, fraction of the distance to the other end
  /// @param inwards  0: nearest to its own end; 1: nearest to the middle of the bone's skin
  [[nodiscard]] std::optional<BellyChoice> under(BellyBone bone, float reach, float share, float inwards) const;
  /// Under skin of a bone, without a line. nullopt: the bone carries no skin.
  [[nodiscard]] std::optional<BellyChoice> riding(const OwnSkin& skin, const glm::vec3& near, float inwards) const;

  [[nodiscard]] float distanceOf(const BellyChoice& choice) const;  ///< Distance from the middle of the belly as drawn.
  [[nodiscard]] bool isNear(const BellyChoice& choice) const;  ///< Near enough to count as the muscle that was drawn.

  [[nodiscard]] const OwnSkin& skin(BellyBone bone) const { return skins_[bone == BellyBone::kOrigin ? 0 : 1]; }
  [[nodiscard]] glm::vec3 ownEnd(BellyBone bone) const;

 private:
  [[nodiscard]] glm::vec3 otherEnd(BellyBone bone, float reach) const;
  [[nodiscard]] glm::vec3 lineUnder(int bone, const SkinFrame& skin) const;
  [[nodiscard]] std::optional<BellyChoice> laid(BellyBone bone, const glm::vec3& own, const glm::vec3& other,
                                                const glm::vec2& tendons, const SkinFrame& skin) const;
  [[nodiscard]] MuscleLine lineOf(BellyBone bone, const glm::vec3& own, const glm::vec3& other) const;
  void place(BellyChoice& choice, int bone, const Placement& belly) const;

  const BellyChoice& drawn_;
  const Character& character_;
  LineRest rest_;
  std::array<OwnSkin, 2> skins_;  ///< [BellyBone]
  glm::vec3 joint_{0.0f};
  float stands_ = 0.0f;     ///< Height above the skin as drawn.
  glm::vec3 middle_{0.0f};  ///< As drawn.
  float half_ = 0.0f;       ///< Half its length as drawn.
};

/// Moves the primitive to another bone; its place in the bind pose stays.
void rideBone(Primitive& primitive, int bone, const Skeleton& skeleton);
[[nodiscard]] BellyChoice offItsLine(BellyChoice choice);  ///< Without its line.
/// Higher by its lower side alone, and wider, so that the skin's motion is a smaller fraction of it.
[[nodiscard]] BellyChoice larger(BellyChoice choice, float factor);
/// With a via point at the belly's middle, on the belly's own bone.
[[nodiscard]] BellyChoice ledByItsBone(BellyChoice choice, const Skeleton& skeleton);

}  // namespace sinew
