// core/files/rig_json.cpp: rig files, written and read.
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/rig_json_parts.h"
#include "core/geometry/affine_image.h"
#include "core/rig/mesh_layers.h"
#include "core/rig/rig_edit.h"
#include "core/rig/validation.h"
#include "sinew/files/rig_json.h"
#include "sinew/surface/projection_kind.h"

namespace sinew {
namespace {

constexpr std::uintmax_t kMaxRigBytes = std::uintmax_t{64} << 20;

Json surfaceNode(const SurfaceSettings& surface) {
  ObjectWriter writer;
  writer.set("mode", nameOf(surface.mode)).set("iso", surface.iso).set("skin_blend", surface.skinBlend);
  if (surface.grooves != 0.0f) writer.set("grooves", surface.grooves);
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
  if (primitive.territory) writer.set("territory", jsonList(*primitive.territory));
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

/// Omits idle shapes.
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

/// The oldest version that can express the rig, so that older programs can read it.
int versionOf(const Rig& rig) {
  if (!rig.sheets.empty()) return 4;
  if (!std::ranges::all_of(rig.links, isList)) return 3;
  const bool newer = std::ranges::any_of(rig.primitives, [](const Primitive& p) {
    return !p.placement.shape.isPlain() || p.amount != 1.0f || !p.animated.empty();
  });
  const bool plain = rig.lines.empty() && rig.channels.empty() && rig.surface.animated.empty() && rig.layers.empty();
  const bool whole = std::ranges::all_of(rig.links, [](const Link& link) { return link.amount == 1.0f; });
  return plain && !newer && whole && std::ranges::all_of(rig.morphs, isIdle) ? 1 : 2;
}

/// What follows from sheets is not in files.
template <class Items, class Write>
Json listWithoutSheets(const Items& items, const Write& write) {
  std::vector<Json> list;
  for (const auto& item : items) {
    if (item.sheet.empty()) list.push_back(write(item));
  }
  return Json::array(std::move(list));
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
      .set("groups", jsonList(rig.groups, groupNode))
      .set("links", jsonList(rig.links, linkNode));
  if (!rig.clipFiles.empty()) root.set("clips", jsonList(rig.clipFiles));
  if (!rig.slots.empty()) root.set("slots", slotsNode(rig.slots));
  if (!rig.layers.empty()) root.set("layers", layersNode(rig.layers));
  if (!rig.channels.empty()) root.set("channels", jsonList(rig.channels, channelNode));
  if (const Json lines = listWithoutSheets(rig.lines, lineNode); !lines.children.empty()) root.set("lines", lines);
  if (!rig.sheets.empty()) root.set("sheets", jsonList(rig.sheets, sheetNode));
  root.set("primitives", listWithoutSheets(rig.primitives, primitiveNode));
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
  // With real folders, so that ".." means the same to the system where a folder is a link.
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

// Reading, strictly.

namespace {

using Kind = Json::Kind;

constexpr int kNewestVersion = 4;

SurfaceSettings readSurface(Reader& reader, const Json& node) {
  SurfaceSettings surface;
  if (!reader.object(node, "surface")) return surface;
  readWord(reader, node, "surface", "mode", "\"swell\" or \"replace\"", surfaceModeNamed, surface.mode);
  readFloat(reader, node, "surface", "iso", surface.iso);
  readFloat(reader, node, "surface", "skin_blend", surface.skinBlend);
  readFloat(reader, node, "surface", "grooves", surface.grooves);
  surface.animated = readAnimated(reader, node, "surface");
  surface.unknownKeys = unknownKeys(node, {"mode", "iso", "skin_blend", "grooves", "animated"});
  return surface;
}

SmoothingSettings readSmoothing(Reader& reader, const Json& node) {
  SmoothingSettings smoothing;
  if (!reader.object(node, "smoothing")) return smoothing;
  if (const Json* depth = node.find("depth")) {
    smoothing.depth = reader.wholeNumber(*depth, Reader::join("smoothing", "depth"),
                                         "a whole number from 1 to " + std::to_string(kMaxDepth));
  }
  readWord(reader, node, "smoothing", "patch", "\"pn\", \"phong\", \"spherigon\" or \"flat\"", patchKindNamed,
           smoothing.patch);
  ProjectionKind projection = ProjectionKind::kNewton;
  readWord(reader, node, "smoothing", "projection", "\"newton\", \"bisection\" or \"analytic\"", projectionKindNamed,
           projection);
  smoothing.alongNormals = projection == ProjectionKind::kAnalytic;
  readFloat(reader, node, "smoothing", "crease_angle", smoothing.creaseAngle);
  readWord(reader, node, "smoothing", "detail", "\"uniform\" or \"adaptive\"", detailKindNamed, smoothing.detail);
  readFloat(reader, node, "smoothing", "tolerance", smoothing.tolerance);
  readSwitch(reader, node, "smoothing", "auto_depth", smoothing.autoDepth);
  smoothing.unknownKeys =
      unknownKeys(node, {"depth", "patch", "projection", "crease_angle", "detail", "tolerance", "auto_depth"});
  return smoothing;
}

std::string readItem(Reader& reader, const Json& node, const Place& place) { return reader.text(node, place); }

Group readGroup(Reader& reader, const Json& node, const Place& place) {
  if (!reader.object(node, place)) return {};
  return {readNeededText(reader, node, place, "name"), unknownKeys(node, {"name"})};
}

/// The numbers of one key: a single number or a list.
void readShape(Reader& reader, const Json& node, const Place& place, std::span<const ShapeNumber> key, Shape& shape) {
  const Json* found = node.find(key.front().key);
  if (found == nullptr) return;
  const Place own = Reader::join(place, key.front().key);
  std::array<float, kShapeNumbers> values{};
  if (key.size() == 1) values[0] = reader.number(*found, own);
  else reader.vector(*found, own, std::span(values).first(key.size()));
  for (std::size_t i = 0; i < key.size(); ++i) key[i].member(shape) = values[i];
}

Placement readPlacement(Reader& reader, const Json& node, const Place& place) {
  Placement placement;
  readNeededPoint(reader, node, place, "center", placement.center);
  if (const Json* rotation = node.find("rotation")) {
    const auto [x, y, z, w] = reader.vector<4>(*rotation, Reader::join(place, "rotation"));
    placement.rotation = glm::quat(w, x, y, z);
  }
  readNeededPoint(reader, node, place, "radii", placement.radii);
  for (const std::span<const ShapeNumber> key : shapeKeys()) readShape(reader, node, place, key, placement.shape);
  return placement;
}

void readKind(Reader& reader, const Json& node, const Place& place) {
  const Json* kind = node.find("kind");
  if (kind && !(kind->kind == Kind::kString && kind->content == "ellipsoid")) {
    reader.expect(Reader::join(place, "kind"), "\"ellipsoid\"", *kind);
  }
}

Primitive readPrimitive(Reader& reader, const Json& node, const Place& listed) {
  Primitive primitive;
  if (!reader.object(node, listed)) return primitive;
  primitive.name = readNeededText(reader, node, listed, "name");
  const Place place{listed.path, primitive.name.empty() ? listed.words : "muscle \"" + primitive.name + '"'};
  primitive.bone = readNeededText(reader, node, place, "bone");
  primitive.group = readNeededText(reader, node, place, "group");
  readKind(reader, node, place);
  primitive.placement = readPlacement(reader, node, place);
  readFloat(reader, node, place, "reach", primitive.reach);
  readFloat(reader, node, place, "amount", primitive.amount);
  if (const Json* sign = node.find("sign")) {
    primitive.sign = reader.wholeNumber(*sign, Reader::join(place, "sign"), "1 or -1");
  }
  readName(reader, node, place, "line", "the name of a line", primitive.line);
  readName(reader, node, place, "mirror", "the name of another primitive", primitive.mirror);
  if (node.find("territory")) {
    primitive.territory = readList(reader, node, place, "territory", "territory", readItem);
  }
  primitive.animated = readAnimated(reader, node, place);
  std::vector<std::string_view> known{"name",  "bone",  "group",  "line", "kind",   "center",    "rotation",
                                      "radii", "reach", "amount", "sign", "mirror", "territory", "animated"};
  for (const ShapeNumber& number : shapeNumbers()) known.push_back(number.key);
  primitive.unknownKeys = unknownKeys(node, known);
  return primitive;
}

std::vector<SlotCorrection> readSlots(Reader& reader, const Json& node) {
  std::vector<SlotCorrection> slots;
  if (!reader.object(node, "slots")) return slots;
  for (const Json& slot : node.children) {
    const Place place{"slots." + slot.key, "slot \"" + slot.key + '"'};
    slots.push_back({slot.key, slot.isNull() ? std::string() : reader.text(slot, place)});
    if (!slot.isNull() && slots.back().bone.empty()) reader.expect(place, "the name of a bone, or null", slot);
  }
  return slots;
}

std::vector<LayerChoice> readLayers(Reader& reader, const Json& node) {
  std::vector<LayerChoice> layers;
  if (!reader.object(node, "layers")) return layers;
  for (const Json& one : node.children) {
    const Place place{"layers." + one.key, "part \"" + one.key + '"'};
    const auto layer = one.kind == Kind::kString ? skinLayerNamed(one.content) : std::nullopt;
    if (layer) layers.push_back({one.key, *layer});
    else reader.expect(place, "\"skin\", \"cloth\" or \"rigid\"", one);
  }
  return layers;
}

MorphWeight readShapeWeight(Reader& reader, const Json& node, const Place& listed) {
  MorphWeight morph;
  if (!reader.object(node, listed)) return morph;
  morph.name = readNeededText(reader, node, listed, "name");
  const Place place{listed.path, morph.name.empty() ? listed.words : "shape \"" + morph.name + '"'};
  readFloat(reader, node, place, "weight", morph.weight);
  morph.animated = readAnimated(reader, node, place);
  morph.unknownKeys = unknownKeys(node, {"name", "weight", "animated"});
  return morph;
}

/// Refuses files that are not rigs, and newer versions.
void readHeader(Reader& reader, const Json& root) {
  if (!reader.object(root, {"", "not a rig"})) return;
  const Json* format = reader.need(root, "", "format", "\"sinew-rig\"");
  if (!format) return;
  if (format->kind != Kind::kString || format->content != "sinew-rig")
    reader.expect("format", "\"sinew-rig\"", *format);
  const Json* version = reader.need(root, "", "version", "1, 2, 3 or 4");
  if (!version || reader.error()) return;
  const int number = reader.wholeNumber(*version, "version", "1, 2, 3 or 4");
  if (number > kNewestVersion) {
    reader.refuse("version", "this rig is of version " + std::to_string(number) +
                                 ", made by a newer Sinew; this one reads versions up to " +
                                 std::to_string(kNewestVersion));
  } else if (number < 1) {
    reader.expect("version", "1, 2, 3 or 4", *version);
  }
}

Rig readRig(Reader& reader, const Json& root) {
  Rig rig;
  rig.character = readNeededText(reader, root, "", "character");
  if (rig.character.empty()) reader.refuse("character", "expected the path of a character, got nothing");
  if (const Json* surface = root.find("surface")) rig.surface = readSurface(reader, *surface);
  if (const Json* smoothing = root.find("smoothing")) rig.smoothing = readSmoothing(reader, *smoothing);
  rig.groups = readList(reader, root, "", "groups", "group", readGroup);
  rig.links = readList(reader, root, "", "links", "link", readLink);
  rig.clipFiles = readList(reader, root, "", "clips", "clip file", readItem);
  if (const Json* slots = root.find("slots")) rig.slots = readSlots(reader, *slots);
  if (const Json* layers = root.find("layers")) rig.layers = readLayers(reader, *layers);
  rig.channels = readList(reader, root, "", "channels", "channel", readChannel);
  rig.lines = readList(reader, root, "", "lines", "muscle line", readLine);
  rig.sheets = readList(reader, root, "", "sheets", "sheet", readSheet);
  rig.primitives = readList(reader, root, "", "primitives", "muscle", readPrimitive);
  rig.morphs = readList(reader, root, "", "shapes", "shape", readShapeWeight);
  rig.unknownKeys =
      unknownKeys(root, {"format", "version", "character", "surface", "smoothing", "groups", "links", "clips", "slots",
                         "layers", "channels", "lines", "sheets", "primitives", "shapes"});
  return rig;
}

}  // namespace

Result<Rig> rigFromJson(const std::string& text) {
  const auto root = Json::parse(text);
  if (!root) return about("damaged", root.error());
  Reader reader;
  readHeader(reader, root.value());
  if (reader.error()) return *reader.error();
  Rig rig = readRig(reader, root.value());
  if (reader.error()) return *reader.error();
  if (auto valid = validate(rig); !valid) return valid.error();
  return rig;
}

}  // namespace sinew
