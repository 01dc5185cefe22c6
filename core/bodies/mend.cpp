// core/bodies/mend.cpp: tries candidates, those that change least first, and measures each over all poses.
#include "core/bodies/mend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/bodies/check.h"
#include "core/bodies/motions.h"
#include "core/bodies/relaid_belly.h"
#include "core/character/bone_segments.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/twins.h"

namespace sinew {

namespace {

constexpr float kReach[] = {1.0f, 0.5f, 0.25f};
constexpr float kTendon[] = {0.3f, 0.45f, 0.6f};
constexpr float kShare[] = {0.45f, 0.3f};
constexpr float kInwards[] = {0.0f, 0.5f, 1.0f};
constexpr float kLarger = 1.4f;
constexpr float kMuchLarger = 2.0f;  ///< Only for muscles that ride a bone, as a last resort.
constexpr BellyBone kBones[] = {BellyBone::kOrigin, BellyBone::kInsertion};

/// Tries choices over all poses, beginning with the pose at which the last one failed.
class Search {
 public:
  Search(const SurfaceSettings& surface, const Motions& motions) : surface_(surface), motions_(motions) {}

  [[nodiscard]] bool isClean(const BellyChoice& choice) {
    const BellyTrial trial(choice, surface_, motions_);
    return trial.canTell() && trial.trouble(kMendedMargin, &first_) <= kMendedMargin;
  }
  /// Tries the choice as it is and with a via point on its bone; then both larger.
  std::optional<BellyChoice> cleanOf(const BellyChoice& choice, bool mayGrow) {
    const Skeleton& skeleton = motions_.character().skeleton;
    for (const bool grows : {false, true}) {
      if (grows && !mayGrow) break;
      const BellyChoice sized = grows ? withLessFlex(larger(choice, kLarger)) : choice;
      for (BellyChoice& each : std::array{sized, ledByItsBone(sized, skeleton)}) {
        if (!lineRest(*each.line, motions_.character())) continue;
        learnFull(*each.line, motions_);
        if (isClean(each)) return std::move(each);
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] float troubleOf(const BellyChoice& choice) const {
    const BellyTrial trial(choice, surface_, motions_);
    return trial.canTell() ? trial.trouble() : std::numeric_limits<float>::max();
  }

 private:
  static BellyChoice withLessFlex(BellyChoice choice) {
    choice.line->settings.flex *= 0.5f;
    return choice;
  }

  const SurfaceSettings& surface_;
  const Motions& motions_;
  std::size_t first_ = 0;
};

std::optional<BellyChoice> asDrawnOf(const RelaidBelly& relaid, Search& search) {
  for (const float reach : kReach) {
    for (const BellyBone bone : kBones) {
      if (auto clean = search.cleanOf(relaid.asDrawn(bone, reach), false)) return clean;
    }
  }
  return std::nullopt;
}

/// Nearest to the drawn muscle first.
void sortByDistance(std::vector<BellyChoice>& choices, const RelaidBelly& relaid) {
  std::ranges::stable_sort(choices, {}, [&](const BellyChoice& choice) { return relaid.distanceOf(choice); });
}

std::optional<BellyChoice> relaidOf(const RelaidBelly& relaid, Search& search) {
  std::vector<BellyChoice> choices;
  const auto add = [&](std::optional<BellyChoice> choice) {
    if (choice && relaid.isNear(*choice)) choices.push_back(std::move(*choice));
  };
  for (const float reach : kReach) {
    for (const BellyBone bone : kBones) {
      for (const float tendon : kTendon) add(relaid.shorter(bone, reach, tendon));
      for (const float inwards : kInwards) {
        for (const float share : kShare) add(relaid.under(bone, reach, share, inwards));
      }
    }
  }
  sortByDistance(choices, relaid);
  for (const BellyChoice& choice : choices) {
    if (auto clean = search.cleanOf(choice, true)) return clean;
  }
  return std::nullopt;
}

/// For a line across several joints: one end at the same place on a bone between, which the skin there follows, too.
std::vector<BellyChoice> overFewerJoints(const BellyChoice& drawn, const Character& character) {
  const LineRest rest = lineRest(*drawn.line, character).value();
  std::vector<BellyChoice> out;
  for (const int bone : bonesBetween(character.skeleton, rest.origin.bone, rest.insertion.bone)) {
    if (bone == rest.origin.bone || bone == rest.insertion.bone) continue;
    for (const BellyBone end : kBones) {
      const bool isOrigin = end == BellyBone::kOrigin;
      BellyChoice choice = drawn;
      const glm::vec3 place(isOrigin ? rest.origin.inBind : rest.insertion.inBind);
      LineAnchor& anchor = isOrigin ? choice.line->origin : choice.line->insertion;
      anchor = anchorOn(character.skeleton, bone, place);
      choice.said = (isOrigin ? "origin on " : "insertion on ") + anchor.bone;
      out.push_back(std::move(choice));
    }
  }
  return out;
}

std::optional<BellyChoice> cleanOf(const RelaidBelly& relaid, Search& search) {
  auto clean = asDrawnOf(relaid, search);
  return clean ? std::move(clean) : relaidOf(relaid, search);
}

/// Riding the line's own bones or those that carry the skin over the drawn muscle, nearest first; then larger ones.
std::vector<BellyChoice> ridingOf(const RelaidBelly& relaid, const BellyTrial& trial, const Character& character) {
  std::vector<BellyChoice> out;
  const auto add = [&](const OwnSkin& skin, const glm::vec3& near) {
    for (const float inwards : kInwards) {
      if (auto choice = relaid.riding(skin, near, inwards)) out.push_back(std::move(*choice));
    }
  };
  for (const BellyBone bone : kBones) out.push_back(offItsLine(relaid.asDrawn(bone, 1.0f)));
  for (const BellyBone bone : kBones) add(relaid.skin(bone), relaid.ownEnd(bone));
  for (const int bone : trial.carriers()) {
    if (std::ranges::any_of(kBones, [&](BellyBone own) { return relaid.skin(own).bone() == bone; })) continue;
    add(OwnSkin(character, bone), trial.body().center);
  }
  sortByDistance(out, relaid);
  const std::size_t count = out.size();
  for (const float factor : {kLarger, kMuchLarger}) {
    for (std::size_t i = 0; i < count; ++i) out.push_back(larger(out[i], factor));
  }
  return out;
}

}  // namespace

std::optional<DrawnMuscle> withDrawnMuscle(const BellyChoice& drawn, const SurfaceSettings& surface,
                                           const Motions& motions) {
  const BellyTrial trial(drawn, surface, motions);
  if (!trial.canTell()) return std::nullopt;
  const RelaidBelly relaid(drawn, trial, motions.character());
  Search search(surface, motions);
  if (auto clean = cleanOf(relaid, search)) return DrawnMuscle{std::move(*clean), true};
  for (const BellyChoice& nearer : overFewerJoints(drawn, motions.character())) {
    if (!lineRest(*nearer.line, motions.character())) continue;
    auto clean = cleanOf(RelaidBelly(nearer, trial, motions.character()), search);
    if (!clean) continue;
    clean->said = nearer.said + ", " + clean->said;
    return DrawnMuscle{std::move(*clean), true};
  }
  std::vector<BellyChoice> riding = ridingOf(relaid, trial, motions.character());
  for (BellyChoice& choice : riding) {
    if (search.isClean(choice)) return DrawnMuscle{std::move(choice), true};
  }
  if (riding.empty()) return std::nullopt;
  const auto best = std::ranges::min_element(riding, {}, [&](const BellyChoice& of) { return search.troubleOf(of); });
  const bool isClean = search.troubleOf(*best) <= 1.0f;
  return DrawnMuscle{std::move(*best), isClean};
}

std::optional<BellyChoice> withNearerEnd(const BellyChoice& drawn, const SurfaceSettings& surface,
                                         const Motions& motions) {
  const BellyTrial trial(drawn, surface, motions);
  if (!trial.canTell()) return std::nullopt;
  Search search(surface, motions);
  return asDrawnOf(RelaidBelly(drawn, trial, motions.character()), search);
}

namespace {

constexpr float kRigidFrom = 2.0f;  ///< Trouble::path from which a line does more harm than none.

/// One line and its first muscle, in a rig of their own.
class LineTrial {
 public:
  LineTrial(const Rig& rig, int line, int primitive, const Motions& motions) : motions_(motions) {
    trial_.surface = rig.surface;
    trial_.lines = {at(rig.lines, line)};
    trial_.primitives = {at(rig.primitives, primitive)};
    trial_.lines[0].animated.clear();
    trial_.primitives[0].animated.clear();
    const Character& character = motions.character();
    if (const auto bone = character.skeleton.findBone(trial_.primitives[0].bone)) {
      const RigPoser poser(trial_, character);
      belly_ =
          FollowedBelly::create(character, motions.skin(), poser.pose(bindPose(character.skeleton)).muscles[0], *bone);
    }
    if (belly_) frames_ = motions.framesOf(belly_->spots());
  }

  [[nodiscard]] bool canTell() const { return belly_.has_value(); }
  [[nodiscard]] const SkinSpot& spot() const { return belly_->spots()[0]; }

  /// @param enough  stops after a pose with a worse path
  Trouble trouble(const MuscleLine& line, float enough = std::numeric_limits<float>::max()) {
    trial_.lines[0].via = line.via;
    trial_.lines[0].settings = line.settings;
    const RigPoser poser(trial_, motions_.character());
    Trouble out;
    constexpr std::size_t kPoints = FollowedBelly::kPoints;
    const std::size_t count = motions_.poses().size();
    for (std::size_t k = 0; k < count && out.path <= enough; ++k) {
      const std::size_t i = (worst_ + k) % count;
      poser.pose(motions_.poses()[i], posed_);
      const PosedLine& shown = posed_.lines[0];
      if (!shown.usable) continue;
      const BellyMotion motion = belly_->motion(posed_.muscles[0], std::span(frames_).subspan(i * kPoints, kPoints));
      out.add(troubleOf(*belly_, motion, shown, motions_.shareOf(i)));
      if (out.path > enough) worst_ = i;
    }
    return out;
  }

 private:
  const Motions& motions_;
  Rig trial_;
  std::optional<FollowedBelly> belly_;
  std::vector<std::optional<SkinFrame>> frames_;
  PosedRig posed_;
  std::size_t worst_ = 0;  ///< Pose at which the last line failed; tried first.
};

struct LineChoice {
  MuscleLine line;
  std::string said;
};

/// The line's pivot, at most 1 where its distance to the bone is the thickness of the flesh, fading to 0 at twice that.
float fadedPivot(const LineRest& rest, const SkinSpot& spot, const Character& character) {
  const auto frame = frameAt(character, spot, bindPose(character.skeleton));
  if (!frame) return rest.settings.pivot;
  const glm::vec3 middle(0.5 * (rest.origin.inBind + rest.insertion.inBind));
  const float flesh = std::max(glm::distance(frame->origin, middle), 1e-6f * character.height);
  const auto away = static_cast<float>(rest.height);
  return std::min(rest.settings.pivot, std::clamp(2.0f - away / flesh, 0.0f, 1.0f));
}

std::string inWords(float number) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2g", static_cast<double>(number));
  return text;
}

std::vector<LineChoice> candidatesFor(const Rig& rig, int line, const SkinSpot& spot, const Character& character) {
  const MuscleLine& own = at(rig.lines, line);
  std::vector<LineChoice> out{{own, ""}};
  const Result<LineRest> rest = lineRest(own, character);
  if (!rest) return out;
  const float pivot = fadedPivot(rest.value(), spot, character);
  std::vector<float> pivots;
  for (const float value : {own.settings.pivot, pivot, 0.0f}) {
    if (std::ranges::find(pivots, value) == pivots.end()) pivots.push_back(value);
  }
  const auto add = [&](const MuscleLine& led, const std::string& said) {
    for (const float value : pivots) {
      LineChoice candidate{led, said};
      candidate.line.settings.pivot = value;
      if (value != own.settings.pivot) candidate.said = "pivot " + inWords(value) + (said.empty() ? "" : ", ") + said;
      out.push_back(std::move(candidate));
    }
  };
  add(own, "");
  if (own.via) {
    MuscleLine straight = own;
    straight.via.reset();
    add(straight, "no via point");
  }
  const glm::dvec2 tendons(own.settings.tendons);
  const glm::dvec3 along = rest->insertion.inBind - rest->origin.inBind;
  const glm::dvec3 middle = rest->origin.inBind + 0.5 * (1.0 + tendons.x - tendons.y) * along;
  for (const int bone : bonesAt(character, spot)) {
    MuscleLine led = own;
    led.via = anchorOn(character.skeleton, bone, glm::vec3(middle));
    add(led, "via point on " + led.via->bone);
  }
  if (const Result<Rig> beside = withViaPoint(rig, line, character)) {
    add(at(beside->lines, line), "via point beside the joint");
  }
  // The belly may follow either bone.
  const std::size_t halfWay = out.size();
  for (std::size_t i = 0; i < halfWay; ++i) {
    for (const float twist : {0.0f, 1.0f}) {
      if (out[i].line.settings.twist == twist) continue;
      out.push_back(out[i]);
      out.back().line.settings.twist = twist;
      out.back().said += std::string(out.back().said.empty() ? "" : ", ") + "twist " + inWords(twist);
    }
  }
  return out;
}

/// Settings that make a short belly less and less thick.
std::vector<std::pair<LineSettings, std::string>> thinner(const LineSettings& settings) {
  std::vector<std::pair<LineSettings, std::string>> out;
  LineSettings next = settings;
  const auto add = [&](const char* said) { out.emplace_back(next, said); };
  next.flex = glm::min(0.5f * settings.flex, settings.flex);
  add("half the flex");
  next.tendons = 0.5f * settings.tendons;
  add("half the flex, shorter tendons");
  next.volume = std::min(settings.volume, 0.5f);
  add("half the flex, shorter tendons, less volume");
  next.tendons = {0.0f, 0.0f};
  next.flex = glm::min(glm::vec2(0.0f), settings.flex);
  next.volume = 0.0f;
  add("no flex, no tendons, no volume");
  return out;
}

/// The muscles ride the bone that carries the skin over them, at the same place.
Mended withoutLine(Rig rig, std::span<const int> bellies, int bone, const Skeleton& skeleton) {
  for (const int belly : bellies) rideBone(at(rig.primitives, belly), bone, skeleton);
  return {setLineOfSeveral(std::move(rig), bellies, -1),
          "no line between its bones stays in the flesh, so it rides " + skeleton.fileName(bone), true, true};
}

void sayItLeaves(std::string& said) {
  said += std::string(said.empty() ? "" : ", ") + "and it still leaves the flesh somewhere";
}

Result<Mended> withChoice(Rig rig, int line, int belly, BellyChoice choice) {
  Mended out;
  out.said = std::move(choice.said);
  Primitive& own = at(rig.primitives, belly);
  own.bone = choice.primitive.bone;
  own.placement = choice.primitive.placement;
  if (!choice.line) {
    out.isRigid = true;
    out.rig = setLineOfSeveral(std::move(rig), std::array{belly}, -1);
    return out;
  }
  Result<Rig> edited = editLine(std::move(rig), line, [&](MuscleLine& of) {
    of.origin = choice.line->origin;
    of.insertion = choice.line->insertion;
    of.via = choice.line->via;
    of.settings = choice.line->settings;
  });
  if (!edited) return edited.error();
  out.rig = std::move(edited).value();
  return out;
}

/// For a single muscle that no line mends: deeper, else with its other end or itself elsewhere. nullopt: nothing helps.
std::optional<Result<Mended>> withNewPlace(const Rig& rig, int line, int belly, const LineChoice& best,
                                           const Motions& motions, MadeLine made) {
  const BellyChoice drawn{at(rig.primitives, belly), at(rig.lines, line), {}};
  BellyChoice deeper = drawn;
  deeper.line = best.line;
  deeper.said = best.said;
  if (const auto clean = withDeeperBelly(deeper, rig.surface, motions)) return withChoice(rig, line, belly, *clean);
  if (!lineRest(*drawn.line, motions.character())) return std::nullopt;
  if (made == MadeLine::kOtherEnd) {
    const auto clean = withNearerEnd(drawn, rig.surface, motions);
    return clean ? std::optional(withChoice(rig, line, belly, *clean)) : std::nullopt;
  }
  auto muscle = withDrawnMuscle(drawn, rig.surface, motions);
  if (!muscle) return std::nullopt;
  Result<Mended> done = withChoice(rig, line, belly, std::move(muscle->choice));
  if (done && !muscle->isClean) {
    done.value().isClean = false;
    sayItLeaves(done.value().said);
  }
  return done;
}

}  // namespace

Result<Mended> withMendedLine(Rig rig, int line, const Motions& motions, MadeLine made) {
  const Character& character = motions.character();
  const std::vector<int> bellies = primitivesOn(rig, at(rig.lines, line).name);
  if (bellies.empty() || motions.poses().empty()) return Mended{std::move(rig), {}};
  LineTrial trial(rig, line, bellies.front(), motions);
  if (!trial.canTell()) return Mended{std::move(rig), {}};
  Mended out;
  std::optional<LineChoice> best;
  Trouble least;
  for (LineChoice& candidate : candidatesFor(rig, line, trial.spot(), character)) {
    const Trouble trouble = best ? trial.trouble(candidate.line, least.path) : trial.trouble(candidate.line);
    if (best && !(trouble.path < least.path)) continue;
    least = trouble;
    best = std::move(candidate);
    // The designer's own line stays as long as it has no findings.
    if (least.path <= (best->said.empty() ? 1.0f : kMendedMargin)) break;
  }
  out.said = best->said;
  const bool isNew = made != MadeLine::kBefore;
  if (isNew) {
    learnFull(best->line, motions);
    least = trial.trouble(best->line);
  }
  if (least.ball > 1.0f) {
    for (const auto& [settings, said] : thinner(best->line.settings)) {
      MuscleLine thin = best->line;
      thin.settings = settings;
      const Trouble trouble = trial.trouble(thin);
      if (trouble.path > std::max(1.0f, least.path)) continue;
      best->line = thin;
      least = trouble;
      out.said = best->said + (best->said.empty() ? "" : ", ") + said;
      if (least.ball <= 1.0f) break;
    }
  }
  out.isClean = least.path <= 1.0f && least.ball <= 1.0f;
  if (isNew && !out.isClean && bellies.size() == 1) {
    if (auto placed = withNewPlace(rig, line, bellies.front(), *best, motions, made)) return std::move(*placed);
  }
  if (least.path > kRigidFrom) {
    const std::vector<int> carriers = bonesAt(character, trial.spot());
    return withoutLine(std::move(rig), bellies, carriers.front(), character.skeleton);
  }
  Result<Rig> edited = editLine(std::move(rig), line, [&](MuscleLine& of) {
    of.via = best->line.via;
    of.settings = best->line.settings;
  });
  if (!edited) return edited.error();
  out.rig = std::move(edited).value();
  if (isNew && !out.isClean) sayItLeaves(out.said);
  return out;
}

Result<MendedRig> withMendedFindings(Rig rig, std::span<const Finding> findings, const Motions& motions,
                                     const MirrorPlan* plan) {
  MendedRig out{std::move(rig), {}};
  std::vector<std::string> done;
  const auto isDone = [&](const std::string& name) { return std::ranges::find(done, name) != done.end(); };
  for (const Finding& finding : findings) {
    if (!at(out.rig.primitives, finding.primitive).sheet.empty()) continue;
    const std::string name = at(out.rig.primitives, finding.primitive).line;
    const int line = findLine(out.rig, name);
    if (line < 0 || isDone(name) || finding.kind == FindingKind::kReachesAcross) continue;
    done.push_back(name);
    const std::string twin = plan ? at(out.rig.lines, line).mirror : "";
    if (!twin.empty()) done.push_back(twin);
    Result<Mended> mended = withMendedLine(out.rig, line, motions, MadeLine::kBefore);
    if (!mended) return mended.error();
    if (mended->said.empty()) continue;
    out.said.push_back(name + ": " + mended->said);
    Rig edited = std::move(mended.value().rig);
    if (mended->isRigid && !twin.empty()) {
      const std::vector<int> bellies = primitivesOn(edited, twin);
      edited = setLineOfSeveral(std::move(edited), bellies, -1);
    }
    out.rig = plan ? keepTwins(out.rig, out.rig, std::move(edited), *plan) : std::move(edited);
  }
  return out;
}

std::vector<Finding> findingsFrom(const Rig& rig, std::size_t first, const Motions& motions) {
  std::vector<Finding> findings = check(rig, motions);
  std::erase_if(findings, [&](const Finding& finding) {
    return static_cast<std::size_t>(finding.primitive) < first || !at(rig.primitives, finding.primitive).sheet.empty();
  });
  return findings;
}

Result<MendedRig> withMendedRig(Rig rig, std::size_t first, const Motions& motions, const MirrorPlan* plan) {
  const std::vector<Finding> found = findingsFrom(rig, first, motions);
  if (found.empty()) return MendedRig{std::move(rig), {}};
  Result<MendedRig> lines = withMendedFindings(std::move(rig), found, motions, plan);
  if (!lines) return lines;
  MendedRig mended = std::move(lines).value();
  std::vector<int> done;
  for (const Finding& finding : findingsFrom(mended.rig, first, motions)) {
    const std::string name = at(mended.rig.primitives, finding.primitive).name;
    const int twin = plan == nullptr ? -1 : twinOf(mended.rig, finding.primitive);
    const bool twinDone = twin >= 0 && std::ranges::find(done, twin) != done.end();
    if (finding.kind == FindingKind::kReachesAcross) {
      mended.rig = withoutFarSkin(std::move(mended.rig), finding, plan);
      if (twin < 0 || finding.primitive < twin) mended.said.push_back(name + ": does not move skin of " + finding.bone);
    } else if (!twinDone && std::ranges::find(done, finding.primitive) == done.end()) {
      done.push_back(finding.primitive);
      Result<MendedBelly> belly = withMendedBelly(std::move(mended.rig), finding.primitive, motions, plan);
      if (!belly) return belly.error();
      mended.rig = std::move(belly.value().rig);
      if (belly->said.empty()) continue;
      // Earlier changes of its line no longer apply.
      const std::string twinName = twin >= 0 ? at(mended.rig.primitives, twin).name : name;
      std::erase_if(mended.said, [&](const std::string& said) {
        return said.starts_with(name + ": ") || said.starts_with(twinName + ": ");
      });
      mended.said.push_back(name + ": " + belly->said);
    }
  }
  return mended;
}

}  // namespace sinew
