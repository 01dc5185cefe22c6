// core/bodies/mend_drawn.cpp: from what is nearest to what was drawn on, until one is clean.
#include "core/bodies/mend_drawn.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/bodies/learn_full.h"
#include "core/bodies/relaid_belly.h"
#include "core/character/bones_between.h"

namespace sinew {
namespace {

constexpr float kReach[] = {1.0f, 0.5f, 0.25f};
constexpr float kTendon[] = {0.3f, 0.45f, 0.6f};
constexpr float kShare[] = {0.45f, 0.3f};
constexpr float kInwards[] = {0.0f, 0.5f, 1.0f};
constexpr float kLarger = 1.4f;
constexpr float kMuchLarger = 2.0f;  ///< Of muscles that ride a bone, where nothing else is left.
constexpr BellyBone kBones[] = {BellyBone::kOrigin, BellyBone::kInsertion};

/// Tries choices over all poses. What was too much for the last one is looked at first.
class Search {
 public:
  Search(const SurfaceSettings& surface, const Motions& motions) : surface_(surface), motions_(motions) {}

  [[nodiscard]] bool isClean(const BellyChoice& choice) {
    const BellyTrial trial(choice, surface_, motions_);
    return trial.canTell() && trial.trouble(kMendedMargin, &first_) <= kMendedMargin;
  }
  /// As it is and led by its bone, as large as it is and larger.
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

/// The nearest to what was drawn first.
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

/// Where the line spans several joints: one of its ends on a bone between, where it is. The skin there goes with that
/// bone, too.
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

/// On the line's own bones and on those that carry the skin over what was drawn, the nearest to that first.
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

}  // namespace sinew
