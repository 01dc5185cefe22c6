// tests/export/line_oracle.cpp: where the core puts muscle lines' joints in poses, for runtimes to be held against.
//
// line_oracle post FILE.glb            writes a small skeleton
// line_oracle lines CHARACTER RIG      writes a rig of random lines, half of them with via points
// line_oracle poses RIG SCALE COUNT    prints poses: the bind pose, then random ones; SCALE as --joint-scale has it
#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "core/files/export/source.h"
#include "core/files/fit/helper_motion.h"
#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

template <class Vector>
ordered_json numbersOf(const Vector& vector, int count) {
  ordered_json list;
  for (int i = 0; i < count; ++i) list.push_back(vector[i]);
  return list;
}

ordered_json matrixOf(const glm::dmat4& matrix) { return numbersOf(glm::value_ptr(matrix), 16); }

glm::vec3 randomIn(Random& random, const glm::vec3& low, const glm::vec3& high) {
  return {random.uniform(low.x, high.x), random.uniform(low.y, high.y), random.uniform(low.z, high.z)};
}

/// Between a bone and the one above it, both ends beside the bones' origins.
MuscleLine randomLine(int number, const Character& character, Random& random) {
  const Skeleton& skeleton = character.skeleton;
  const float reach = 0.1f * character.height;
  int bone = 0;
  while (at(skeleton.bones, bone).parent < 0) bone = random.below(static_cast<int>(skeleton.bones.size()));
  const int above = at(skeleton.bones, bone).parent;
  const auto place = [&](int of) { return glm::vec3(at(skeleton.bones, of).bindInWorld[3]); };
  const auto anchor = [&](int of, const glm::vec3& near) {
    const glm::vec3 there = near + randomIn(random, glm::vec3(-reach), glm::vec3(reach));
    return LineAnchor{
        skeleton.fileName(of), glm::vec3(at(skeleton.bones, of).inverseBindInWorld * glm::vec4(there, 1.0f)), {}};
  };
  MuscleLine line;
  line.name = "line " + std::to_string(number);
  line.origin = anchor(above, place(above));
  line.insertion = anchor(bone, place(bone) + (place(bone) - place(above)));
  if (number % 2 == 1) line.via = anchor(number % 4 == 1 ? above : bone, place(bone));
  LineSettings& settings = line.settings;
  settings.rest = random.uniform(0.8f, 1.25f);
  settings.tendons = {random.uniform(0.0f, 0.4f), random.uniform(0.0f, 0.4f)};
  settings.volume = random.uniform(0.0f, 2.0f);
  settings.limits = {random.uniform(0.3f, 0.8f), random.uniform(1.2f, 2.5f)};
  settings.pivot = random.uniform(0.0f, 1.0f);
  settings.twist = random.uniform(0.0f, 1.0f);
  settings.flex = {random.uniform(-0.3f, 0.6f), random.uniform(-0.3f, 0.6f)};
  settings.base = random.chance(0.5f) ? random.uniform(0.0f, 0.6f) : 0.0f;
  settings.gain = random.uniform(0.0f, 1.5f);
  settings.full = random.uniform(0.5f, 0.95f);
  return line;
}

int failed(const Error& error) {
  std::cerr << error.text() << '\n';
  return 1;
}

int writeLines(const std::filesystem::path& characterFile, const std::filesystem::path& file) {
  const auto imported = importGltf(characterFile);
  if (!imported) return failed(imported.error());
  const Character& character = *imported.value();
  constexpr int kLines = 12;
  RigRecipe recipe;
  recipe.primitives = kLines;
  recipe.carveChance = 0.0f;
  Rig rig = randomRig(character, recipe, 7);
  rig.character = std::filesystem::relative(characterFile, file.parent_path()).string();
  Random random(11);
  for (int i = 0; i < kLines; ++i) {
    rig.lines.push_back(randomLine(i, character, random));
    rig.primitives[toIndex(i)].line = rig.lines.back().name;
  }
  const auto saved = saveRig(rig, file);
  return saved ? 0 : failed(saved.error());
}

/// The post under a node that turns and scales.
int writePost(const std::filesystem::path& file) {
  Post post = makePost();
  ordered_json& nodes = post.file.json["nodes"];
  const auto armature = static_cast<int>(nodes.size());
  nodes.push_back(
      {{"name", "armature"}, {"rotation", {0.5, 0.5, 0.5, 0.5}}, {"scale", {0.5, 0.5, 0.5}}, {"children", {1}}});
  post.file.json["scenes"][0]["nodes"] = {0, armature};
  return (std::ofstream(file, std::ios::binary) << post.file.glb()).good() ? 0 : 1;
}

Channel still(int node, ChannelPath path, const glm::vec4& value) {
  return {node, path, Interpolation::kLinear, {0.0f}, {value}};
}

/// Joints turned by up to 110 degrees and moved a little; in some poses grown alike, in some unevenly; the roots
/// anywhere.
AnimationClip randomClip(const Skeleton& skeleton, float height, Random& random) {
  AnimationClip clip;
  const int growing = random.below(3);
  for (const Bone& bone : skeleton.bones) {
    const LocalTransform& rest = at(skeleton.nodes, bone.node).rest;
    if (rest.matrix) continue;
    const bool isRoot = bone.parent < 0;
    const glm::quat any = random.rotation();
    const float angle = random.uniform(-1.9f, 1.9f);
    const glm::quat turn = isRoot ? any : glm::angleAxis(angle, glm::normalize(glm::vec3(any.x, any.y, any.z)));
    const glm::quat q = rest.rotation * turn;
    clip.channels.push_back(still(bone.node, ChannelPath::kRotation, {q.x, q.y, q.z, q.w}));
    const float reach = (isRoot ? 2.0f : 0.01f) * height;
    const glm::vec3 t = rest.translation + randomIn(random, glm::vec3(-reach), glm::vec3(reach));
    clip.channels.push_back(still(bone.node, ChannelPath::kTranslation, {t, 0.0f}));
    if (growing == 0) continue;
    const float even = random.uniform(0.7f, 1.4f);
    const glm::vec3 uneven = randomIn(random, glm::vec3(0.8f), glm::vec3(1.25f));
    clip.channels.push_back(
        still(bone.node, ChannelPath::kScale, {rest.scale * (growing == 1 ? glm::vec3(even) : uneven), 0.0f}));
  }
  return clip;
}

ordered_json nodesOf(const AnimationClip& clip, std::span<const int> fileNodes) {
  constexpr std::array kNames{"translation", "rotation", "scale"};
  ordered_json nodes = ordered_json::object();
  for (const Channel& channel : clip.channels) {
    const int count = channel.path == ChannelPath::kRotation ? 4 : 3;
    nodes[std::to_string(fileNodes[toIndex(channel.node)])][kNames[static_cast<std::size_t>(channel.path)]] =
        numbersOf(channel.values.front(), count);
  }
  return nodes;
}

int printPoses(const std::filesystem::path& file, const std::string& scale, int count) {
  const auto rig = loadRig(file);
  if (!rig) return failed(rig.error());
  const auto characterFile = characterPath(rig.value(), file);
  const auto character = importGltf(characterFile).value();
  const Skeleton& skeleton = character->skeleton;
  const exporting::Source source(characterFile);
  const JointScale kind = scale == "none"      ? JointScale::kNone
                          : scale == "uniform" ? JointScale::kUniform
                                               : JointScale::kFull;
  const Pose bind = bindPose(skeleton);
  const exporting::LineJoints lines(rig.value(), *character, kind, {&bind, 1});
  Random random(5);
  ordered_json all{{"height", character->height}, {"poses", ordered_json::array()}};
  for (int i = 0; i < count; ++i) {
    const AnimationClip clip = i == 0 ? AnimationClip{} : randomClip(skeleton, character->height, random);
    Pose pose = i == 0 ? bind : samplePose(skeleton, clip, 0.0f);
    pose.flex = i % 2 == 0 ? 0.0f : random.uniform(0.0f, 1.0f);
    ordered_json bones = ordered_json::object();
    for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
      bones[std::to_string(source.nodeOfBone(static_cast<int>(b)))] = matrixOf(glm::dmat4(pose.boneInWorld[b]));
    }
    std::vector<exporting::Trs> locals;
    lines.pose(pose, locals);
    ordered_json joints = ordered_json::object();
    for (std::size_t j = 0; j < locals.size(); ++j) {
      const exporting::HelperJoint& joint = lines.joints()[j];
      joints[joint.name] = matrixOf(glm::dmat4(at(pose.boneInWorld, joint.bone)) * locals[j].toMatrix());
    }
    all["poses"].push_back({{"flex", pose.flex},
                            {"nodes", nodesOf(clip, source.fileNode)},
                            {"bones", std::move(bones)},
                            {"joints", std::move(joints)}});
  }
  std::cout << all.dump() << '\n';
  return 0;
}

}  // namespace
}  // namespace sinew::test

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 2 && words[0] == "post") return sinew::test::writePost(words[1]);
  if (words.size() == 3 && words[0] == "lines") return sinew::test::writeLines(words[1], words[2]);
  if (words.size() == 4 && words[0] == "poses") {
    return sinew::test::printPoses(words[1], words[2], std::atoi(words[3].c_str()));
  }
  return 2;
}
