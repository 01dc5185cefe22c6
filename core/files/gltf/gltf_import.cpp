// core/files/gltf/gltf_import.cpp: the import, stage by stage.

#include "sinew/files/gltf_import.h"

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <string_view>

#include "core/files/gltf/animation.h"
#include "core/files/gltf/mesh.h"
#include "core/files/gltf/node_tree.h"
#include "core/files/gltf/vrm_character.h"
#include "core/files/json/json.h"

namespace sinew {
namespace {

using namespace gltf;

/// Used fully, or by what they fall back to.
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

constexpr float kGltfImportLeastHeight = 1e-9f;  ///< Smaller characters leave what sums of squares can tell.

enum class ReadFor { kCharacter, kClips };

/// @return [V] the soup vertex that each welded one is
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
