// core/files/rig_json_read.cpp: text -> Rig, strictly, every refusal with its JSON path.
#include "sinew/files/rig_json.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/files/json/reader.h"
#include "core/files/rig_json_animated.h"
#include "core/files/rig_json_lines.h"
#include "core/geometry/affine_image.h"
#include "core/rig/mesh_layers.h"
#include "core/rig/validation.h"
#include "sinew/surface/projection_kind.h"

namespace sinew {
namespace {

using Kind = Json::Kind;

constexpr int kNewestVersion = 2;

SurfaceSettings readSurface(Reader& reader, const Json& node) {
  SurfaceSettings surface;
  if (!reader.object(node, "surface")) return surface;
  readWord(reader, node, "surface", "mode", "\"swell\" or \"replace\"", surfaceModeNamed, surface.mode);
  readFloat(reader, node, "surface", "iso", surface.iso);
  readFloat(reader, node, "surface", "skin_blend", surface.skinBlend);
  surface.animated = readAnimated(reader, node, "surface");
  surface.unknownKeys = unknownKeys(node, {"mode", "iso", "skin_blend", "animated"});
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

Group readGroup(Reader& reader, const Json& node, const Place& place) {
  if (!reader.object(node, place)) return {};
  return {readNeededText(reader, node, place, "name"), unknownKeys(node, {"name"})};
}

std::array<std::string, 2> readLink(Reader& reader, const Json& node, const Place& place) {
  if (node.kind != Kind::kArray || node.children.size() != 2) {
    reader.expect(place, "an array of two groups' names", node);
    return {};
  }
  return {reader.text(node.children[0], Reader::at(place, 0)), reader.text(node.children[1], Reader::at(place, 1))};
}

/// The numbers of one key: one by itself, or a list.
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
  if (const Json* center = reader.need(node, place, "center", "an array of 3 numbers")) {
    const auto [x, y, z] = reader.vector<3>(*center, Reader::join(place, "center"));
    placement.center = {x, y, z};
  }
  if (const Json* rotation = node.find("rotation")) {
    const auto [x, y, z, w] = reader.vector<4>(*rotation, Reader::join(place, "rotation"));
    placement.rotation = glm::quat(w, x, y, z);
  }
  if (const Json* radii = reader.need(node, place, "radii", "an array of 3 numbers")) {
    const auto [x, y, z] = reader.vector<3>(*radii, Reader::join(place, "radii"));
    placement.radii = {x, y, z};
  }
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
  if (const Json* line = node.find("line")) {
    primitive.line = reader.text(*line, Reader::join(place, "line"));
    if (primitive.line.empty()) reader.expect(Reader::join(place, "line"), "the name of a line", *line);
  }
  if (const Json* mirror = node.find("mirror")) {
    primitive.mirror = reader.text(*mirror, Reader::join(place, "mirror"));
    if (primitive.mirror.empty())
      reader.expect(Reader::join(place, "mirror"), "the name of another primitive", *mirror);
  }
  if (const Json* territory = node.find("territory")) {
    primitive.territory.emplace();
    reader.each(*territory, Reader::join(place, "territory"), [&](const Json& bone, const Place& bonePlace) {
      primitive.territory->push_back(reader.text(bone, bonePlace));
    });
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

/// Is it a rig at all, and one this program can read?
void readHeader(Reader& reader, const Json& root) {
  if (!reader.object(root, {"", "not a rig"})) return;
  const Json* format = reader.need(root, "", "format", "\"sinew-rig\"");
  if (!format) return;
  if (format->kind != Kind::kString || format->content != "sinew-rig")
    reader.expect("format", "\"sinew-rig\"", *format);
  const Json* version = reader.need(root, "", "version", "1 or 2");
  if (!version || reader.error()) return;
  const int number = reader.wholeNumber(*version, "version", "1 or 2");
  if (number > kNewestVersion) {
    reader.refuse("version", "this rig is of version " + std::to_string(number) +
                                 ", made by a newer Sinew; this one reads versions up to " +
                                 std::to_string(kNewestVersion));
  } else if (number < 1) {
    reader.expect("version", "1 or 2", *version);
  }
}

Rig readRig(Reader& reader, const Json& root) {
  Rig rig;
  rig.character = readNeededText(reader, root, "", "character");
  if (rig.character.empty()) reader.refuse("character", "expected the path of a character, got nothing");
  if (const Json* surface = root.find("surface")) rig.surface = readSurface(reader, *surface);
  if (const Json* smoothing = root.find("smoothing")) rig.smoothing = readSmoothing(reader, *smoothing);
  if (const Json* groups = root.find("groups")) {
    reader.each(*groups, {"groups", "group"},
                [&](const Json& node, const Place& place) { rig.groups.push_back(readGroup(reader, node, place)); });
  }
  if (const Json* links = root.find("links")) {
    reader.each(*links, {"links", "link"},
                [&](const Json& node, const Place& place) { rig.links.push_back(readLink(reader, node, place)); });
  }
  if (const Json* clips = root.find("clips")) {
    reader.each(*clips, {"clips", "clip file"},
                [&](const Json& node, const Place& place) { rig.clipFiles.push_back(reader.text(node, place)); });
  }
  if (const Json* slots = root.find("slots")) rig.slots = readSlots(reader, *slots);
  if (const Json* layers = root.find("layers")) rig.layers = readLayers(reader, *layers);
  if (const Json* channels = root.find("channels")) {
    reader.each(*channels, {"channels", "channel"}, [&](const Json& node, const Place& place) {
      rig.channels.push_back(readChannel(reader, node, place));
    });
  }
  if (const Json* lines = root.find("lines")) {
    reader.each(*lines, {"lines", "muscle line"},
                [&](const Json& node, const Place& place) { rig.lines.push_back(readLine(reader, node, place)); });
  }
  if (const Json* primitives = root.find("primitives")) {
    reader.each(*primitives, {"primitives", "muscle"}, [&](const Json& node, const Place& place) {
      rig.primitives.push_back(readPrimitive(reader, node, place));
    });
  }
  if (const Json* shapes = root.find("shapes")) {
    reader.each(*shapes, {"shapes", "shape"}, [&](const Json& node, const Place& place) {
      rig.morphs.push_back(readShapeWeight(reader, node, place));
    });
  }
  rig.unknownKeys = unknownKeys(root, {"format", "version", "character", "surface", "smoothing", "groups", "links",
                                       "clips", "slots", "layers", "channels", "lines", "primitives", "shapes"});
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
