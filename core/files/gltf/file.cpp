// core/files/gltf/file.cpp: container -> guard -> tinygltf -> buffers, compressed parts and images.
#include "core/files/gltf/file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/files/disk/atomic_file.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"

namespace sinew::gltf {

// VRM, read tolerantly: the mesh does not need it.

namespace {

constexpr double kPercent = 100.0;  ///< Weights of 0.x.
constexpr double kMostShare = 100.0;

int indexIn(const Json& value) {
  const double number = value.number(-1.0);
  const bool whole = number >= 0.0 && number < 1e9 && number == std::floor(number);
  return whole ? static_cast<int>(number) : -1;
}

float shareOf(const Json& value, double unit) {
  return static_cast<float>(std::clamp(value.number(unit) / unit, -kMostShare, kMostShare));
}

/// VRM 1.0: objects by name.
void readNew(const Json& vrm, Vrm& out) {
  for (const Json& bone : vrm.at("humanoid").at("humanBones").children) {
    if (bone.kind == Json::Kind::kObject) out.bones.push_back({bone.key, indexIn(bone.at("node"))});
  }
  for (const char* list : {"preset", "custom"}) {
    for (const Json& expression : vrm.at("expressions").at(list).children) {
      if (expression.kind != Json::Kind::kObject) continue;
      Vrm::Expression& made = out.expressions.emplace_back();
      made.name = expression.key;
      for (const Json& bind : expression.at("morphTargetBinds").items()) {
        made.binds.push_back(
            {indexIn(bind.at("node")), -1, indexIn(bind.at("index")), shareOf(bind.at("weight"), 1.0)});
      }
    }
  }
}

/// VRM 0.x: lists; weights in per cent, of meshes.
void readOld(const Json& vrm, Vrm& out) {
  for (const Json& bone : vrm.at("humanoid").at("humanBones").items()) {
    out.bones.push_back({bone.at("bone").text(""), indexIn(bone.at("node"))});
  }
  for (const Json& group : vrm.at("blendShapeMaster").at("blendShapeGroups").items()) {
    Vrm::Expression& made = out.expressions.emplace_back();
    made.name = group.at("name").text("");
    if (made.name.empty()) made.name = group.at("presetName").text("");
    for (const Json& bind : group.at("binds").items()) {
      made.binds.push_back(
          {-1, indexIn(bind.at("mesh")), indexIn(bind.at("index")), shareOf(bind.at("weight"), kPercent)});
    }
  }
}

/// Leaves out invalid parts.
Vrm readVrm(const Json& root) {
  Vrm vrm;
  const Json& extensions = root.at("extensions");
  if (extensions.at("VRMC_vrm").kind == Json::Kind::kObject) readNew(extensions.at("VRMC_vrm"), vrm);
  else if (extensions.at("VRM").kind == Json::Kind::kObject) readOld(extensions.at("VRM"), vrm);
  return vrm;
}

// Uris and the folder rule.

namespace fs = std::filesystem;

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// nullopt: a % without two hexadecimal digits.
std::optional<std::string> percentDecoded(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      result += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const int high = hexDigit(text[i + 1]);
    const int low = hexDigit(text[i + 2]);
    if (high < 0 || low < 0) return std::nullopt;
    result += static_cast<char>(16 * high + low);
    i += 2;
  }
  return result;
}

std::array<std::int8_t, 256> base64Values() {
  std::array<std::int8_t, 256> values;
  values.fill(-1);
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::int8_t>(i);
  }
  return values;
}

/// nullopt: characters outside the alphabet or an impossible length; padding may be missing.
std::optional<std::vector<std::uint8_t>> base64Decoded(std::string_view text) {
  static const std::array<std::int8_t, 256> kValues = base64Values();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::uint8_t> result;
  result.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = kValues[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xffffff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    result.push_back(static_cast<std::uint8_t>(bits >> count & 0xff));
  }
  return result;
}

bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0 || std::isalpha(static_cast<unsigned char>(uri[0])) == 0)
    return false;
  return std::ranges::all_of(uri.substr(0, colon), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
  });
}

/// The bytes of a data: uri, base64 or percent-encoded. Error: reason only.
Result<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return errorAt("", "a data: uri without a comma");
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) {
    std::optional<std::vector<std::uint8_t>> bytes = base64Decoded(data);
    if (!bytes) return errorAt("", "a data: uri that is not base64");
    return std::move(*bytes);
  }
  const std::optional<std::string> text = percentDecoded(data);
  if (!text) return errorAt("", "a data: uri with a bad % sequence");
  return std::vector<std::uint8_t>(text->begin(), text->end());
}

}  // namespace

bool isDataUri(std::string_view uri) {
  constexpr std::string_view kScheme = "data:";
  return uri.size() >= kScheme.size() && std::ranges::equal(uri.substr(0, kScheme.size()), kScheme, {}, toLower);
}

Result<fs::path> relativePathOf(std::string_view uri) {
  const auto refused = [](const char* why) {
    return errorAt("", std::string("only data: uris and files in this file's own folder may be read; this one ") + why);
  };
  const std::optional<std::string> decoded = percentDecoded(uri);
  if (!decoded) return refused("has a bad % sequence");
  if (decoded->empty()) return refused("is empty");
  if (hasScheme(uri) || hasScheme(*decoded)) return refused("has a scheme");
  for (const char c : *decoded) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return refused("has a control character");
    if (c == '\\') return refused("has a backslash");
  }
  const fs::path path(*decoded);
  if (path.is_absolute() || path.has_root_path()) return refused("is an absolute path");
  for (const fs::path& part : path) {
    if (part == "..") return refused("has \"..\" in it");
  }
  return path;
}

std::optional<fs::path> placeInside(const fs::path& folder, const fs::path& relative) {
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) return std::nullopt;
  const fs::path target = fs::canonical(root / relative, error);
  if (error) return std::nullopt;
  const auto [rootEnd, targetEnd] = std::ranges::mismatch(root, target);
  return rootEnd == root.end() ? std::optional(target) : std::nullopt;
}

// The file.

namespace {

/// Far above any character; protects the memory from a wrong file.
constexpr std::uintmax_t kMaxFileBytes = 1ULL << 30;
constexpr std::uint64_t kMaxStride = 65536;
constexpr int kMaxNesting = 200;  ///< Files need about ten levels; extras may have more.

/// Checks even unused ones: a file that refers outside its folder is not trusted.
void checkUris(const Json& root) {
  for (const char* list : {"buffers", "images"}) {
    std::size_t i = 0;
    for (const Json& item : root.at(list).items()) {
      const std::string place = placeOf(list, i++) + ".uri";
      const Json* uri = item.find("uri");
      if (!uri || uri->kind != Json::Kind::kString || isDataUri(uri->content)) continue;
      const Result<fs::path> path = relativePathOf(uri->content);
      if (!path) refuse(place, path.error().reason);
    }
  }
}

/// A sound index; -1 for absent and faulty ones.
int soundIndex(const Json& index, std::size_t size) {
  const double value = index.number(-1.0);
  return value >= 0.0 && value < static_cast<double>(size) ? static_cast<int>(value) : -1;
}

/// A path for an error, shortened if it is too long to be one, such as a damaged data: uri.
std::string readable(const fs::path& folder, const fs::path& relative) {
  constexpr std::size_t kLongestName = 255;
  return relative.native().size() <= kLongestName ? (folder / relative).string() : shortened(relative.string());
}

std::uint64_t wholeOf(const Json& value) { return static_cast<std::uint64_t>(value.number(0.0)); }

}  // namespace

std::vector<std::uint8_t> contentsOf(const fs::path& path) {
  Result<std::vector<std::uint8_t>> contents = readWholeBytes(path, kMaxFileBytes);
  if (!contents) throw Refusal{contents.error()};
  return std::move(contents).value();
}

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

Json parseJson(std::string_view text, std::string_view leftOut, std::string_view keptIn) {
  Result<Json> root = Json::parse(text, {.depth = kMaxNesting, .leftOut = leftOut, .keptIn = keptIn});
  if (!root) throw Refusal{root.error()};
  if (root->kind != Json::Kind::kObject) refuse("JSON", "a glTF file must be a JSON object");
  return std::move(root).value();
}

File::File(const fs::path& path) : File(contentsOf(path), folderOf(path)) {}

File::File(std::vector<std::uint8_t> contents, fs::path folder) : folder_(std::move(folder)) {
  const Container container = openContainer(contents);
  const Json root = parseJson(container.json, "extras", "meshes");
  guarded_ = guard(root);
  checkUris(root);
  parse(guarded_.text);
  guarded_.text = {};
  adopt(root);
  openBuffers(root.at("buffers"), std::move(contents), container);
  checkViews();
  const auto range = [this](std::size_t buffer, std::uint64_t offset, std::uint64_t size, const std::string& place) {
    const Bytes bytes = bytesOf(buffer);
    if (offset > bytes.size() || size > bytes.size() - offset) {
      refuse(place, "bytes " + std::to_string(offset) + " to " + std::to_string(offset + size) +
                        " reach beyond the buffer's " + std::to_string(bytes.size()));
    }
    return bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
  };
  unpacked_ = unpack(root, guarded_, range, model_);
}

void File::parse(const std::string& text) {
  tinygltf::TinyGLTF reader;
  // The text names no file and no image; tinygltf could not read one either.
  reader.SetFsCallbacks({});
  reader.SetImageLoader(nullptr, nullptr);
  std::string errors;
  std::string warnings;
  if (reader.LoadASCIIFromString(&model_, &errors, &warnings, text.data(), static_cast<unsigned>(text.size()), "")) {
    return;
  }
  refuse("JSON", "cannot be read: " + shortened(errors));
}

/// Adds what the guard kept from tinygltf, which refuses strides beyond 252 and indices without a bufferView, reads
/// every image, and drops some cameras and lights.
void File::adopt(const Json& root) {
  const std::vector<Json>& views = root.at("bufferViews").items();
  for (std::size_t i = 0; i < model_.bufferViews.size(); ++i) {
    const std::uint64_t stride = wholeOf(views[i].at("byteStride"));
    if (stride > kMaxStride) refuse(placeOf("bufferViews", i) + ".byteStride", "larger than 65536");
    model_.bufferViews[i].byteStride = static_cast<std::size_t>(stride);
  }
  const std::vector<Json>& meshes = root.at("meshes").items();
  for (std::size_t m = 0; m < model_.meshes.size(); ++m) {
    std::vector<std::string>& names = targetNames_.emplace_back();
    for (const Json& name : meshes[m].at("extras").at("targetNames").items()) names.push_back(name.text(""));
    const std::vector<Json>& primitives = meshes[m].at("primitives").items();
    for (std::size_t p = 0; p < model_.meshes[m].primitives.size(); ++p) {
      model_.meshes[m].primitives[p].indices = soundIndex(primitives[p].at("indices"), model_.accessors.size());
    }
  }
  for (const Json& image : root.at("images").items()) {
    tinygltf::Image& kept = model_.images.emplace_back();
    kept.name = image.at("name").text("");
    kept.uri = image.at("uri").text("");
    kept.bufferView = soundIndex(image.at("bufferView"), model_.bufferViews.size());
  }
  vrm_ = readVrm(root);
  cameras_ = root.at("cameras").items().size();
  lights_ = root.at("extensions").at("KHR_lights_punctual").at("lights").items().size();
}

/// tinygltf accepts only seven kinds of data: uris and faulty base64, reads "+" as a space, and refuses files longer
/// than byteLength, empty buffers, and unused buffers without bytes.
void File::openBuffers(const Json& list, std::vector<std::uint8_t> file, const Container& container) {
  const std::size_t binaryAt = container.binary ? static_cast<std::size_t>(container.binary->data() - file.data()) : 0;
  const std::size_t binarySize = container.binary ? container.binary->size() : 0;
  if (!container.binary) file = {};
  for (std::size_t i = 0; i < list.items().size(); ++i) {
    const Json& buffer = list.items()[i];
    const Json* uri = isFallback(buffer) ? nullptr : buffer.find("uri");
    std::vector<std::uint8_t> bytes;
    if (uri) {
      Result<std::vector<std::uint8_t>> found = read(uri->content, placeOf("buffers", i) + ".uri");
      if (!found) refuse(placeOf("buffers", i) + ".uri", found.error().reason, "needs another file");
      bytes = std::move(found).value();
    } else if (i == 0 && container.binary) {
      // In place: a copy of the largest file would be a gigabyte.
      file.resize(binaryAt + binarySize);
      file.erase(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(binaryAt));
      bytes = std::move(file);
    }
    // A buffer without bytes is allowed, for extensions; reading from it is an error.
    hasBytes_.push_back(uri || (i == 0 && container.binary));
    const std::uint64_t length = wholeOf(buffer.at("byteLength"));
    if (hasBytes_.back() && bytes.size() < length) {
      refuse(placeOf("buffers", i),
             "promises " + std::to_string(length) + " bytes but has " + std::to_string(bytes.size()));
    }
    if (hasBytes_.back()) bytes.resize(static_cast<std::size_t>(length));
    model_.buffers.emplace_back().data = std::move(bytes);
  }
}

void File::checkViews() const {
  for (std::size_t i = 0; i < model_.bufferViews.size(); ++i) {
    const tinygltf::BufferView& view = model_.bufferViews[i];
    const auto buffer = toIndex(view.buffer);
    const std::size_t available = model_.buffers[buffer].data.size();
    if (hasBytes_[buffer] && (view.byteOffset > available || view.byteLength > available - view.byteOffset)) {
      refuse(placeOf("bufferViews", i), "bytes " + std::to_string(view.byteOffset) + " to " +
                                            std::to_string(view.byteOffset + view.byteLength) +
                                            " reach beyond the buffer's " + std::to_string(available));
    }
  }
}

Bytes File::bytesOf(std::size_t buffer) const {
  if (!hasBytes_[buffer]) refuse(placeOf("buffers", buffer), "has no uri and the file holds no bytes for it");
  return model_.buffers[buffer].data;
}

Bytes File::bufferView(std::size_t index) const {
  if (const auto own = unpacked_.views.find(index); own != unpacked_.views.end()) return own->second;
  const tinygltf::BufferView& view = model_.bufferViews[index];
  return bytesOf(toIndex(view.buffer)).subspan(view.byteOffset, view.byteLength);
}

Result<EncodedImage> File::encodedImage(std::size_t index) {
  const std::string place = placeOf("images", index);
  expectSound(place);
  const tinygltf::Image& image = model_.images[index];
  if (image.bufferView >= 0) return EncodedImage{bufferView(toIndex(image.bufferView)), {}};
  if (image.uri.empty()) return errorAt("", "has neither uri nor bufferView");
  Result<std::vector<std::uint8_t>> bytes = read(image.uri, place + ".uri");
  if (!bytes) return bytes.error();
  EncodedImage result{{}, std::move(bytes).value()};
  result.bytes = result.own;
  return result;
}

Result<std::vector<std::uint8_t>> File::read(const std::string& uri, const std::string& place) {
  return isDataUri(uri) ? decodeDataUri(uri) : readSibling(uri, place);
}

Result<std::vector<std::uint8_t>> File::readSibling(const std::string& uri, const std::string& place) {
  const Result<fs::path> relative = relativePathOf(uri);
  if (!relative) refuse(place, relative.error().reason);
  std::error_code error;
  const fs::path asked = folder_ / relative.value();
  const std::optional<fs::path> found = placeInside(folder_, relative.value());
  if (!found && fs::exists(asked, error)) refuse(place, "leads out of this file's own folder");
  if (!found || !fs::is_regular_file(*found, error))
    return errorAt("", "there is no file " + readable(folder_, relative.value()));
  Result<std::vector<std::uint8_t>> bytes = readWholeBytes(*found, kMaxFileBytes - siblingBytes_);
  if (!bytes) return errorAt("", bytes.error().reason + " (" + readable(folder_, relative.value()) + ")");
  siblingBytes_ += bytes->size();
  return bytes;
}

}  // namespace sinew::gltf
