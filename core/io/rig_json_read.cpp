// core/io/rig_json_read.cpp: text -> Rig, strictly, every refusal with its JSON path.
#include "sinew/io/rig_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "core/io/json/json.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

using Kind = Json::Kind;

constexpr long long kNewestVersion = 1;

std::string describe(const Json& node) {
  switch (node.kind) {
    case Kind::kNull:
      return "null";
    case Kind::kFalse:
      return "false";
    case Kind::kTrue:
      return "true";
    case Kind::kNumber:
      return node.content;
    case Kind::kString:
      return node.content.size() <= 40 ? '"' + node.content + '"' : "a text";
    case Kind::kArray:
      return "an array of " + std::to_string(node.children.size());
    case Kind::kObject:
      break;
  }
  return "an object";
}

/// Where in the file, twice: as a JSON path, and in the interface's words.
struct Place {
  std::string path;
  std::string words;

  Place(const char* both) : Place(both, both) {}  // NOLINT: implicit on purpose, most keys are their own words
  Place(std::string json, std::string named) : path(std::move(json)), words(std::move(named)) {}
};

/// Takes a tree apart. The first thing found wrong is kept; after it every answer is a default.
class Reader {
 public:
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  void refuse(const Place& place, std::string reason) {
    if (!error_) error_ = errorAt(place.path, std::move(reason), place.words);
  }

  void expect(const Place& place, const std::string& expected, const Json& node) {
    refuse(place, "expected " + expected + ", got " + describe(node));
  }

  /// Null, after a refusal, if the key is missing.
  const Json* need(const Json& object, const Place& place, const char* key, const std::string& expected) {
    const Json* child = object.find(key);
    if (!child) refuse(join(place, key), "expected " + expected + ", but the key is missing");
    return child;
  }

  std::string text(const Json& node, const Place& place) {
    if (node.kind == Kind::kString) return node.content;
    expect(place, "a text", node);
    return {};
  }

  float number(const Json& node, const Place& place) {
    if (node.kind != Kind::kNumber) {
      expect(place, "a number", node);
      return 0.0f;
    }
    float value = 0.0f;
    const char* const end = node.content.data() + node.content.size();
    if (std::from_chars(node.content.data(), end, value).ec == std::errc{}) return value;
    // Out of a float's range: too close to 0 rounds to 0, too far from it is no number we can keep.
    double wide = 0.0;
    if (std::from_chars(node.content.data(), end, wide).ec != std::errc{} || std::abs(wide) < 1.0) return 0.0f;
    expect(place, "a number of at most 3.4028235e+38", node);
    return 0.0f;
  }

  int wholeNumber(const Json& node, const Place& place, const std::string& expected) {
    int value = 0;
    const char* const end = node.content.data() + node.content.size();
    const auto [stop, status] = std::from_chars(node.content.data(), end, value);
    if (node.kind == Kind::kNumber && status == std::errc{} && stop == end) return value;
    expect(place, expected, node);
    return 0;
  }

  template <std::size_t N>
  std::array<float, N> vector(const Json& node, const Place& place) {
    std::array<float, N> values{};
    if (node.kind != Kind::kArray || node.children.size() != N) {
      expect(place, "an array of " + std::to_string(N) + " numbers", node);
      return values;
    }
    for (std::size_t i = 0; i < N; ++i) values[i] = number(node.children[i], at(place, i));
    return values;
  }

  /// The children, each with its place; none, after a refusal, if the node is no array.
  template <class Read>
  void each(const Json& node, const Place& place, Read read) {
    if (node.kind != Kind::kArray) expect(place, "an array", node);
    for (std::size_t i = 0; !error_ && i < node.children.size(); ++i) read(node.children[i], at(place, i));
  }

  bool object(const Json& node, const Place& place) {
    if (node.kind != Kind::kObject) expect(place, "an object", node);
    return node.kind == Kind::kObject;
  }

  static Place join(const Place& place, const char* key) {
    if (place.path.empty()) return key;
    return {place.path + '.' + key, place.words + ", " + key};
  }
  static Place at(const Place& place, std::size_t i) {
    return {place.path + '[' + std::to_string(i) + ']', place.words + ' ' + std::to_string(i + 1)};
  }

 private:
  std::optional<Error> error_;
};

/// What the object holds beyond `known`, as the text of an object; "" for nothing.
std::string unknownKeys(const Json& object, std::initializer_list<std::string_view> known) {
  Json rest = Json::object();
  for (const Json& child : object.children) {
    if (std::ranges::find(known, child.key) == known.end()) rest.children.push_back(child);
  }
  return rest.children.empty() ? std::string() : rest.dump();
}

/// A member that is one of a few words; absent: as it was.
template <class Enum>
void readWord(Reader& reader, const Json& object, const Place& place, const char* key, const char* words,
              std::optional<Enum> (*named)(const std::string&), Enum& value) {
  const Json* node = object.find(key);
  if (!node) return;
  const auto found = node->kind == Kind::kString ? named(node->content) : std::nullopt;
  if (found) {
    value = *found;
  } else {
    reader.expect(Reader::join(place, key), words, *node);
  }
}

void readFloat(Reader& reader, const Json& object, const Place& place, const char* key, float& value) {
  if (const Json* node = object.find(key)) value = reader.number(*node, Reader::join(place, key));
}

void readSwitch(Reader& reader, const Json& object, const Place& place, const char* key, bool& value) {
  const Json* node = object.find(key);
  if (!node) return;
  value = node->kind == Kind::kTrue;
  if (!value && node->kind != Kind::kFalse) reader.expect(Reader::join(place, key), "true or false", *node);
}

std::string readNeededText(Reader& reader, const Json& object, const Place& place, const char* key) {
  const Json* node = reader.need(object, place, key, "a text");
  return node ? reader.text(*node, Reader::join(place, key)) : std::string();
}

SurfaceSettings readSurface(Reader& reader, const Json& node) {
  SurfaceSettings surface;
  if (!reader.object(node, "surface")) return surface;
  readWord(reader, node, "surface", "mode", "\"swell\" or \"replace\"", surfaceModeNamed, surface.mode);
  readFloat(reader, node, "surface", "iso", surface.iso);
  readFloat(reader, node, "surface", "skin_blend", surface.skinBlend);
  surface.unknownKeys = unknownKeys(node, {"mode", "iso", "skin_blend"});
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
  readWord(reader, node, "smoothing", "projection", "\"newton\", \"bisection\" or \"analytic\"", projectionKindNamed,
           smoothing.projection);
  readFloat(reader, node, "smoothing", "crease_angle", smoothing.creaseAngle);
  readSwitch(reader, node, "smoothing", "auto_depth", smoothing.autoDepth);
  smoothing.unknownKeys = unknownKeys(node, {"depth", "patch", "projection", "crease_angle", "auto_depth"});
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
  if (const Json* sign = node.find("sign")) {
    primitive.sign = reader.wholeNumber(*sign, Reader::join(place, "sign"), "1 or -1");
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
  primitive.unknownKeys = unknownKeys(
      node, {"name", "bone", "group", "kind", "center", "rotation", "radii", "reach", "sign", "mirror", "territory"});
  return primitive;
}

/// Is it a rig at all, and one this program can read?
void readHeader(Reader& reader, const Json& root) {
  if (!reader.object(root, {"", "not a rig"})) return;
  const Json* format = reader.need(root, "", "format", "\"sinew-rig\"");
  if (!format) return;
  if (format->kind != Kind::kString || format->content != "sinew-rig")
    reader.expect("format", "\"sinew-rig\"", *format);
  const Json* version = reader.need(root, "", "version", "1");
  if (!version || reader.error()) return;
  const int number = reader.wholeNumber(*version, "version", "1");
  if (number > kNewestVersion) {
    reader.refuse("version", "this rig is of version " + std::to_string(number) +
                                 ", made by a newer Sinew; this one reads version " + std::to_string(kNewestVersion));
  } else if (number < 1) {
    reader.expect("version", "1", *version);
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
  if (const Json* primitives = root.find("primitives")) {
    reader.each(*primitives, {"primitives", "muscle"}, [&](const Json& node, const Place& place) {
      rig.primitives.push_back(readPrimitive(reader, node, place));
    });
  }
  rig.unknownKeys =
      unknownKeys(root, {"format", "version", "character", "surface", "smoothing", "groups", "links", "primitives"});
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
