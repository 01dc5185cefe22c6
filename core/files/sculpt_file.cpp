// core/files/sculpt_file.cpp: readers of .obj and .ply; .glb, .gltf and .vrm are imported as characters.
#include "core/files/sculpt_file.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/disk/atomic_file.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/geometry/weld.h"
#include "core/rig/mesh_layers.h"
#include "sinew/files/gltf_import.h"

namespace sinew {
namespace {

constexpr std::uintmax_t kMostSculptBytes = 1U << 30U;
constexpr std::size_t kMostSculptVertices = 4 * static_cast<std::size_t>(kMaxControlTriangles);
constexpr std::size_t kMostOfPolygon = 1024;
constexpr float kSculptWeld = 1e-6f;  ///< Of the height.

/// Vertices and triangles in the order of a file.
struct SculptSoup {
  std::vector<glm::vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// A fan; false: an index out of range, or too many triangles.
  [[nodiscard]] bool addPolygon(const std::vector<std::int64_t>& corners) {
    for (const std::int64_t corner : corners) {
      if (corner < 0 || corner >= static_cast<std::int64_t>(positions.size())) return false;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[i - 1]),
                           static_cast<std::uint32_t>(corners[i])});
    }
    return triangles.size() <= static_cast<std::size_t>(kMaxControlTriangles);
  }
};

/// Words of a text, line by line.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// False: the text has ended. A backslash at the end of a line joins the next.
  [[nodiscard]] bool nextLine() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    ++number_;
    return true;
  }
  /// Empty at the end of the line.
  [[nodiscard]] std::string_view next() {
    const auto isSpace = [](char c) { return c == ' ' || c == '\t'; };
    while (!line_.empty() && isSpace(line_.front())) line_.remove_prefix(1);
    std::size_t end = 0;
    while (end < line_.size() && !isSpace(line_[end])) ++end;
    const std::string_view word = line_.substr(0, end);
    line_.remove_prefix(end);
    return word;
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] std::string place() const { return "line " + std::to_string(number_); }

 private:
  std::string_view rest_;
  std::string_view line_;
  int number_ = 0;
};

template <class T>
std::optional<T> numberIn(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  T value{};
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (status != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

Result<SculptSoup> readObj(std::string_view text) {
  SculptSoup soup;
  Words words(text);
  std::vector<std::int64_t> corners;
  while (words.nextLine()) {
    const std::string_view kind = words.next();
    if (kind == "v") {
      glm::vec3 position(0.0f);
      for (int k = 0; k < 3; ++k) {
        const auto value = numberIn<float>(words.next());
        if (!value || !std::isfinite(*value)) return errorAt(words.place(), "expected three numbers after v");
        position[k] = *value;
      }
      soup.positions.push_back(position);
      if (soup.positions.size() > kMostSculptVertices) return errorAt(words.place(), "too many vertices");
    } else if (kind == "f") {
      corners.clear();
      for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        const auto index = numberIn<std::int64_t>(word.substr(0, word.find('/')));
        if (!index || *index == 0 || corners.size() == kMostOfPolygon)
          return errorAt(words.place(), "expected numbers of vertices after f");
        corners.push_back(*index > 0 ? *index - 1 : static_cast<std::int64_t>(soup.positions.size()) + *index);
      }
      if (!soup.addPolygon(corners)) return errorAt(words.place(), "a face names a vertex that is not there before it");
    }
  }
  return soup;
}

enum class PlyForm { kText, kLittle, kBig };

struct PlyProperty {
  std::string name;
  int size = 0;       ///< Bytes.
  char kind = 'f';    ///< i: signed, u: unsigned, f: real.
  int countSize = 0;  ///< Of a list: bytes of its length; 0: no list.
};
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

std::optional<std::pair<int, char>> plyType(std::string_view name) {
  if (name == "char" || name == "int8") return std::pair{1, 'i'};
  if (name == "uchar" || name == "uint8") return std::pair{1, 'u'};
  if (name == "short" || name == "int16") return std::pair{2, 'i'};
  if (name == "ushort" || name == "uint16") return std::pair{2, 'u'};
  if (name == "int" || name == "int32") return std::pair{4, 'i'};
  if (name == "uint" || name == "uint32") return std::pair{4, 'u'};
  if (name == "float" || name == "float32") return std::pair{4, 'f'};
  if (name == "double" || name == "float64") return std::pair{8, 'f'};
  return std::nullopt;
}

/// Numbers of the body of a .ply, one after another.
class PlyNumbers {
 public:
  PlyNumbers(PlyForm form, Words words) : form_(form), words_(words), bytes_(words.rest()) {}

  [[nodiscard]] std::optional<double> next(int size, char kind) {
    return form_ == PlyForm::kText ? nextWord() : nextBytes(static_cast<std::size_t>(size), kind);
  }

 private:
  std::optional<double> nextWord() {
    std::string_view word = words_.next();
    while (word.empty()) {
      if (!words_.nextLine()) return std::nullopt;
      word = words_.next();
    }
    return numberIn<double>(word);
  }
  std::optional<double> nextBytes(std::size_t size, char kind) {
    if (bytes_.size() < size) return std::nullopt;
    std::array<unsigned char, 8> own{};
    for (std::size_t i = 0; i < size; ++i) {
      own[i] = static_cast<unsigned char>(bytes_[form_ == PlyForm::kBig ? size - 1 - i : i]);
    }
    bytes_.remove_prefix(size);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) bits |= static_cast<std::uint64_t>(own[i]) << (8 * i);
    if (kind == 'f') {
      if (size == 8) return std::bit_cast<double>(bits);
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
    const std::uint64_t sign = std::uint64_t{1} << (8 * size - 1);
    if (kind == 'i' && (bits & sign) != 0) return static_cast<double>(bits) - 2.0 * static_cast<double>(sign);
    return static_cast<double>(bits);
  }

  PlyForm form_;
  Words words_;
  std::string_view bytes_;
};

struct PlyHeader {
  PlyForm form = PlyForm::kText;
  std::vector<PlyElement> elements;
};

Result<PlyHeader> readPlyHeader(Words& words) {
  PlyHeader header;
  bool formed = false;
  while (words.nextLine()) {
    const std::string_view kind = words.next();
    if (kind == "end_header") {
      if (!formed) break;
      return header;
    }
    if (kind == "format") {
      const std::string_view form = words.next();
      formed = form == "ascii" || form == "binary_little_endian" || form == "binary_big_endian";
      header.form = form == "ascii" ? PlyForm::kText : form == "binary_big_endian" ? PlyForm::kBig : PlyForm::kLittle;
      if (!formed) return errorAt(words.place(), "expected ascii, binary_little_endian or binary_big_endian");
    } else if (kind == "element") {
      const std::string name(words.next());
      const auto count = numberIn<std::uint64_t>(words.next());
      if (name.empty() || !count || *count > kMostSculptVertices)
        return errorAt(words.place(), "expected a name and a number of elements, at most 8000000");
      header.elements.push_back({name, static_cast<std::size_t>(*count), {}});
    } else if (kind == "property") {
      PlyProperty property;
      std::string_view type = words.next();
      if (type == "list") {
        const auto counted = plyType(words.next());
        if (!counted || counted->second == 'f') return errorAt(words.place(), "expected the type of a list's length");
        property.countSize = counted->first;
        type = words.next();
      }
      const auto typed = plyType(type);
      property.name = std::string(words.next());
      if (!typed || property.name.empty() || header.elements.empty())
        return errorAt(words.place(), "expected the type and the name of an element's property");
      property.size = typed->first;
      property.kind = typed->second;
      header.elements.back().properties.push_back(std::move(property));
    }
  }
  return errorAt("", "expected a .ply header with a format, up to end_header");
}

/// One element's lists and numbers; those that are asked for by name go to `visit(name, values)`.
template <class Visit>
bool readPlyElement(const PlyElement& element, PlyNumbers& numbers, std::vector<double>& values, Visit visit) {
  for (const PlyProperty& property : element.properties) {
    std::size_t count = 1;
    if (property.countSize > 0) {
      const auto length = numbers.next(property.countSize, 'u');
      if (!length || !(*length >= 0.0 && *length <= static_cast<double>(kMostOfPolygon))) return false;
      count = static_cast<std::size_t>(*length);
    }
    values.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = numbers.next(property.size, property.kind);
      if (!value) return false;
      values.push_back(*value);
    }
    if (!visit(property.name, values)) return false;
  }
  return true;
}

Result<SculptSoup> readPly(std::string_view text) {
  Words words(text);
  if (!words.nextLine() || words.next() != "ply") return errorAt("line 1", "expected ply");
  const Result<PlyHeader> header = readPlyHeader(words);
  if (!header) return header.error();
  SculptSoup soup;
  PlyNumbers numbers(header->form, words);
  std::vector<double> values;
  std::vector<std::int64_t> corners;
  for (const PlyElement& element : header->elements) {
    if (element.properties.empty()) continue;
    for (std::size_t i = 0; i < element.count; ++i) {
      glm::dvec3 position(0.0);
      const bool sound = readPlyElement(element, numbers, values, [&](const std::string& name, const auto& list) {
        if (element.name == "vertex" && name.size() == 1 && name[0] >= 'x' && name[0] <= 'z' && list.size() == 1) {
          position[name[0] - 'x'] = list[0];
          return std::abs(list[0]) < static_cast<double>(std::numeric_limits<float>::max());
        }
        if (element.name != "face" || (name != "vertex_indices" && name != "vertex_index")) return true;
        corners.clear();
        for (const double index : list) corners.push_back(index >= 0.0 && index < 4e9 ? std::llround(index) : -1);
        return soup.addPolygon(corners);
      });
      if (!sound)
        return errorAt(element.name + " " + std::to_string(i), "is damaged, or names a vertex that is missing");
      if (element.name == "vertex") soup.positions.emplace_back(position);
    }
  }
  return soup;
}

Result<ControlMesh> weldedSculpt(SculptSoup from) {
  if (from.triangles.empty()) return errorAt("", "expected a surface: the file has no faces");
  TriangleSoup soup;
  const Bounds bounds = boundsOf(from.positions);
  soup.positions = std::move(from.positions);
  soup.uvs.assign(soup.positions.size(), glm::vec2(0.0f));
  soup.influenceBegin.assign(soup.positions.size() + 1, 0);
  soup.triangles = std::move(from.triangles);
  soup.materials.assign(soup.triangles.size(), 0);
  const glm::vec3 extent = bounds.extent();
  ControlMesh mesh = weld(soup, kSculptWeld * std::max({extent.x, extent.y, extent.z}));
  if (mesh.triangles.empty()) return errorAt("", "all triangles have collapsed to lines or points");
  return mesh;
}

/// Of a character only the skin, if its parts say which that is.
Result<ControlMesh> importedSculpt(const std::filesystem::path& file) {
  const auto character = importGltf(file);
  if (!character) return character.error();
  const ControlMesh& mesh = character.value()->mesh;
  const std::vector<SkinLayer> layers = guessLayers(*character.value());
  SculptSoup soup;
  soup.positions = mesh.positions;
  for (const ControlTriangle& triangle : mesh.triangles) {
    if (at(layers, triangle.part) != SkinLayer::kSkin) continue;
    const auto& v = triangle.vertices;
    soup.triangles.push_back(
        {static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]), static_cast<std::uint32_t>(v[2])});
  }
  return weldedSculpt(std::move(soup));
}

}  // namespace

Result<ControlMesh> loadSculpt(const std::filesystem::path& file) {
  const std::string ending = lowerCase(file.extension().string());
  if (ending == ".glb" || ending == ".gltf" || ending == ".vrm") return importedSculpt(file);
  if (ending != ".obj" && ending != ".ply") {
    return Error{file.string(), {}, std::string("expected a sculpt: ") + kSculptEndings};
  }
  const Result<std::string> text = readWholeFile(file, kMostSculptBytes);
  if (!text) return text.error();
  Result<SculptSoup> soup = ending == ".obj" ? readObj(text.value()) : readPly(text.value());
  Result<ControlMesh> mesh = soup ? weldedSculpt(std::move(soup).value()) : Result<ControlMesh>(soup.error());
  if (mesh) return mesh;
  Error error = mesh.error();
  error.file = file.string();
  return error;
}

}  // namespace sinew
