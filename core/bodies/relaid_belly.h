// core/bodies/relaid_belly.h: a drawn muscle, laid so that it goes with one of the two bones that its line spans.
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

// Muscles that ride the wrong bone, or skin that they should not reach. docs/muscles.md.

struct MendedBelly {
  Rig rig;
  std::string said;  ///< "rides spine.2"; empty: nothing helps, and the rig is as it was.
};

/// Tries what keeps a belly under its skin over all poses, off its line if it is on one: each bone that carries the
/// skin over it; then between two of these, on a line that carries it and does nothing else. Its twin likewise.
[[nodiscard]] Result<MendedBelly> withMendedBelly(Rig rig, int primitive, const Motions& motions,
                                                  const MirrorPlan* plan);

/// Only deeper, by its lower side alone. nullopt: that does not help.
[[nodiscard]] std::optional<BellyChoice> withDeeperBelly(const BellyChoice& choice, const SurfaceSettings& surface,
                                                         const Motions& motions);

/// A kReachesAcross's bone goes from the territory; of the twin's likewise.
[[nodiscard]] Rig withoutFarSkin(Rig rig, const Finding& finding, const MirrorPlan* plan);

// The skin that goes with one bone.

/// A triangle, and a frame at its middle in the bind pose.
struct OwnTriangle {
  int triangle = 0;
  SkinFrame frame;
  float weight = 0.0f;  ///< Of the bone, the least of the corners'.
};

/// Triangles that a bone carries: those whose every corner has nearly as much of it as any has.
class OwnSkin {
 public:
  OwnSkin(const Character& character, int bone);

  [[nodiscard]] int bone() const { return bone_; }
  /// Empty: no skin follows the bone to speak of.
  [[nodiscard]] const std::vector<OwnTriangle>& firm() const { return firm_; }
  /// Mean of their middles.
  [[nodiscard]] const glm::vec3& middle() const { return middle_; }
  /// The nearest place to a point of the bind pose, also where the skin half follows other bones.
  [[nodiscard]] std::optional<SkinFrame> nearest(const glm::vec3& point) const;

 private:
  const Character& character_;
  int bone_;
  std::vector<OwnTriangle> half_;
  std::vector<OwnTriangle> firm_;
  glm::vec3 middle_{0.0f};
};

/// Which of the line's bones the belly goes with. The tendon at the other end crosses the joint.
enum class BellyBone { kOrigin, kInsertion };

/// Makes choices; whether they stay in the flesh is for a trial to tell. Their lines turn with the belly's bone, and
/// girth grows from the line.
class RelaidBelly {
 public:
  /// @param drawn  on a line that has a rest (lineRest)  @param trial  of it
  RelaidBelly(const BellyChoice& drawn, const BellyTrial& trial, const Character& character);

  /// The belly as it is.
  /// @param reach  where the other end is then, of its distance from the joint
  [[nodiscard]] BellyChoice asDrawn(BellyBone bone, float reach) const;
  /// Shorter, from its own end on. nullopt: too short, or the line runs straight out of the skin there.
  /// @param tendon  the other end's, of the line
  [[nodiscard]] std::optional<BellyChoice> shorter(BellyBone bone, float reach, float tendon) const;
  /// Under skin that the bone carries, along the skin, with its own end moved there. nullopt likewise.
  /// @param share  half its length at most, of the way to the other end
  /// @param inwards  where: 0 nearest to its own end, 1 to the middle of the bone's skin
  [[nodiscard]] std::optional<BellyChoice> under(BellyBone bone, float reach, float share, float inwards) const;
  /// The same without a line. nullopt: the bone carries no skin.
  [[nodiscard]] std::optional<BellyChoice> riding(const OwnSkin& skin, const glm::vec3& near, float inwards) const;

  /// From the middle of the belly as drawn.
  [[nodiscard]] float distanceOf(const BellyChoice& choice) const;
  /// Farther off it is another muscle than the one that was drawn.
  [[nodiscard]] bool isNear(const BellyChoice& choice) const;

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
  std::array<OwnSkin, 2> skins_;  ///< Of the origin's bone and of the insertion's.
  glm::vec3 joint_{0.0f};
  float stands_ = 0.0f;     ///< How far it stands out of the skin as drawn.
  glm::vec3 middle_{0.0f};  ///< As drawn.
  float half_ = 0.0f;       ///< Half its length as drawn.
};

/// It rides its bone.
[[nodiscard]] BellyChoice offItsLine(BellyChoice choice);
/// Higher by its lower side alone, and wider: the same motion of the skin is less of it.
[[nodiscard]] BellyChoice larger(BellyChoice choice, float factor);
/// The line bends round the belly's middle, on the belly's own bone.
[[nodiscard]] BellyChoice ledByItsBone(BellyChoice choice, const Skeleton& skeleton);

}  // namespace sinew
