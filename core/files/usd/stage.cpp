// core/files/usd/stage.cpp: joints and clips, blend shapes, and the prims of both kinds of stage.
#include "core/files/usd/stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <glm/gtc/packing.hpp>
#include <glm/matrix.hpp>

#include "core/files/gltf/animation.h"
#include "core/files/usd/materials.h"
#include "core/files/usd/meshes.h"
#include "core/files/usd/text.h"
#include "core/geometry/at.h"
#include "sinew/character/node_locals.h"

namespace sinew::usd {

// Joints and clips.

namespace {

using exporting::Trs;
using exporting::trsOf;

constexpr double kFramesPerSecond = 30.0;
constexpr double kMostSamples = 4e7;  ///< Joints times frames of all clips.
constexpr double kSameScale = 1e-6;   ///< Relative difference of keys of a constant scale.

bool isEven(const glm::dvec3& scale) {
  const double slack = kSameScale * std::abs(scale.x);
  return std::abs(scale.y - scale.x) <= slack && std::abs(scale.z - scale.x) <= slack;
}

Trs trsOf(const LocalTransform& local) {
  if (!local.matrix) {
    return {glm::dvec3(local.translation), glm::normalize(glm::dquat(local.rotation)), glm::dvec3(local.scale)};
  }
  glm::dmat4 matrix(*local.matrix);
  const bool mirrors = glm::determinant(glm::dmat3(matrix)) < 0.0;
  if (mirrors) matrix[0] = -matrix[0];
  Trs result = trsOf(matrix);
  if (mirrors) result.scale.x = -result.scale.x;
  return result;
}

/// A transform in an evenly scaled space, in the space above it.
Trs fold(const Trs& above, const Trs& below) {
  const double size = above.scale.x;
  return {above.translation + above.rotation * (size * below.translation), above.rotation * below.rotation,
          size * below.scale};
}

class JointMaker {
 public:
  JointMaker(const gltf::BoundSkeleton& bound, std::span<const AnimationClip> clips)
      : skeleton_(bound.skeleton), clips_(clips), jointOfNode_(skeleton_.nodes.size(), -1) {}

  Joints run() && {
    chooseNodes();
    addNodes();
    addBindings();
    checkLength();
    for (const AnimationClip& clip : clips_) sample(clip);
    takeOutScales();
    nameJoints();
    return std::move(result_);
  }

 private:
  void chooseNodes() {
    std::vector<bool> wanted(skeleton_.nodes.size(), false);
    for (std::size_t node = 0; node < wanted.size(); ++node) {
      wanted[node] = !isEven(trsOf(skeleton_.nodes[node].rest).scale);
    }
    for (const AnimationClip& clip : clips_) {
      for (const Channel& channel : clip.channels) {
        if (channel.path != ChannelPath::kScale) continue;
        const auto scales = [](const glm::vec4& value) { return !isEven(glm::dvec3(value)); };
        if (std::ranges::any_of(channel.values, scales)) wanted[toIndex(channel.node)] = true;
      }
    }
    for (const Bone& bone : skeleton_.bones) wanted[toIndex(bone.node)] = true;
    std::vector<bool> below(wanted.size(), false);  // a node above is a joint
    int roots = 0;
    for (std::size_t node = 0; node < wanted.size(); ++node) {
      const int parent = skeleton_.nodes[node].parent;
      below[node] = parent >= 0 && (below[toIndex(parent)] || wanted[toIndex(parent)]);
      roots += wanted[node] && !below[node] ? 1 : 0;
      if (wanted[node]) nodes_.push_back(static_cast<int>(node));
    }
    if (roots != 1) result_.joints.push_back({.name = "root"});  // Readers need one root.
  }

  void addNodes() {
    hasRoot_ = !result_.joints.empty();
    for (const int node : nodes_) {
      at(jointOfNode_, node) = static_cast<int>(result_.joints.size());
      int above = at(skeleton_.nodes, node).parent;
      while (above >= 0 && at(jointOfNode_, above) < 0) above = at(skeleton_.nodes, above).parent;
      const int parent = above >= 0 ? at(jointOfNode_, above) : hasRoot_ ? 0 : -1;
      result_.joints.push_back({.name = at(skeleton_.nodes, node).name, .parent = parent});
    }
    for (const Bone& bone : skeleton_.bones) at(result_.joints, at(jointOfNode_, bone.node)).name = bone.name;
    const std::vector<Trs> rest = localsFrom(restLocals(skeleton_));
    for (std::size_t j = 0; j < result_.joints.size(); ++j) {
      Joint& joint = result_.joints[j];
      joint.rest = rest[j];
      joint.bind = joint.rest.toMatrix();
      if (joint.parent >= 0) joint.bind = at(result_.joints, joint.parent).bind * joint.bind;
    }
  }

  void addBindings() {
    std::vector<bool> isBound(skeleton_.bones.size(), false);
    for (const Binding& binding : skeleton_.bindings) {
      const int joint = at(jointOfNode_, at(skeleton_.bones, binding.bone).node);
      int own = joint;
      if (isBound[toIndex(binding.bone)]) {
        own = static_cast<int>(result_.joints.size());
        result_.joints.push_back({.name = at(result_.joints, joint).name, .parent = joint});
      }
      isBound[toIndex(binding.bone)] = true;
      at(result_.joints, own).bind = glm::inverse(glm::dmat4(binding.inverseBind));
      result_.ofBinding.push_back(own);
    }
  }

  void checkLength() const {
    double samples = 0.0;
    for (const AnimationClip& clip : clips_) {
      samples +=
          static_cast<double>(result_.joints.size()) * (static_cast<double>(clip.duration) * kFramesPerSecond + 2);
    }
    if (samples > kMostSamples) {
      gltf::refuse("animations", "too long for .usda: " + std::to_string(static_cast<long long>(samples)) +
                                     " joints in frames, at most " +
                                     std::to_string(static_cast<long long>(kMostSamples)));
    }
  }

  /// [joints] of [nodes].
  [[nodiscard]] std::vector<Trs> localsFrom(const std::vector<LocalTransform>& nodes) const {
    std::vector<Trs> locals;
    locals.reserve(result_.joints.size());
    if (hasRoot_) locals.emplace_back();
    for (const int node : nodes_) {
      Trs local = trsOf(at(nodes, node));
      int above = at(skeleton_.nodes, node).parent;
      for (; above >= 0 && at(jointOfNode_, above) < 0; above = at(skeleton_.nodes, above).parent) {
        local = fold(trsOf(at(nodes, above)), local);
      }
      locals.push_back(local);
    }
    locals.resize(result_.joints.size());  // additional bindings: identity
    return locals;
  }

  void sample(const AnimationClip& clip) {
    SampledClip& made = result_.clips.emplace_back();
    made.name = clip.name;
    made.frames = framesOf(clip);
    for (const double frame : made.frames) {
      const auto time = std::min(static_cast<float>(frame / kFramesPerSecond), clip.duration);
      made.locals.push_back(localsFrom(sampleLocals(skeleton_, clip, time)));
      turnShortWays(made.locals);
    }
  }

  static void turnShortWays(std::vector<std::vector<Trs>>& frames) {
    if (frames.size() < 2) return;
    const std::vector<Trs>& before = frames[frames.size() - 2];
    for (std::size_t j = 0; j < before.size(); ++j) {
      glm::dquat& now = frames.back()[j].rotation;
      if (glm::dot(before[j].rotation, now) < 0.0) now = -now;
    }
  }

  /// Calls visit(Trs&) for the rest pose and all frames.
  template <class Visit>
  void eachLocal(std::size_t joint, const Visit& visit) {
    visit(result_.joints[joint].rest);
    for (SampledClip& clip : result_.clips) {
      for (std::vector<Trs>& locals : clip.locals) visit(locals[joint]);
    }
  }

  /// Scales the joints' spaces by constant scales, and the transforms of their children accordingly.
  void takeOutScales() {
    std::vector<double> sizes(result_.joints.size(), 1.0);
    for (std::size_t j = 0; j < sizes.size(); ++j) {
      Joint& joint = result_.joints[j];
      const double above = joint.parent < 0 ? 1.0 : at(sizes, joint.parent);
      const double scale = joint.rest.scale.x;
      bool stays = scale > 0.0;
      eachLocal(j, [&](const Trs& local) {
        stays = stays && isEven(local.scale) && std::abs(local.scale.x - scale) <= kSameScale * scale;
      });
      sizes[j] = stays ? above * scale : above;
      eachLocal(j, [&](Trs& local) {
        local.translation *= above;
        if (stays) local.scale = glm::dvec3(1.0);
      });
      for (int axis = 0; axis < 3; ++axis) joint.bind[axis] /= sizes[j];
    }
  }

  void nameJoints() {
    Siblings names;
    std::map<int, Siblings> siblings;  // by parent
    for (Joint& joint : result_.joints) {
      const std::string own = siblings[joint.parent].fresh(identifierOf(joint.name, "joint"));
      joint.path = joint.parent < 0 ? own : at(result_.joints, joint.parent).path + '/' + own;
      joint.name = names.fresh(joint.name.empty() ? "joint" : joint.name, " ");
    }
  }

  const Skeleton& skeleton_;
  std::span<const AnimationClip> clips_;
  std::vector<int> jointOfNode_;
  std::vector<int> nodes_;  // those that are joints
  bool hasRoot_ = false;    // besides them
  Joints result_;
};

}  // namespace

std::vector<double> framesOf(const AnimationClip& clip) {
  constexpr double kSameFrame = 1e-3;
  const double end = static_cast<double>(clip.duration) * kFramesPerSecond;
  std::vector<double> frames;
  for (double frame = 0.0; frame <= end; frame += 1.0) frames.push_back(frame);
  if (frames.empty()) return {0.0};
  if (end - frames.back() > kSameFrame) frames.push_back(end);
  return frames;
}

Joints jointsOf(const gltf::BoundSkeleton& bound, std::span<const AnimationClip> clips) {
  return JointMaker(bound, clips).run();
}

namespace {

// Blend shapes.

/// One value where nothing moves, else one a frame.
void putSamples(const std::string& declaration, std::span<const double> frames, const std::vector<std::string>& values,
                Text& text) {
  if (std::ranges::all_of(values, [&](const std::string& value) { return value == values.front(); })) {
    text.attribute(declaration, values.front());
    return;
  }
  text.openSamples(declaration);
  for (std::size_t f = 0; f < values.size(); ++f) text.line(numberText(frames[f]) + ": " + values[f] + ',');
  text.close();
}

/// USD animates blend shapes by name, glTF by node, so each target of a node has its own name. At rest weights are 0.
class BlendShapes {
 public:
  BlendShapes(const gltf::File& file, const gltf::NodeTree& tree, std::span<const Mesh> meshes) {
    ofNodes_.resize(tree.nodes.size());
    Siblings siblings;
    for (const Mesh& mesh : meshes) {
      gltf::NodeTargets& of = at(ofNodes_, mesh.node);
      if (of.count == 0) of.first = static_cast<int>(tokens_.size());
      const int number = tree[mesh.node].mesh;
      const std::vector<std::string>& named = file.targetNames(number);
      const std::vector<double>& own = at(file.model().nodes, mesh.node).weights;
      const std::vector<double>& weights = own.empty() ? at(file.model().meshes, number).weights : own;
      for (auto k = toIndex(of.count); k < mesh.shapes.size(); ++k) {
        names_.push_back(k < named.size() ? named[k] : std::string());
        tokens_.push_back(siblings.fresh(identifierOf(names_.back(), "Shape")));
        rest_.push_back(k < weights.size() ? static_cast<float>(weights[k]) : 0.0f);
        ++of.count;
      }
    }
  }

  /// Targets of nodes, as clips number them.
  [[nodiscard]] const std::vector<gltf::NodeTargets>& ofNodes() const { return ofNodes_; }

  /// Whether all weights are 0 without a clip.
  [[nodiscard]] bool restsAtZero() const {
    return std::ranges::all_of(rest_, [](float weight) { return weight == 0.0f; });
  }

  /// The list of an open mesh prim, and a prim for each shape. @param path  of the mesh
  void writeMesh(const Mesh& mesh, const std::string& path, Text& text) const {
    if (mesh.shapes.empty()) return;
    const auto first = toIndex(at(ofNodes_, mesh.node).first);
    const std::span<const std::string> tokens = std::span(tokens_).subspan(first, mesh.shapes.size());
    std::string targets;
    for (const std::string& token : tokens) targets += (targets.empty() ? "[<" : ", <") + path + '/' + token + '>';
    text.attribute("uniform token[] skel:blendShapes", quotedList(tokens));
    text.attribute("rel skel:blendShapeTargets", targets + ']');
    for (std::size_t k = 0; k < mesh.shapes.size(); ++k) {
      const BlendShape& shape = mesh.shapes[k];
      text.open("def BlendShape \"" + tokens[k] + '"', displayName(names_[first + k], tokens[k]));
      if (!shape.normalOffsets.empty())
        text.attribute("uniform vector3f[] normalOffsets", arrayText(shape.normalOffsets));
      text.attribute("uniform vector3f[] offsets", arrayText(shape.offsets));
      text.attribute("uniform int[] pointIndices", arrayText(shape.points));
      text.close();
    }
  }

  /// For an open SkelAnimation. @param frames  of kFramesPerSecond
  void writeClip(const AnimationClip& clip, std::span<const double> frames, Text& text) const {
    if (tokens_.empty()) return;
    text.attribute("uniform token[] blendShapes", quotedList(tokens_));
    std::vector<std::string> values;
    std::vector<float> weights = rest_;
    for (const double frame : frames) {
      const float time = std::min(static_cast<float>(frame / kFramesPerSecond), clip.duration);
      for (const MorphChannel& channel : clip.morphChannels) {
        sampleMorphs(channel, time, std::span(weights).subspan(toIndex(channel.firstTarget), toIndex(channel.targets)));
      }
      values.push_back(arrayText(weights));
    }
    putSamples("float[] blendShapeWeights", frames, values, text);
  }

 private:
  std::vector<gltf::NodeTargets> ofNodes_;
  std::vector<std::string> tokens_;  ///< [targets of all nodes]
  std::vector<std::string> names_;   ///< As in the file.
  std::vector<float> rest_;          ///< Weights without a clip.
};

constexpr std::size_t kSampleIndent = 12;
constexpr double kLargestHalf = 65504.0;

/// Rounds to 16 bits, as USD stores scales.
float asHalf(double value) {
  const auto number = static_cast<float>(std::clamp(value, -kLargestHalf, kLargestHalf));
  return glm::unpackHalf1x16(glm::packHalf1x16(number));
}

glm::vec3 translationOf(const Trs& local) { return glm::vec3(local.translation); }
glm::quat rotationOf(const Trs& local) { return glm::quat(local.rotation); }
glm::vec3 scaleOf(const Trs& local) { return {asHalf(local.scale.x), asHalf(local.scale.y), asHalf(local.scale.z)}; }

template <class Read>
std::string samplesText(const std::vector<Trs>& locals, const Read& read) {
  std::vector<decltype(read(locals.front()))> values;
  values.reserve(locals.size());
  for (const Trs& local : locals) values.push_back(read(local));
  return arrayText(values);
}

class StageMaker {
 public:
  StageMaker(gltf::File& file, const Json& root, const std::string& stem)
      : file_(file),
        stem_(stem),
        name_(identifierOf(stem, "Character")),
        accessors_(file),
        tree_(gltf::readNodes(file, notes_)),
        bound_(gltf::bindSkeleton(file, tree_, accessors_, notes_)),
        meshes_(meshesOf(file, root, tree_, bound_, accessors_, stage_.left)),
        shapes_(file, tree_, meshes_),
        materials_(file, root, meshes_, stem, stage_.left) {
    for (const char* taken : {"Skeleton", "Materials", "Animations"}) names_.fresh(taken);
    if (!root.at("cameras").items().empty()) stage_.left.insert("cameras: .usda holds the character alone");
    if (file.lights() > 0) stage_.left.insert("lights: .usda holds the character alone");
  }

  Stage skinned() && {
    const auto clips =
        gltf::readClips(file_, {bound_.skeleton, bound_.skeletonNode, shapes_.ofNodes()}, accessors_, notes_);
    if (!shapes_.restsAtZero()) stage_.left.insert("weights of morph targets where no clip plays: USD knows none");
    joints_ = jointsOf(bound_, clips);
    double end = 0.0;
    for (const SampledClip& clip : joints_.clips) end = std::max(end, clip.frames.back());
    open("SkelRoot", 0.0, end, kFramesPerSecond, {"prepend apiSchemas = [\"SkelBindingAPI\"]"});
    std::vector<std::string> animations;
    Siblings siblings;
    for (const SampledClip& clip : joints_.clips) {
      animations.push_back(siblings.fresh(identifierOf(clip.name, "Clip")));
    }
    writeSkeleton(animations.empty() ? std::string() : animations.front());
    for (std::size_t m = 0; m < meshes_.size(); ++m) writeSkinned(meshes_[m]);
    materials_.write(path(), text_);
    if (!animations.empty()) text_.open("def Scope \"Animations\"");
    for (std::size_t c = 0; c < animations.size(); ++c) writeClip(joints_.clips[c], clips[c], animations[c]);
    if (!animations.empty()) text_.close();
    return finishStage();
  }

  Stage points(const PointMoments& moments) && {
    struct Samples {
      std::string points;
      std::string normals;
      std::string extents;
    };
    std::vector<Samples> samples(meshes_.size());
    std::vector<MeshPoints> now;
    for (std::size_t moment = 0; moment < moments.frames.size(); ++moment) {
      moments.at(moment, now);
      checkMoment(now);
      const std::string time = std::string(kSampleIndent, ' ') + numberText(moments.frames[moment]) + ": ";
      for (std::size_t m = 0; m < meshes_.size(); ++m) {
        samples[m].points += time + arrayText(now[m].points) + ",\n";
        samples[m].extents += time + extentText(now[m].points) + ",\n";
        if (!now[m].normals.empty()) samples[m].normals += time + arrayText(now[m].normals) + ",\n";
      }
    }
    open("Xform", moments.frames.front(), moments.frames.back(), moments.framesPerSecond, {});
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      openMesh(meshes_[m], {});
      const auto sampled = [&](const char* declaration, std::string& values, const std::vector<std::string>& metadata) {
        if (values.empty()) return;
        if (!metadata.empty()) text_.declare(declaration, metadata);
        text_.openSamples(declaration);
        text_.append(values);
        text_.close();
        values = {};
      };
      sampled("float3[] extent", samples[m].extents, {});
      sampled("normal3f[] normals", samples[m].normals, perVertex());
      sampled("point3f[] points", samples[m].points, {});
      text_.close();
    }
    materials_.write(path(), text_);
    return finishStage();
  }

 private:
  [[nodiscard]] std::string path() const { return '/' + name_; }

  void open(const std::string& type, double start, double end, double framesPerSecond,
            const std::vector<std::string>& metadata) {
    text_.line("#usda 1.0");
    text_.line("(");
    for (const std::string& line :
         {"defaultPrim = \"" + name_ + '"', std::string("doc = \"Made by Sinew\""), "endTimeCode = " + numberText(end),
          "framesPerSecond = " + numberText(framesPerSecond), std::string("metersPerUnit = 1"),
          "startTimeCode = " + numberText(start), "timeCodesPerSecond = " + numberText(framesPerSecond),
          std::string("upAxis = \"Y\"")}) {
      text_.line("    " + line);
    }
    text_.line(")");
    text_.line("");
    std::vector<std::string> all = metadata;
    for (const std::string& line : displayName(stem_, name_)) all.push_back(line);
    text_.open("def " + type + " \"" + name_ + '"', all);
  }

  Stage finishStage() {
    text_.close();
    stage_.text = std::move(text_).take();
    stage_.textures = std::move(materials_).takeTextures();
    return std::move(stage_);
  }

  void writeSkeleton(const std::string& animation) {
    text_.open("def Skeleton \"Skeleton\"", {"prepend apiSchemas = [\"SkelBindingAPI\"]"});
    std::vector<glm::dmat4> bind;
    std::vector<glm::dmat4> rest;
    std::vector<std::string> names;
    for (const Joint& joint : joints_.joints) {
      paths_.push_back(joint.path);
      names.push_back(joint.name);
      bind.push_back(joint.bind);
      rest.push_back(joint.rest.toMatrix());
    }
    text_.attribute("uniform matrix4d[] bindTransforms", arrayText(bind));
    text_.attribute("uniform token[] jointNames", quotedList(names));
    text_.attribute("uniform token[] joints", quotedList(paths_));
    text_.attribute("uniform matrix4d[] restTransforms", arrayText(rest));
    if (!animation.empty()) {
      text_.attribute("rel skel:animationSource", '<' + path() + "/Animations/" + animation + '>');
    }
    text_.close();
  }

  /// Returns its path.
  std::string openMesh(const Mesh& mesh, std::vector<std::string> schemas) {
    const std::string own = names_.fresh(identifierOf(mesh.name, "Mesh"));
    if (mesh.material >= 0) schemas.emplace_back("MaterialBindingAPI");
    std::vector<std::string> metadata;
    if (!schemas.empty()) metadata.push_back("prepend apiSchemas = " + quotedList(schemas));
    for (const std::string& line : displayName(mesh.name, own)) metadata.push_back(line);
    text_.open("def Mesh \"" + own + '"', metadata);
    writeTopology(mesh, materials_.factorOf(mesh), materials_.isDoubleSided(mesh), text_);
    materials_.bind(mesh, path(), text_);
    return path() + '/' + own;
  }

  void writeSkinned(const Mesh& mesh) {
    const std::string own = openMesh(mesh, {"SkelBindingAPI"});
    text_.attribute("float3[] extent", extentText(mesh.points));
    if (!mesh.normals.empty()) text_.attribute("normal3f[] normals", arrayText(mesh.normals), perVertex());
    text_.attribute("point3f[] points", arrayText(mesh.points));
    std::vector<int> joints;
    joints.reserve(mesh.bindings.size());
    for (const int binding : mesh.bindings) joints.push_back(sinew::at(joints_.ofBinding, binding));
    std::vector<std::string> metadata = perVertex();
    metadata.insert(metadata.begin(), "elementSize = " + std::to_string(mesh.influences));
    text_.attribute("matrix4d primvars:skel:geomBindTransform", tupleText(mesh.meshToBind));
    text_.attribute("int[] primvars:skel:jointIndices", arrayText(joints), metadata);
    text_.attribute("float[] primvars:skel:jointWeights", arrayText(mesh.weights), metadata);
    text_.attribute("rel skel:skeleton", '<' + path() + "/Skeleton>");
    shapes_.writeMesh(mesh, own, text_);
    text_.close();
  }

  void writeClip(const SampledClip& clip, const AnimationClip& from, const std::string& own) {
    text_.open("def SkelAnimation \"" + own + '"', displayName(clip.name, own));
    shapes_.writeClip(from, clip.frames, text_);
    text_.attribute("uniform token[] joints", quotedList(paths_));
    writeSamples("quatf[] rotations", clip, rotationOf);
    writeSamples("half3[] scales", clip, scaleOf);
    writeSamples("float3[] translations", clip, translationOf);
    text_.close();
  }

  template <class Read>
  void writeSamples(const std::string& declaration, const SampledClip& clip, const Read& read) {
    std::vector<std::string> values;
    for (const std::vector<Trs>& locals : clip.locals) values.push_back(samplesText(locals, read));
    putSamples(declaration, clip.frames, values, text_);
  }

  void checkMoment(const std::vector<MeshPoints>& now) const {
    bool fits = now.size() == meshes_.size();
    for (std::size_t m = 0; fits && m < now.size(); ++m) {
      const std::size_t count = meshes_[m].points.size();
      fits = now[m].points.size() == count && (now[m].normals.empty() || now[m].normals.size() == count);
    }
    if (!fits) gltf::refuse("meshes", "a frame has other points than the file");
  }

  gltf::File& file_;
  std::string stem_;
  std::string name_;
  Stage stage_;
  gltf::Notes notes_;  // reported by the import
  gltf::Accessors accessors_;
  gltf::NodeTree tree_;
  gltf::BoundSkeleton bound_;
  std::vector<Mesh> meshes_;
  BlendShapes shapes_;
  Materials materials_;
  Siblings names_;  // below the root prim
  std::vector<std::string> paths_;
  Joints joints_;
  Text text_;
};

}  // namespace

Stage skinnedStage(gltf::File& file, const Json& root, const std::string& stem) {
  return StageMaker(file, root, stem).skinned();
}

Stage pointStage(gltf::File& file, const Json& root, const std::string& stem, const PointMoments& moments) {
  return StageMaker(file, root, stem).points(moments);
}

}  // namespace sinew::usd
