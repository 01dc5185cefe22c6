// core/files/rig_json.cpp: Rig -> text, and the rig's files.
#include "sinew/files/rig_json.h"

#include <algorithm>
#include <span>
#include <system_error>

#include "core/files/disk/atomic_file.h"
#include "core/files/json/writer.h"
#include "core/files/rig_json_animated.h"
#include "core/files/rig_json_lines.h"
#include "core/geometry/affine_image.h"
#include "core/rig/mesh_layers.h"
#include "core/rig/morphs.h"
#include "core/rig/validation.h"
#include "sinew/surface/projection_kind.h"

namespace sinew {
namespace {

constexpr std::uintmax_t kMaxRigBytes = std::uintmax_t{64} << 20;

template <class Strings>
Json strings(const Strings& values) {
  std::vector<Json> items;
  for (const std::string& value : values) items.push_back(value);
  return Json::array(std::move(items));
}

template <class Items, class Write>
Json listOf(const Items& items, Write write) {
  std::vector<Json> nodes;
  for (const auto& item : items) nodes.push_back(write(item));
  return Json::array(std::move(nodes));
}

Json surfaceNode(const SurfaceSettings& surface) {
  ObjectWriter writer;
  writer.set("mode", nameOf(surface.mode)).set("iso", surface.iso).set("skin_blend", surface.skinBlend);
  setAnimated(writer, surface.animated);
  return writer.finish(surface.unknownKeys);
}

Json smoothingNode(const SmoothingSettings& smoothing) {
  ObjectWriter writer;
  writer.set("depth", smoothing.depth).set("patch", nameOf(smoothing.patch));
  if (smoothing.alongNormals) writer.set("projection", nameOf(ProjectionKind::kAnalytic));
  if (smoothing.creaseAngle != kDefaultCreaseAngle) writer.set("crease_angle", smoothing.creaseAngle);
  if (smoothing.detail != DetailKind::kUniform) writer.set("detail", nameOf(smoothing.detail));
  if (smoothing.tolerance != kDefaultTolerance) writer.set("tolerance", smoothing.tolerance);
  if (smoothing.autoDepth) writer.set("auto_depth", true);
  return writer.finish(smoothing.unknownKeys);
}

Json groupNode(const Group& group) { return ObjectWriter().set("name", group.name).finish(group.unknownKeys); }

void setShape(const Shape& shape, ObjectWriter& writer) {
  for (const std::span<const ShapeNumber> key : shapeKeys()) {
    std::vector<Json> values;
    for (const ShapeNumber& number : key) values.push_back(number.of(shape));
    if (std::ranges::all_of(key, [&](const ShapeNumber& number) { return number.of(shape) == 0.0f; })) continue;
    writer.set(key.front().key, values.size() == 1 ? values.front() : Json::array(std::move(values)));
  }
}

Json primitiveNode(const Primitive& primitive) {
  const auto& [center, rotation, radii, shape] = primitive.placement;
  ObjectWriter writer;
  writer.set("name", primitive.name)
      .set("bone", primitive.bone)
      .set("group", primitive.group)
      .set("kind", "ellipsoid")
      .set("center", numbers({center.x, center.y, center.z}))
      .set("rotation", numbers({rotation.x, rotation.y, rotation.z, rotation.w}))
      .set("radii", numbers({radii.x, radii.y, radii.z}));
  setShape(shape, writer);
  writer.set("reach", primitive.reach).set("sign", primitive.sign);
  if (primitive.amount != 1.0f) writer.set("amount", primitive.amount);
  if (!primitive.line.empty()) writer.set("line", primitive.line);
  if (!primitive.mirror.empty()) writer.set("mirror", primitive.mirror);
  if (primitive.territory) writer.set("territory", strings(*primitive.territory));
  setAnimated(writer, primitive.animated);
  return writer.finish(primitive.unknownKeys);
}

Json slotsNode(const std::vector<SlotCorrection>& slots) {
  Json node = Json::object();
  for (const SlotCorrection& slot : slots) node.set(slot.slot, slot.bone.empty() ? Json() : Json(slot.bone));
  return node;
}

Json layersNode(const std::vector<LayerChoice>& layers) {
  Json node = Json::object();
  for (const LayerChoice& choice : layers) node.set(choice.part, nameOf(choice.layer));
  return node;
}

/// Those that do something.
Json shapesNode(const std::vector<MorphWeight>& morphs) {
  std::vector<Json> nodes;
  for (const MorphWeight& morph : morphs) {
    if (isIdle(morph)) continue;
    ObjectWriter writer;
    writer.set("name", morph.name).set("weight", morph.weight);
    setAnimated(writer, morph.animated);
    nodes.push_back(writer.finish(morph.unknownKeys));
  }
  return Json::array(std::move(nodes));
}

/// The oldest version that can say what is in the rig: older programs read what they can.
int versionOf(const Rig& rig) {
  const bool newer = std::ranges::any_of(rig.primitives, [](const Primitive& p) {
    return !p.placement.shape.isPlain() || p.amount != 1.0f || !p.animated.empty();
  });
  const bool plain = rig.lines.empty() && rig.channels.empty() && rig.surface.animated.empty() && rig.layers.empty();
  return plain && !newer && std::ranges::all_of(rig.morphs, isIdle) ? 1 : 2;
}

Error inFile(Error error, const std::filesystem::path& file) {
  error.file = file.string();
  return error;
}

}  // namespace

std::string rigToJson(const Rig& rig) {
  ObjectWriter root;
  root.set("format", "sinew-rig")
      .set("version", versionOf(rig))
      .set("character", rig.character)
      .set("surface", surfaceNode(rig.surface))
      .set("smoothing", smoothingNode(rig.smoothing))
      .set("groups", listOf(rig.groups, groupNode))
      .set("links", listOf(rig.links, [](const auto& link) { return strings(link); }));
  if (!rig.clipFiles.empty()) root.set("clips", strings(rig.clipFiles));
  if (!rig.slots.empty()) root.set("slots", slotsNode(rig.slots));
  if (!rig.layers.empty()) root.set("layers", layersNode(rig.layers));
  if (!rig.channels.empty()) root.set("channels", listOf(rig.channels, channelNode));
  if (!rig.lines.empty()) root.set("lines", listOf(rig.lines, lineNode));
  root.set("primitives", listOf(rig.primitives, primitiveNode));
  if (!std::ranges::all_of(rig.morphs, isIdle)) root.set("shapes", shapesNode(rig.morphs));
  return root.finish(rig.unknownKeys).dump(true) + '\n';
}

Result<Rig> loadRig(const std::filesystem::path& file) {
  const auto text = readWholeFile(file, kMaxRigBytes);
  if (!text) return text.error();
  auto rig = rigFromJson(text.value());
  if (!rig) return inFile(rig.error(), file);
  return rig;
}

Result<void> saveRig(const Rig& rig, const std::filesystem::path& file) {
  if (const auto valid = validate(rig); !valid) return inFile(valid.error(), file);
  if (rig.character.empty()) return inFile(errorAt("character", "expected the path of a character, got nothing"), file);
  return writeFileAtomically(file, rigToJson(rig));
}

std::filesystem::path characterPath(const Rig& rig, const std::filesystem::path& rigFile) {
  return rigFile.parent_path() / std::filesystem::path(rig.character);
}

std::string relativeCharacterPath(const std::filesystem::path& character, const std::filesystem::path& rigFile) {
  // Through the real folders, so that ".." means the same to us and to the system where a folder is a link.
  std::error_code failed;
  const auto folder =
      std::filesystem::weakly_canonical(std::filesystem::absolute(rigFile, failed).parent_path(), failed);
  if (failed) return character.generic_string();
  const auto absolute = std::filesystem::absolute(character, failed);
  const auto target = std::filesystem::weakly_canonical(absolute.parent_path(), failed) / absolute.filename();
  if (failed) return character.generic_string();
  const auto relative = target.lexically_relative(folder);
  return relative.empty() ? target.generic_string() : relative.generic_string();
}

}  // namespace sinew
