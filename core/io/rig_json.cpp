// core/io/rig_json.cpp: Rig -> text, and the rig's files.
#include "sinew/io/rig_json.h"

#include <algorithm>
#include <initializer_list>
#include <system_error>

#include "core/io/files/atomic_file.h"
#include "core/io/json/json_text.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

using Kind = JsonNode::Kind;

constexpr std::uintmax_t kMaxRigBytes = std::uintmax_t{64} << 20;

JsonNode list(std::vector<JsonNode> items) { return {Kind::kArray, {}, {}, std::move(items)}; }

JsonNode numbers(std::initializer_list<float> values) {
  std::vector<JsonNode> items;
  for (const float value : values) items.push_back(numberNode(value));
  return list(std::move(items));
}

template <class Strings>
JsonNode strings(const Strings& values) {
  std::vector<JsonNode> items;
  for (const std::string& value : values) items.push_back(stringNode(value));
  return list(std::move(items));
}

template <class Items, class Write>
JsonNode listOf(const Items& items, Write write) {
  std::vector<JsonNode> nodes;
  for (const auto& item : items) nodes.push_back(write(item));
  return list(std::move(nodes));
}

/// An object in the making: known keys in order, then the unknown ones it came with.
class ObjectWriter {
 public:
  ObjectWriter& set(const char* key, JsonNode value) {
    value.key = key;
    object_.children.push_back(std::move(value));
    return *this;
  }

  JsonNode finish(const std::string& unknownKeys) {
    if (unknownKeys.empty()) return std::move(object_);
    auto unknown = parseJson(unknownKeys);
    if (!unknown) return std::move(object_);
    for (JsonNode& child : unknown.value().children) {
      if (!object_.find(child.key)) object_.children.push_back(std::move(child));
    }
    return std::move(object_);
  }

 private:
  JsonNode object_{Kind::kObject, {}, {}, {}};
};

JsonNode surfaceNode(const SurfaceSettings& surface) {
  return ObjectWriter()
      .set("mode", stringNode(nameOf(surface.mode)))
      .set("iso", numberNode(surface.iso))
      .set("skin_blend", numberNode(surface.skinBlend))
      .finish(surface.unknownKeys);
}

JsonNode smoothingNode(const SmoothingSettings& smoothing) {
  ObjectWriter writer;
  writer.set("depth", numberNode(static_cast<long long>(smoothing.depth)))
      .set("patch", stringNode(nameOf(smoothing.patch)))
      .set("projection", stringNode(nameOf(smoothing.projection)));
  if (smoothing.creaseAngle != kDefaultCreaseAngle) writer.set("crease_angle", numberNode(smoothing.creaseAngle));
  if (smoothing.autoDepth) writer.set("auto_depth", {Kind::kTrue, {}, {}, {}});
  return writer.finish(smoothing.unknownKeys);
}

JsonNode groupNode(const Group& group) {
  return ObjectWriter().set("name", stringNode(group.name)).finish(group.unknownKeys);
}

JsonNode primitiveNode(const Primitive& primitive) {
  const auto& [center, rotation, radii] = primitive.placement;
  ObjectWriter writer;
  writer.set("name", stringNode(primitive.name))
      .set("bone", stringNode(primitive.bone))
      .set("group", stringNode(primitive.group))
      .set("kind", stringNode("ellipsoid"))
      .set("center", numbers({center.x, center.y, center.z}))
      .set("rotation", numbers({rotation.x, rotation.y, rotation.z, rotation.w}))
      .set("radii", numbers({radii.x, radii.y, radii.z}))
      .set("reach", numberNode(primitive.reach))
      .set("sign", numberNode(static_cast<long long>(primitive.sign)));
  if (!primitive.mirror.empty()) writer.set("mirror", stringNode(primitive.mirror));
  if (primitive.territory) writer.set("territory", strings(*primitive.territory));
  return writer.finish(primitive.unknownKeys);
}

Error inFile(Error error, const std::filesystem::path& file) {
  error.file = file.string();
  return error;
}

}  // namespace

std::string rigToJson(const Rig& rig) {
  const JsonNode root = ObjectWriter()
                            .set("format", stringNode("sinew-rig"))
                            .set("version", numberNode(1LL))
                            .set("character", stringNode(rig.character))
                            .set("surface", surfaceNode(rig.surface))
                            .set("smoothing", smoothingNode(rig.smoothing))
                            .set("groups", listOf(rig.groups, groupNode))
                            .set("links", listOf(rig.links, [](const auto& link) { return strings(link); }))
                            .set("primitives", listOf(rig.primitives, primitiveNode))
                            .finish(rig.unknownKeys);
  return writeJson(root, true) + '\n';
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
