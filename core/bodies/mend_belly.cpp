// core/bodies/mend_belly.cpp: candidates in order of how little they ask for; each is measured over all poses.
#include "core/bodies/mend_belly.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/bodies/belly_trial.h"
#include "core/character/bones_between.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/line_rest.h"
#include "core/rig/line_twins.h"
#include "core/rig/reparent.h"
#include "core/rig/twins.h"

namespace sinew {
namespace {

constexpr float kDeeper[] = {1.2f, 1.5f};
constexpr float kEnds = 0.9f;  ///< Of the half length: where a line that only carries begins and ends.

/// Deeper in the flesh by its lower side alone: the skin over it hardly changes.
BellyChoice deeper(BellyChoice choice, const BellyTrial& trial, float factor) {
  const glm::vec3 outwards = trial.outwards();
  const glm::mat3& axes = trial.body().axes;
  const auto along = [&](glm::length_t axis) { return glm::dot(glm::normalize(axes[axis]), outwards); };
  const glm::length_t height = std::abs(along(2)) >= std::abs(along(0)) ? 2 : 0;
  Placement& placement = choice.primitive.placement;
  const glm::vec3 up = glm::mat3_cast(placement.rotation)[height] * (along(height) < 0.0f ? -1.0f : 1.0f);
  placement.center -= (factor - 1.0f) * placement.radii[height] * up;
  placement.radii[height] *= factor;
  choice.said += std::string(choice.said.empty() ? "" : ", ") + "deeper";
  return choice;
}

Primitive riding(const Primitive& own, int bone, const Skeleton& skeleton) {
  Primitive out = own;
  const int from = *skeleton.findBone(own.bone);
  out.line.clear();
  if (from == bone) return out;
  out.placement =
      carryToBone(own.placement, at(skeleton.bones, from).bindInWorld, at(skeleton.bones, bone).bindInWorld);
  out.bone = skeleton.fileName(bone);
  return out;
}

/// It goes half way between two bones, and keeps its girth.
LineSettings carryingOnly() {
  LineSettings settings;
  settings.tendons = {0.0f, 0.0f};
  settings.volume = 0.0f;
  settings.pivot = 0.0f;
  settings.flex = {0.0f, 0.0f};
  settings.gain = 0.0f;
  return settings;
}

/// Bones that carry the skin and are next to those that the muscle is on, the heaviest first: a muscle of the neck does
/// not ride the head.
std::vector<int> nearCarriers(const BellyChoice& now, const BellyTrial& trial, const Skeleton& skeleton) {
  std::vector<int> own{*skeleton.findBone(now.primitive.bone)};
  if (now.line) {
    for (const LineAnchor* anchor : {&now.line->origin, &now.line->insertion}) {
      if (const auto bone = skeleton.findBone(anchor->bone)) own.push_back(*bone);
    }
  }
  std::vector<int> out = trial.carriers();
  std::erase_if(out, [&](int bone) {
    return std::ranges::none_of(own, [&](int from) { return bonesBetween(skeleton, from, bone).size() <= 2; });
  });
  return out;
}

LineAnchor moved(const LineAnchor& anchor, int bone, const Skeleton& skeleton) {
  const auto from = skeleton.findBone(anchor.bone);
  if (!from) return anchor;
  return anchorOn(skeleton, bone, glm::vec3(at(skeleton.bones, *from).bindInWorld * glm::vec4(anchor.point, 1.0f)));
}

/// One end and the middle on the bone under the belly: only the other end crosses a joint.
BellyChoice endingOn(const BellyChoice& now, bool origin, int bone, const BellyTrial& trial, const Skeleton& skeleton) {
  BellyChoice choice = now;
  LineAnchor& end = origin ? choice.line->origin : choice.line->insertion;
  end = moved(end, bone, skeleton);
  choice.line->via = anchorOn(skeleton, bone, trial.body().center);
  choice.line->settings.pivot = 0.0f;
  choice.said = std::string(origin ? "begins" : "ends") + " on " + skeleton.fileName(bone);
  return choice;
}

std::vector<BellyChoice> choicesFor(const BellyChoice& now, const BellyTrial& trial, const Skeleton& skeleton) {
  std::vector<BellyChoice> out;
  for (const float factor : kDeeper) out.push_back(deeper(now, trial, factor));
  const std::vector<int> carriers = nearCarriers(now, trial, skeleton);
  for (const int bone : carriers) {
    if (!now.line) break;
    for (const bool origin : {true, false}) {
      const std::string& other = (origin ? now.line->insertion : now.line->origin).bone;
      if (skeleton.findBone(other) == bone) continue;
      out.push_back(endingOn(now, origin, bone, trial, skeleton));
      out.push_back(deeper(out.back(), trial, kDeeper[1]));
    }
  }
  const std::size_t onLine = out.size();
  for (const int bone : carriers) {
    if (now.line || skeleton.fileName(bone) != now.primitive.bone)
      out.push_back({riding(now.primitive, bone, skeleton), std::nullopt, "rides " + skeleton.fileName(bone)});
  }
  // Along y, as lines carry bellies.
  const glm::vec3 half = kEnds * trial.body().axes[1];
  for (const int from : carriers) {
    for (const int to : carriers) {
      if (from == to) continue;
      BellyChoice choice{riding(now.primitive, from, skeleton), MuscleLine{}, {}};
      choice.line->name = choice.primitive.line = now.primitive.name;
      choice.line->settings = carryingOnly();
      choice.line->origin = anchorOn(skeleton, from, trial.body().center - half);
      choice.line->insertion = anchorOn(skeleton, to, trial.body().center + half);
      choice.said = "rides between " + skeleton.fileName(from) + " and " + skeleton.fileName(to);
      out.push_back(std::move(choice));
    }
  }
  const std::size_t count = out.size();
  for (std::size_t i = onLine; i < count; ++i) out.push_back(deeper(out[i], trial, kDeeper[1]));
  return out;
}

Rig withTwinsKept(const Rig& before, Rig rig, const MirrorPlan* plan) {
  return plan == nullptr ? std::move(rig) : keepTwins(before, before, std::move(rig), *plan);
}

/// What the others on the line do is not asked.
Result<Rig> withChoice(Rig rig, int primitive, BellyChoice choice, const MirrorPlan* plan) {
  const Rig before = rig;
  if (!choice.primitive.line.empty() && choice.primitive.line == at(rig.primitives, primitive).line) {
    at(rig.primitives, primitive).placement = choice.primitive.placement;
    MuscleLine& line = at(rig.lines, findLine(rig, choice.primitive.line));
    line.origin = choice.line->origin;
    line.insertion = choice.line->insertion;
    line.via = choice.line->via;
    line.settings = choice.line->settings;
    return withTwinsKept(before, std::move(rig), plan);
  }
  const int twin = plan == nullptr ? -1 : twinOf(rig, primitive);
  std::vector<int> off{primitive};
  if (twin >= 0) off.push_back(twin);
  rig = setLineOfSeveral(std::move(rig), off, -1);
  Primitive& own = at(rig.primitives, primitive);
  own.bone = choice.primitive.bone;
  own.placement = choice.primitive.placement;
  rig = withTwinsKept(before, std::move(rig), plan);
  if (!choice.line) return rig;
  Result<Rig> lined = addLine(std::move(rig), std::move(*choice.line));
  if (!lined) return lined;
  Rig done = std::move(lined).value();
  at(done.primitives, primitive).line = done.lines.back().name;
  return twin < 0 ? done : withTwinOnLine(std::move(done), primitive, *plan);
}

}  // namespace

Result<MendedBelly> withMendedBelly(Rig rig, int primitive, const Motions& motions, const MirrorPlan* plan) {
  const Primitive& own = at(rig.primitives, primitive);
  const MuscleLine* line = lineOf(rig, own);
  const BellyChoice now{own, line != nullptr ? std::optional(*line) : std::nullopt, {}};
  const BellyTrial trial(now, rig.surface, motions);
  if (!trial.canTell()) return MendedBelly{std::move(rig), {}};
  for (BellyChoice& choice : choicesFor(now, trial, motions.character().skeleton)) {
    if (choice.line && !lineRest(*choice.line, motions.character())) continue;
    const BellyTrial other(choice, rig.surface, motions);
    if (!other.canTell() || other.trouble(kMendedMargin) > kMendedMargin) continue;
    std::string said = choice.said;
    Result<Rig> done = withChoice(std::move(rig), primitive, std::move(choice), plan);
    if (!done) return done.error();
    return MendedBelly{std::move(done).value(), std::move(said)};
  }
  return MendedBelly{std::move(rig), {}};
}

std::optional<BellyChoice> withDeeperBelly(const BellyChoice& choice, const SurfaceSettings& surface,
                                           const Motions& motions) {
  const BellyTrial trial(choice, surface, motions);
  if (!trial.canTell()) return std::nullopt;
  for (const float factor : kDeeper) {
    BellyChoice other = deeper(choice, trial, factor);
    const BellyTrial tried(other, surface, motions);
    if (tried.canTell() && tried.trouble(kMendedMargin) <= kMendedMargin) return other;
  }
  return std::nullopt;
}

Rig withoutFarSkin(Rig rig, const Finding& finding, const MirrorPlan* plan) {
  const Rig before = rig;
  Primitive& own = at(rig.primitives, finding.primitive);
  if (own.territory) std::erase(*own.territory, finding.bone);
  return withTwinsKept(before, std::move(rig), plan);
}

}  // namespace sinew
