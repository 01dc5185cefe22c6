// core/bodies/relaid_belly.cpp: lays bellies between a line and the skin; tries them over all poses.
#include "core/bodies/relaid_belly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/bodies/check.h"
#include "core/character/bindings.h"
#include "core/character/bone_segments.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/triangle_tree.h"
#include "core/rig/line_edit.h"
#include "core/rig/line_pose.h"
#include "core/rig/line_rest.h"
#include "core/rig/twins.h"

namespace sinew {

namespace {

constexpr float kDeeper[] = {1.2f, 1.5f};
constexpr float kEnds = 0.9f;  ///< Ends of a line that only carries, fraction of the half length.

/// Higher by its lower side alone, so that the skin over it hardly changes.
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

Primitive riding(Primitive primitive, int bone, const Skeleton& skeleton) {
  primitive.line.clear();
  rideBone(primitive, bone, skeleton);
  return primitive;
}

/// Moves half way between two bones and keeps the girth.
LineSettings carryingOnly() {
  LineSettings settings;
  settings.tendons = {0.0f, 0.0f};
  settings.volume = 0.0f;
  settings.pivot = 0.0f;
  settings.flex = {0.0f, 0.0f};
  settings.gain = 0.0f;
  return settings;
}

/// Bones next to the muscle's own that carry its skin, most weight first: a muscle of the neck must not ride the head.
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

/// One end and a via point on the bone under the belly, so that only the other end crosses a joint.
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

/// Ignores other muscles on the line.
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

namespace {

constexpr float kHalf = 0.5f;  ///< Fraction of the largest weight of any triangle.
constexpr float kFirm = 0.9f;
constexpr float kLeastCarried = 0.05f;

float shareOf(const Character& character, int vertex, int bone) {
  float own = 0.0f;
  float all = 0.0f;
  for (const WeightedBinding& follows : bindingsOf(character, vertex)) {
    all += follows.weight;
    if (follows.bone() == bone) own += follows.weight;
  }
  return all > 0.0f ? own / all : 0.0f;
}

}  // namespace

OwnSkin::OwnSkin(const Character& character, int bone) : character_(character), bone_(bone) {
  const ControlMesh& mesh = character.mesh;
  std::vector<float> shares(mesh.positions.size());
  for (std::size_t v = 0; v < shares.size(); ++v) shares[v] = shareOf(character, static_cast<int>(v), bone);
  const Pose bind = bindPose(character.skeleton);
  float most = 0.0f;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& corners = at(mesh.triangles, t).vertices;
    const float weight = std::min({at(shares, corners[0]), at(shares, corners[1]), at(shares, corners[2])});
    if (weight < kLeastCarried) continue;
    const auto frame = frameAt(character, {t, glm::vec3(1.0f / 3.0f)}, bind);
    if (!frame) continue;
    half_.push_back({t, *frame, weight});
    most = std::max(most, weight);
  }
  std::erase_if(half_, [&](const OwnTriangle& own) { return own.weight < kHalf * most; });
  for (const OwnTriangle& own : half_) {
    if (own.weight < kFirm * most) continue;
    firm_.push_back(own);
    middle_ += own.frame.origin;
  }
  if (!firm_.empty()) middle_ /= static_cast<float>(firm_.size());
}

std::optional<SkinFrame> OwnSkin::nearest(const glm::vec3& point) const {
  std::optional<SkinFrame> best;
  float least = std::numeric_limits<float>::max();
  for (const OwnTriangle& own : half_) {
    const TriangleCorners places = controlCorners(character_.mesh, own.triangle);
    const glm::vec3 place = mixed(places, nearestOnTriangle(point, places));
    const glm::vec3 off = point - place;
    if (glm::dot(off, off) >= least) continue;
    least = glm::dot(off, off);
    best = SkinFrame{place, own.frame.axes};
  }
  return best;
}

namespace {

constexpr float kOwnTendon = 0.1f;    ///< Fraction of the line; of the half length for a belly under the skin.
constexpr float kLeastHalf = 0.35f;   ///< Shortest half length, fraction of that drawn.
constexpr float kFarHalves = 3.0f;    ///< Largest distance from the drawn muscle, in drawn half lengths,
constexpr float kFarHeight = 0.1f;    ///< or, if larger, as a fraction of H.
constexpr float kLeastAcross = 0.5f;  ///< Sine between line and skin normal; steeper lines run out of the skin.
constexpr float kMostCosine = 0.7f;   ///< Cosine between skin normal and the direction to the other end.
constexpr float kMostAside = 0.5f;    ///< From the belly's middle to its skin along the line, fraction of half length.
constexpr float kNearest = 0.01f;     ///< Nearest other end, fraction of H.

/// The direction of a unit vector's part across another; nullopt: that part is shorter than `least`.
std::optional<glm::vec3> acrossTo(const glm::vec3& unit, const glm::vec3& along, float least) {
  const glm::vec3 across = unit - glm::dot(unit, along) * along;
  const float size = glm::length(across);
  return size < least ? std::nullopt : std::optional(across / size);
}

std::string withReach(std::string said, BellyBone bone, float reach) {
  if (reach < 1.0f) {
    said += said.empty() ? "" : ", ";
    said += bone == BellyBone::kOrigin ? "insertion nearer to the joint" : "origin nearer to the joint";
  }
  return said;
}

}  // namespace

RelaidBelly::RelaidBelly(const BellyChoice& drawn, const BellyTrial& trial, const Character& character)
    : drawn_(drawn),
      character_(character),
      rest_(lineRest(*drawn.line, character).value()),
      skins_{OwnSkin(character, rest_.origin.bone), OwnSkin(character, rest_.insertion.bone)},
      joint_(jointBetween(rest_, character)),
      middle_(trial.body().center),
      half_(glm::length(trial.body().axes[1])) {
  const glm::vec3 top = trial.body().center + glm::length(trial.body().axes[2]) * trial.outwards();
  const auto skin = frameAt(character, trial.spot(), bindPose(character.skeleton));
  if (skin) stands_ = std::max(0.0f, glm::dot(top - skin->origin, skin->normal()));
}

glm::vec3 RelaidBelly::ownEnd(BellyBone bone) const {
  return glm::vec3(bone == BellyBone::kOrigin ? rest_.origin.inBind : rest_.insertion.inBind);
}

glm::vec3 RelaidBelly::otherEnd(BellyBone bone, float reach) const {
  const glm::vec3 other = ownEnd(bone == BellyBone::kOrigin ? BellyBone::kInsertion : BellyBone::kOrigin);
  return joint_ + reach * (other - joint_);
}

/// Half way from the skin to the bone, at most as deep as a belly is thick.
glm::vec3 RelaidBelly::lineUnder(int bone, const SkinFrame& skin) const {
  const glm::vec3 onAxis = bindSegment(at(character_.skeleton.bones, bone)).nearest(skin.origin);
  const float depth = std::clamp(0.5f * glm::dot(skin.origin - onAxis, skin.normal()), 0.0f, 0.5f * half_);
  return skin.origin - depth * skin.normal();
}

MuscleLine RelaidBelly::lineOf(BellyBone bone, const glm::vec3& own, const glm::vec3& other) const {
  const bool atOrigin = bone == BellyBone::kOrigin;
  MuscleLine line = *drawn_.line;
  line.origin = anchorOn(character_.skeleton, rest_.origin.bone, atOrigin ? own : other);
  line.insertion = anchorOn(character_.skeleton, rest_.insertion.bone, atOrigin ? other : own);
  line.via.reset();
  line.settings.pivot = 0.0f;
  line.settings.twist = atOrigin ? 0.0f : 1.0f;
  return line;
}

void RelaidBelly::place(BellyChoice& choice, int bone, const Placement& belly) const {
  const glm::dmat4 toBone(at(character_.skeleton.bones, bone).inverseBindInWorld);
  choice.primitive.placement = imageOf(belly, {glm::dmat3(toBone), glm::dvec3(toBone[3])});
  choice.primitive.bone = character_.skeleton.fileName(bone);
}

float RelaidBelly::distanceOf(const BellyChoice& choice) const {
  const Bone& bone = at(character_.skeleton.bones, *character_.skeleton.findBone(choice.primitive.bone));
  const glm::vec3 middle(bone.bindInWorld * glm::vec4(choice.primitive.placement.center, 1.0f));
  return glm::distance(middle, middle_);
}

bool RelaidBelly::isNear(const BellyChoice& choice) const {
  return distanceOf(choice) <= std::max(kFarHalves * half_, kFarHeight * character_.height);
}

BellyChoice RelaidBelly::asDrawn(BellyBone bone, float reach) const {
  BellyChoice choice = drawn_;
  choice.line = lineOf(bone, ownEnd(bone), otherEnd(bone, reach));
  rideBone(choice.primitive, skin(bone).bone(), character_.skeleton);
  choice.said = withReach("goes with " + choice.primitive.bone, bone, reach);
  return choice;
}

/// @param tendons  at its own and at the other end, fractions of the line
std::optional<BellyChoice> RelaidBelly::laid(BellyBone bone, const glm::vec3& own, const glm::vec3& other,
                                             const glm::vec2& tendons, const SkinFrame& skin) const {
  const float length = glm::distance(own, other);
  const float half = 0.5f * (1.0f - tendons.x - tendons.y) * length;
  if (!(half >= kLeastHalf * half_)) return std::nullopt;
  const bool atOrigin = bone == BellyBone::kOrigin;
  const glm::vec3 away = (other - own) / length;
  const glm::vec3 along = atOrigin ? away : -away;
  const auto out = acrossTo(skin.normal(), along, kLeastAcross);
  if (!out) return std::nullopt;
  // Below the nearest skin, even if the line runs outside the body.
  const glm::vec3 off = skin.origin - (own + (tendons.x * length + half) * away);
  if (std::abs(glm::dot(off, along)) > kMostAside * half) return std::nullopt;
  BellyChoice choice = drawn_;
  choice.line = lineOf(bone, own, other);
  choice.line->settings.tendons = atOrigin ? tendons : glm::vec2(tendons.y, tendons.x);
  if (!lineRest(*choice.line, character_)) return std::nullopt;
  const float depth = std::max(0.0f, glm::dot(off, skin.normal()));
  const float stands = std::min(stands_, kBellyBulge * half);
  place(choice, this->skin(bone).bone(), bellyOnLine(skin.origin - depth * *out, along, *out, depth + stands, half));
  return choice;
}

std::optional<BellyChoice> RelaidBelly::shorter(BellyBone bone, float reach, float tendon) const {
  const glm::vec3 own = ownEnd(bone);
  const glm::vec3 other = otherEnd(bone, reach);
  const float middle = kOwnTendon + 0.5f * (1.0f - kOwnTendon - tendon);
  const auto over = skin(bone).nearest(glm::mix(own, other, middle));
  if (!over) return std::nullopt;
  auto choice = laid(bone, own, other, {kOwnTendon, tendon}, *over);
  if (choice) choice->said = withReach("shorter, along " + choice->primitive.bone, bone, reach);
  return choice;
}

std::optional<BellyChoice> RelaidBelly::under(BellyBone bone, float reach, float share, float inwards) const {
  const OwnSkin& skin = this->skin(bone);
  const glm::vec3 other = otherEnd(bone, reach);
  const glm::vec3 wanted = glm::mix(ownEnd(bone), skin.middle(), inwards);
  const OwnTriangle* best = nullptr;
  float least = std::numeric_limits<float>::max();
  for (const OwnTriangle& own : skin.firm()) {
    const glm::vec3 way = other - lineUnder(skin.bone(), own.frame);
    const float length = glm::length(way);
    if (!(length > kNearest * character_.height)) continue;
    if (std::abs(glm::dot(way, own.frame.normal())) > kMostCosine * length) continue;
    const float off = glm::distance(own.frame.origin, wanted);
    if (off >= least) continue;
    least = off;
    best = &own;
  }
  if (best == nullptr) return std::nullopt;
  const glm::vec3 middle = lineUnder(skin.bone(), best->frame);
  const float way = glm::distance(middle, other);
  const float half = std::min(share * way, half_);
  const float tendon = kOwnTendon * half;
  const float length = way + half + tendon;
  const glm::vec2 tendons(tendon / length, (way - half) / length);
  if (tendons.x + tendons.y > kMostTendons) return std::nullopt;
  auto choice = laid(bone, middle + (half + tendon) / way * (middle - other), other, tendons, best->frame);
  if (choice) choice->said = withReach("under the skin of " + choice->primitive.bone, bone, reach);
  return choice;
}

std::optional<BellyChoice> RelaidBelly::riding(const OwnSkin& skin, const glm::vec3& near, float inwards) const {
  const glm::vec3 wanted = glm::mix(near, skin.middle(), inwards);
  const auto over = std::ranges::min_element(
      skin.firm(), {}, [&](const OwnTriangle& own) { return glm::distance(own.frame.origin, wanted); });
  if (over == skin.firm().end()) return std::nullopt;
  const glm::vec3& out = over->frame.normal();
  const auto drawn = acrossTo(glm::vec3(rest_.direction), out, kLeastAcross);
  const glm::vec3 along = drawn ? *drawn : over->frame.axes[0];
  BellyChoice choice = drawn_;
  const glm::vec3 middle = lineUnder(skin.bone(), over->frame);
  const float top = glm::distance(middle, over->frame.origin) + std::min(stands_, kBellyBulge * half_);
  place(choice, skin.bone(), bellyOnLine(middle, along, out, top, half_));
  return offItsLine(std::move(choice));
}

void rideBone(Primitive& primitive, int bone, const Skeleton& skeleton) {
  const std::optional<int> from = skeleton.findBone(primitive.bone);
  if (!from || *from == bone) return;
  primitive.placement =
      carryToBone(primitive.placement, at(skeleton.bones, *from).bindInWorld, at(skeleton.bones, bone).bindInWorld);
  primitive.bone = skeleton.fileName(bone);
}

BellyChoice offItsLine(BellyChoice choice) {
  choice.line.reset();
  choice.primitive.line.clear();
  choice.said = "no line between its bones stays in the flesh, so it rides " + choice.primitive.bone;
  return choice;
}

BellyChoice larger(BellyChoice choice, float factor) {
  Placement& placement = choice.primitive.placement;
  placement.center -= (factor - 1.0f) * placement.radii.z * glm::mat3_cast(placement.rotation)[2];
  placement.radii *= glm::vec3(factor, 1.0f, factor);
  choice.said += ", larger";
  return choice;
}

BellyChoice ledByItsBone(BellyChoice choice, const Skeleton& skeleton) {
  const int bone = *skeleton.findBone(choice.primitive.bone);
  const glm::vec4 middle(choice.primitive.placement.center, 1.0f);
  choice.line->via = anchorOn(skeleton, bone, glm::vec3(at(skeleton.bones, bone).bindInWorld * middle));
  choice.said += ", via point on " + choice.primitive.bone;
  return choice;
}

}  // namespace sinew
