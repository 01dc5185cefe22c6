// core/files/gltf/gltf_import.cpp: the import, stage by stage.

#include "sinew/files/gltf_import.h"

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/character/body_slots.h"
#include "core/files/gltf/animation.h"
#include "core/files/gltf/file.h"
#include "core/files/gltf/glb.h"
#include "core/files/gltf/mesh.h"
#include "core/files/gltf/node_tree.h"
#include "core/files/gltf/skin.h"
#include "core/files/json/json.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "sinew/character/body_part.h"

namespace sinew::gltf {
namespace {

// Bones and expressions of a .vrm file on the imported character.

constexpr std::size_t kMaxBinds = 65536;  ///< Of all expressions.

/// "leftUpperArm" -> "upperArm.L"
std::string slotName(const std::string& bone) {
  for (const auto& [side, ending] : {std::pair{"left", ".L"}, std::pair{"right", ".R"}}) {
    if (!bone.starts_with(side) || bone.size() == std::string(side).size()) continue;
    std::string name = bone.substr(std::string(side).size());
    name[0] = toLower(name[0]);
    return name + ending;
  }
  return bone;
}

int boneOfNode(const BoundSkeleton& bound, int node) {
  if (node < 0 || toIndex(node) >= bound.skeletonNode.size()) return -1;
  const int own = at(bound.skeletonNode, node);
  const auto bone = std::ranges::find(bound.skeleton.bones, own, &Bone::node);
  if (own < 0 || bone == bound.skeleton.bones.end()) return -1;
  return static_cast<int>(bone - bound.skeleton.bones.begin());
}

std::vector<BodyPart> bodyPartsOf(const Vrm& vrm, const BoundSkeleton& bound, Notes& notes) {
  std::vector<BodyPart> parts;
  std::set<std::string> known;
  for (const Vrm::HumanBone& bone : vrm.bones) {
    const std::string slot = slotName(bone.name);
    if (!bodySlotNamed(slot)) continue;
    const int found = boneOfNode(bound, bone.node);
    if (found < 0) notes.add("parts of the body that the file gives to nodes without skin are ignored");
    else if (known.insert(slot).second) parts.push_back({slot, found});
  }
  return parts;
}

std::vector<MorphSet> morphSetsOf(const Vrm& vrm, const NodeTree& tree, std::span<const MorphTarget> targets) {
  std::set<std::string> taken;
  for (const MorphTarget& target : targets) taken.insert(target.name);
  const std::vector<NodeTargets> ofNodes = targetsOfNodes(tree.nodes.size(), targets);
  std::vector<MorphSet> sets;
  std::size_t shares = 0;
  for (const Vrm::Expression& expression : vrm.expressions) {
    MorphSet set;
    set.name = taken.contains(expression.name) ? expression.name + " (expression)" : expression.name;
    for (const Vrm::Bind& bind : expression.binds) {
      for (std::size_t node = 0; node < ofNodes.size() && bind.target >= 0; ++node) {
        const bool meant = bind.mesh >= 0 ? tree.nodes[node].mesh == bind.mesh : static_cast<int>(node) == bind.node;
        if (!meant || bind.target >= ofNodes[node].count || bind.weight == 0.0f) continue;
        if (++shares <= kMaxBinds) set.shares.push_back({ofNodes[node].first + bind.target, bind.weight});
      }
    }
    const bool usable = !set.shares.empty() && !set.name.empty() && sets.size() < kMaxMorphTargets;
    if (usable && taken.insert(set.name).second) sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace
}  // namespace sinew::gltf

namespace sinew {
namespace {

using namespace gltf;

/// Used, or with a fallback.
constexpr std::array<std::string_view, 10> kUnderstood{"KHR_texture_transform",
                                                       "KHR_mesh_quantization",
                                                       kMeshopt,
                                                       kDraco,
                                                       "EXT_texture_webp",
                                                       "KHR_materials_unlit",
                                                       "KHR_materials_emissive_strength",
                                                       "KHR_materials_pbrSpecularGlossiness",
                                                       "VRMC_vrm",
                                                       "VRM"};

bool understood(std::string_view extension) { return std::ranges::find(kUnderstood, extension) != kUnderstood.end(); }

void checkExtensions(const tinygltf::Model& model, Notes& notes) {
  for (std::size_t i = 0; i < model.extensionsRequired.size(); ++i) {
    const std::string& name = model.extensionsRequired[i];
    if (!understood(name)) {
      refuse(placeOf("extensionsRequired", i),
             "the file needs the extension " + shortened(name) + ", which Sinew cannot read", "cannot be opened");
    }
  }
  for (const std::string& name : model.extensionsUsed) {
    if (!understood(name)) notes.add("extension " + shortened(name) + " is ignored: what it adds is not shown");
  }
}

void noteUnused(const File& file, Notes& notes) {
  if (file.cameras() > 0)
    notes.add("cameras (" + std::to_string(file.cameras()) + ") are ignored: the view is your own");
  if (file.lights() > 0)
    notes.add("lights (" + std::to_string(file.lights()) + ") are ignored: the editor lights the character");
}

constexpr float kGltfImportLeastHeight = 1e-9f;  ///< Limit of sums of squares in floats.

enum class ReadFor { kCharacter, kClips };

/// Returns [V] a soup vertex of each welded one.
std::vector<int> weldMesh(const TriangleSoup& soup, Character& character, ReadFor use) {
  if (use == ReadFor::kClips && soup.triangles.empty()) return {};
  if (soup.triangles.empty()) refuse("meshes", "the scene has no triangles to show", "cannot be opened");
  std::vector<int> standsFor;
  character.mesh = weld(soup, weldTolerance(soup), &standsFor);
  if (character.mesh.triangles.empty())
    refuse("meshes", "all triangles have collapsed to lines or points", "cannot be opened");
  character.height = heightOf(character.mesh.positions);
  // Vertices in one place stay apart if they follow different bones.
  if (!(character.height > kGltfImportLeastHeight))
    refuse("meshes", "all vertices are in one place: the mesh has no extent", "cannot be opened");
  return standsFor;
}

std::shared_ptr<const Character> readCharacter(const std::filesystem::path& path, ReadFor use) {
  File file(path);
  Notes notes;
  checkExtensions(file.model(), notes);
  if (use == ReadFor::kClips && file.model().animations.empty())
    refuse("animations", "the file has no clips", "cannot be added");
  noteUnused(file, notes);
  Accessors accessors(file);
  auto character = std::make_shared<Character>();
  const NodeTree tree = readNodes(file, notes);
  BoundSkeleton bound =
      bindSkeleton(file, tree, accessors, notes, use == ReadFor::kClips ? BonesFrom::kNodes : BonesFrom::kMeshes);
  Materials materials = readMaterials(file, notes, use == ReadFor::kClips ? Images::kLeftOut : Images::kRead);
  SoupOrigin origin;
  std::vector<MeshMaterial> parts;
  const std::vector<int> standsFor =
      weldMesh(readTriangles(file, tree, bound, materials, accessors, notes, &origin, &parts), *character, use);
  keepUsedParts(character->mesh, parts);
  character->parts = partsOf(file, parts, materials.materials);
  character->morphTargets = readMorphs(file, tree, bound, origin, standsFor, accessors, notes);
  character->morphSets = morphSetsOf(file.vrm(), tree, character->morphTargets);
  character->bodyParts = bodyPartsOf(file.vrm(), bound, notes);
  const std::vector<NodeTargets> morphsOf = targetsOfNodes(tree.nodes.size(), character->morphTargets);
  character->clips = readClips(file, {bound.skeleton, bound.skeletonNode, morphsOf}, accessors, notes);
  character->name = path.stem().string();
  character->skeleton = std::move(bound.skeleton);
  character->materials = std::move(materials.materials);
  character->textures = std::move(materials.textures);
  if (use == ReadFor::kCharacter) showHiddenCharacter(*character, notes);
  if (use == ReadFor::kClips && character->clips.empty())
    refuse("animations", "no clip of the file moves a bone", "cannot be added");
  character->ignored = notes.lines();
  return character;
}

Result<std::shared_ptr<const Character>> read(const std::filesystem::path& file, ReadFor use) {
  const auto failed = [&](std::string place, std::string reason) {
    return Error{.file = file.string(), .place = std::move(place), .reason = std::move(reason)};
  };
  try {
    return readCharacter(file, use);
  } catch (Refusal& refusal) {
    Error error = std::move(refusal.error);
    error.file = file.string();
    if (error.subject.empty() && !error.place.empty()) error.subject = "damaged or not valid glTF";
    return error;
  } catch (const std::bad_alloc&) {
    return failed("", "there is not enough memory to read it");
  } catch (const std::exception& error) {
    return failed("", std::string("cannot be read: ") + error.what());
  }
}

}  // namespace

Result<std::shared_ptr<const Character>> importGltf(const std::filesystem::path& file) {
  return read(file, ReadFor::kCharacter);
}

Result<std::shared_ptr<const Character>> importClips(const std::filesystem::path& file) {
  return read(file, ReadFor::kClips);
}

}  // namespace sinew
