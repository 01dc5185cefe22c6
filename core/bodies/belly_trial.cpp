// core/bodies/belly_trial.cpp: the worst of all poses.
#include "core/bodies/belly_trial.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "core/bodies/check.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

Rig rigOf(const BellyChoice& choice, const SurfaceSettings& surface) {
  Rig alone;
  alone.surface = surface;
  alone.primitives = {choice.primitive};
  alone.primitives[0].animated.clear();
  if (choice.line) alone.lines = {*choice.line};
  for (MuscleLine& line : alone.lines) line.animated.clear();
  return alone;
}

}  // namespace

Trouble troubleOf(const FollowedBelly& belly, const BellyMotion& motion, const PosedLine& line, float share) {
  const float stretch = std::max(line.stretch / kMostStretch, kLeastStretch / std::max(line.stretch, 1e-6f));
  return {std::max({share * motion.out / kMostOut, share * motion.beside / kMostBeside, stretch}),
          share * motion.ball / belly.mostBall()};
}

BellyTrial::BellyTrial(const BellyChoice& choice, const SurfaceSettings& surface, const Motions& motions)
    : motions_(motions), poser_(rigOf(choice, surface), motions.character()) {
  const Character& character = motions.character();
  const auto bone = character.skeleton.findBone(choice.primitive.bone);
  if (!bone) return;
  const PosedRig bind = poser_.pose(bindPose(character.skeleton));
  belly_ = FollowedBelly::create(character, motions.skin(), bind.muscles[0], *bone);
  body_ = bellyBody(bind.muscles[0]);
}

glm::vec3 BellyTrial::outwards() const {
  const Character& character = motions_.character();
  const auto frame = frameAt(character, spot(), bindPose(character.skeleton));
  return frame ? frame->normal() : glm::vec3(0.0f);
}

float BellyTrial::trouble(float enough, std::size_t* first) const {
  constexpr std::size_t kPoints = FollowedBelly::kPoints;
  const Character& character = motions_.character();
  std::array<std::optional<SkinFrame>, kPoints> frames;
  PosedRig posed;
  float worst = 0.0f;
  const std::size_t count = motions_.poses().size();
  const std::size_t begin = first != nullptr ? *first : 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (begin + k) % count;
    if (worst > enough) break;
    if (first != nullptr) *first = i;
    const Pose& pose = motions_.poses()[i];
    poser_.pose(pose, posed);
    for (std::size_t s = 0; s < kPoints; ++s) frames[s] = frameAt(character, belly_->spots()[s], pose);
    const BellyMotion motion = belly_->motion(posed.muscles[0], frames);
    const float share = motions_.shareOf(i);
    worst = std::max(worst, share * motion.out / kMostOut);
    if (posed.lines.empty() || !posed.lines[0].usable) continue;
    worst = std::max(worst, troubleOf(*belly_, motion, posed.lines[0], share).worst());
  }
  return worst;
}

}  // namespace sinew
