// examples/cpp/driven_muscle.cpp: a muscle whose girth follows the bend of an elbow, in poses that the game makes.
// driven_muscle FILE.sinew
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "sinew/runtime/runtime.h"

namespace {

int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

/// A muscle in the upper arm; where the forearm is bent by 100 degrees it is half as thick again.
sinew::Primitive biceps(const sinew::Bone& arm, const std::string& forearm) {
  sinew::Primitive muscle;
  muscle.name = "biceps L";
  muscle.bone = arm.name;
  muscle.placement.center = 0.5f * arm.tip;
  muscle.placement.radii = glm::vec3(0.3f * glm::length(arm.tip));
  sinew::Driver driver;
  driver.input.kind = sinew::DriverInputKind::kBend;
  driver.input.bone = forearm;
  driver.curve.points = {{0.0f, 1.0f}, {100.0f, 1.5f}};  // Degrees, factor.
  driver.mode = sinew::DriverMode::kMultiply;
  for (const sinew::Parameter radius : {sinew::Parameter::kRadiusX, sinew::Parameter::kRadiusZ}) {
    muscle.animated.push_back({radius, {}, {driver}, {}});
  }
  return muscle;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: driven_muscle FILE.sinew\n");
    return 2;
  }
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> file{std::istreambuf_iterator<char>(in), {}};
  const auto game = sinew::readGameFile(std::as_bytes(std::span(file)));
  if (!game) return fail(game.error());
  const sinew::Character& character = *game->character;
  const sinew::Skeleton& skeleton = character.skeleton;
  const auto arm = skeleton.findBone("upper_arm.L"), forearm = skeleton.findBone("forearm.L");
  if (!arm || !forearm) return fail({argv[1], "upper_arm.L, forearm.L", "no such bones"});

  // On both sides: edits are functions from one rig to the next.
  const sinew::MirrorEdits mirror(character);
  const auto rig = mirror.addPair(sinew::Rig(), biceps(skeleton.bones[static_cast<std::size_t>(*arm)], "forearm.L"));
  if (!rig) return fail(rig.error());
  sinew::Smoother smoother(game->character);
  if (const auto prepared = smoother.prepare(rig.value()); !prepared) return fail(prepared.error());

  // The game's own pose: each bone against its parent, as its animation system has them.
  std::vector<glm::quat> turns;
  for (const sinew::Bone& bone : skeleton.bones) {
    turns.push_back(skeleton.nodes[static_cast<std::size_t>(bone.node)].rest.rotation);
  }
  const glm::quat straight = turns[static_cast<std::size_t>(*forearm)];
  std::vector<glm::dmat4> scratch;
  sinew::Pose pose;
  sinew::Surface surface;
  for (const float degrees : {0.0f, 50.0f, 100.0f}) {
    turns[static_cast<std::size_t>(*forearm)] =
        straight * glm::angleAxis(glm::radians(degrees), glm::vec3(0.0f, 0.0f, 1.0f));
    if (const auto posed = poseFromLocals(skeleton, {.rotations = turns}, scratch, pose); !posed) {
      return fail(posed.error());
    }
    if (!smoother.smooth(pose, surface)) return fail(checkPose(character, pose).error());
    const double raised = *std::ranges::max_element(surface.displacement);
    std::printf("bent by %3.0f degrees: skin raised by %.4f\n", static_cast<double>(degrees), raised);
  }
  return 0;
}
