// core/bodies/retarget.cpp: maps every bone and every place of a rig through one BodyMap.
#include "core/bodies/retarget.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/bodies/body_map.h"
#include "core/bodies/mend.h"
#include "core/bodies/motions.h"
#include "core/bodies/sheets/keep_sheets.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/rig/line_rest.h"
#include "core/rig/rig_edit.h"
#include "core/rig/sheet_edit.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {
namespace {

constexpr const char* kLiesDeeper = ": deeper, since it would come to lie outside of this body";
constexpr float kSameImage = 1e-5f;  ///< Difference up to which twins count as exact images, fraction of H.

/// Equal in everything that muscles depend on.
bool isSameBody(const Character& a, const Character& b) {
  return a.mesh.positions == b.mesh.positions &&
         std::ranges::equal(a.skeleton.bones, b.skeleton.bones, [](const Bone& one, const Bone& other) {
           return one.path == other.path && one.bindInWorld == other.bindInWorld;
         });
}

/// Scales the keys and drivers of lengths about the number's own value, which has changed from `before` to `after`.
void scaleAbout(std::vector<AnimatedNumber>& animated, const Primitive& before, const Primitive& after, float size) {
  for (AnimatedNumber& number : animated) {
    if (!isLength(number.parameter)) continue;
    const float was = numberOf(before, number.parameter);
    const float is = numberOf(after, number.parameter);
    const float factor = isRadius(number.parameter) && was > 0.0f ? is / was : size;
    const auto scale = [&](Curve& curve, bool isValue) {
      for (glm::vec2& point : curve.points) point.y = isValue ? is + factor * (point.y - was) : factor * point.y;
    };
    for (KeyTrack& track : number.keys) scale(track.curve, true);
    for (Driver& driver : number.drivers) {
      if (driver.mode != DriverMode::kMultiply) scale(driver.curve, driver.mode == DriverMode::kReplace);
    }
  }
}

class RigRetargeter {
 public:
  RigRetargeter(const Rig& rig, const Character& from, const MirrorPlan& fromPlan, const Character& to,
                const MirrorPlan& toPlan)
      : from_(from),
        to_(to),
        toPlan_(toPlan),
        ours_(from, fromPlan, rig.slots),
        theirs_(to, toPlan, rig.slots),
        map_(ours_, theirs_),
        done_{withoutBellies(rig), {}, {}} {}

  Retargeted make() {
    Rig& rig = done_.rig;
    const Rig before = rig;
    std::vector<std::string> lost;
    for (MuscleLine& line : rig.lines) {
      if (!moveLine(line)) lost.push_back(line.name);
    }
    std::vector<int> gone;
    for (int i = 0; i < static_cast<int>(rig.primitives.size()); ++i) {
      Primitive& primitive = at(rig.primitives, i);
      const MuscleLine* line = lineOf(before, primitive);
      const bool lineless = line != nullptr && std::ranges::find(lost, line->name) != lost.end();
      std::optional<std::string> why =
          lineless ? missing(counterpart(line->origin.bone) ? line->insertion.bone : line->origin.bone)
                   : movePrimitive(primitive);
      if (!why) continue;
      gone.push_back(i);
      done_.leftOut.push_back({primitive.name, std::move(*why)});
    }
    moveSheets();
    moveAnimated(rig.surface.animated, "surface");
    for (MorphWeight& morph : rig.morphs) moveAnimated(morph.animated, morph.name);
    for (Link& link : rig.links) moveAnimated(link.animated, link.groups[0] + " and " + link.groups[1]);
    rig = withMorphsOf(removePrimitives(std::move(rig), gone), to_);
    rig.clipFiles.clear();  // Their paths are relative to the other rig, and the other character has its own clips.
    // Corrections belong to the first body, but still apply to bones of the same name.
    std::erase_if(rig.slots, [&](const SlotCorrection& each) {
      return each.bone.empty() ? !isSameBody(from_, to_) : !to_.skeleton.findBone(each.bone);
    });
    keepTwinsExact();
    return std::move(done_);
  }

 private:
  /// nullopt: the bone has no counterpart.
  std::optional<int> counterpart(const std::string& bone) const {
    const std::optional<int> own = from_.skeleton.findBone(bone);
    if (!own) return to_.skeleton.findBone(bone);
    const int found = map_.bone(*own);
    return found < 0 ? std::nullopt : std::optional(found);
  }

  std::string missing(const std::string& bone) const {
    const std::optional<int> own = from_.skeleton.findBone(bone);
    const Zone zone = own ? at(ours_.frame.zoneOfBone, *own) : -1;
    if (zone < 0) return "this character has no bone \"" + bone + '"';
    return std::string("this body has no ") + nameOf(at(allBodySlots(), zone));
  }

  bool moveAnchor(LineAnchor& anchor) const {
    const std::optional<int> own = from_.skeleton.findBone(anchor.bone);
    const std::optional<int> other = counterpart(anchor.bone);
    if (!other) return false;
    anchor.bone = to_.skeleton.fileName(*other);
    if (!own) return true;
    const glm::vec3 inBind(at(from_.skeleton.bones, *own).bindInWorld * glm::vec4(anchor.point, 1.0f));
    anchor.point = anchorOn(to_.skeleton, *other, map_.move(*own, inBind).point).point;
    return true;
  }

  /// Their bellies are laid on the other skin.
  void moveSheets() {
    Rig& rig = done_.rig;
    std::vector<std::string> gone;
    for (MuscleSheet& sheet : rig.sheets) {
      for (SheetEdge& edge : sheet.edges) {
        for (LineAnchor& point : edge.points) {
          const std::string bone = point.bone;
          if (moveAnchor(point) || (!gone.empty() && gone.back() == sheet.name)) continue;
          gone.push_back(sheet.name);
          done_.leftOut.push_back({sheet.name, missing(bone)});
        }
      }
    }
    for (const std::string& name : gone) rig = removeSheet(std::move(rig), findSheet(rig, name));
  }

  bool moveLine(MuscleLine& line) {
    for (LineAnchor* anchor : {&line.origin, &line.insertion}) {
      if (!moveAnchor(*anchor)) return false;
    }
    if (line.via && !moveAnchor(*line.via)) line.via.reset();
    moveAnimated(line.animated, line.name);
    return true;
  }

  /// @return the reason for failure, or nullopt
  std::optional<std::string> movePrimitive(Primitive& primitive) {
    const std::optional<int> own = from_.skeleton.findBone(primitive.bone);
    const std::optional<int> other = counterpart(primitive.bone);
    if (!other) return missing(primitive.bone);
    const Primitive before = primitive;
    primitive.bone = to_.skeleton.fileName(*other);
    if (primitive.territory) {
      primitive.territory = territory(*primitive.territory);
      if (primitive.territory->empty()) primitive.territory.reset();
    }
    float size = to_.height / from_.height;
    if (own) {
      const glm::dmat4 inFrom(at(from_.skeleton.bones, *own).bindInWorld);
      const Placement world = imageOf(before.placement, {glm::dmat3(inFrom), glm::dvec3(inFrom[3])});
      const std::optional<BodyMove> found = map_.moveInto(*own, world.center);
      if (!found) return "there is no closed body under the skin there";
      const BodyMove& move = *found;
      if (move.isPulled) sayDeeper(primitive);
      const glm::dmat4 toBone(at(to_.skeleton.bones, *other).inverseBindInWorld);
      // Rotates and moves it as a whole, which keeps its axes, then stretches it along them.
      const glm::dmat3 turn(move.turn());
      const glm::dmat3 linear = glm::dmat3(toBone) * turn * glm::dmat3(inFrom);
      const glm::dvec3 shift = glm::dvec3(move.point) - turn * glm::dvec3(world.center);
      const glm::dvec3 offset = glm::dmat3(toBone) * (turn * glm::dvec3(inFrom[3]) + shift) + glm::dvec3(toBone[3]);
      primitive.placement = imageOf(before.placement, {linear, offset});
      const glm::dmat3 axes =
          glm::inverse(glm::dmat3(toBone)) * glm::dmat3(glm::mat3_cast(primitive.placement.rotation));
      for (glm::length_t i = 0; i < 3; ++i) {
        const glm::vec3 way(glm::transpose(turn) * glm::normalize(axes[i]));
        primitive.placement.radii[i] *= move.stretchAlong(way);
      }
      size = std::cbrt(move.stretch.x * move.stretch.y * move.stretch.z);
    } else {
      primitive.placement.center *= size;
      primitive.placement.radii *= size;
    }
    moveAnimated(primitive.animated, primitive.name);
    scaleAbout(primitive.animated, before, primitive, size);
    return std::nullopt;
  }

  /// Reports a pair of twins once.
  void sayDeeper(const Primitive& primitive) {
    const std::string line = primitive.mirror + kLiesDeeper;
    if (std::ranges::find(done_.mended, line) == done_.mended.end())
      done_.mended.push_back(primitive.name + kLiesDeeper);
  }

  void moveAnimated(std::vector<AnimatedNumber>& animated, const std::string& owner) {
    for (AnimatedNumber& number : animated) {
      std::erase_if(number.drivers, [&](Driver& driver) {
        if (moveInput(driver.input)) return false;
        done_.leftOut.push_back(
            {owner + ", a driver of " + wordsFor(number.parameter), "its bones are not on this body"});
        return true;
      });
    }
    std::erase_if(animated, [](const AnimatedNumber& number) { return number.keys.empty() && number.drivers.empty(); });
  }

  bool moveInput(DriverInput& input) const {
    if (!input.bone.empty()) {
      const std::optional<int> other = counterpart(input.bone);
      if (!other) return false;
      input.bone = to_.skeleton.fileName(*other);
    }
    return input.kind != DriverInputKind::kDistance || (moveAnchor(input.from) && moveAnchor(input.to));
  }

  /// Maps the bones of a territory so that no skin drops out of it.
  std::vector<std::string> territory(const std::vector<std::string>& bones) const {
    std::vector<int> found;
    const auto add = [&](int bone) {
      if (bone >= 0 && std::ranges::find(found, bone) == found.end()) found.push_back(bone);
    };
    for (const std::string& name : bones) add(counterpart(name).value_or(-1));
    // The other trunk may have more bones: include all that map back to a bone of the territory.
    const BodyMap back(theirs_, ours_);
    for (int bone = 0; bone < static_cast<int>(to_.skeleton.bones.size()); ++bone) {
      if (at(theirs_.frame.zoneOfBone, bone) != zoneOf(Slot::kSpine)) continue;
      const int from = back.bone(bone);
      if (from < 0) continue;
      const bool inside = std::ranges::any_of(bones, [&](const std::string& name) {
        const std::optional<int> own = from_.skeleton.findBone(name);
        return own && *own == from;
      });
      if (inside) add(bone);
    }
    std::vector<std::string> names;
    for (const int bone : found) names.push_back(to_.skeleton.fileName(bone));
    return names;
  }

  /// Makes twins exact images where they differ only by rounding.
  void keepTwinsExact() {
    Rig& rig = done_.rig;
    const float near = kSameImage * to_.height;
    for (MuscleLine& line : rig.lines) {
      const int twin = findLine(rig, line.mirror);
      if (twin < 0 || &at(rig.lines, twin) <= &line) continue;
      const auto image = mirroredLine(toPlan_, line);
      MuscleLine& other = at(rig.lines, twin);
      const auto isNear = [&](const LineAnchor& a, const LineAnchor& b) {
        return a.bone == b.bone && glm::distance(a.point, b.point) <= near;
      };
      if (!image || image->via.has_value() != other.via.has_value()) continue;
      if (!isNear(image->origin, other.origin) || !isNear(image->insertion, other.insertion)) continue;
      if (other.via && !isNear(*image->via, *other.via)) continue;
      other.origin.point = image->origin.point;
      other.insertion.point = image->insertion.point;
      if (other.via) other.via->point = image->via->point;
    }
    for (int i = 0; i < static_cast<int>(rig.primitives.size()); ++i) {
      const int twin = twinOf(rig, i);
      if (twin <= i) continue;
      const auto image = mirroredPrimitive(toPlan_, at(rig.primitives, i));
      Primitive& other = at(rig.primitives, twin);
      if (!image || image->bone != other.bone) continue;
      const Placement& a = image->placement;
      const Placement& b = other.placement;
      if (glm::distance(a.center, b.center) > near || glm::distance(a.radii, b.radii) > near) continue;
      if (std::abs(glm::dot(a.rotation, b.rotation)) < 1.0f - kSameImage) continue;
      other.placement = a;
    }
  }

  const Character& from_;
  const Character& to_;
  const MirrorPlan& toPlan_;
  MeasuredBody ours_;
  MeasuredBody theirs_;
  BodyMap map_;
  Retargeted done_;
};

}  // namespace

Result<Retargeted> retarget(const Rig& rig, const Character& from, const MirrorPlan& fromPlan, const Motions& motions,
                            const MirrorPlan& toPlan) {
  const Character& to = motions.character();
  Retargeted done = RigRetargeter(rig, from, fromPlan, to, toPlan).make();
  std::vector<UnlaidSheet> unlaid;
  done.rig = withSheets(std::move(done.rig), motions.sharedCharacter(), &unlaid);
  for (UnlaidSheet& sheet : unlaid) done.leftOut.push_back({std::move(sheet.name), std::move(sheet.why)});
  if (done.rig.primitives.empty() && !rig.primitives.empty())
    return errorAt("", "no muscle of the rig finds its place on this body");
  if (!isSameBody(from, to)) {
    done.rig = withLearnedLengths(std::move(done.rig), 0, to);
    // Mends lines only: the place of a muscle is the designer's choice.
    const std::vector<Finding> found = check(done.rig, motions);
    Result<MendedRig> mended = withMendedFindings(std::move(done.rig), found, motions, &toPlan);
    if (!mended) return mended.error();
    done.rig = std::move(mended.value().rig);
    std::ranges::move(mended->said, std::back_inserter(done.mended));
  }
  if (const auto valid = validate(done.rig); !valid) return valid.error();
  return done;
}

}  // namespace sinew
