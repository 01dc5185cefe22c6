// core/files/export/gltf_rewrite.cpp: used bytes, references, one buffer, containers, animations.
#include "core/files/export/gltf_rewrite.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>

#include <glm/geometric.hpp>

#include "core/files/gltf/material.h"
#include "core/geometry/at.h"

namespace sinew::exporting {

// Used bytes.

namespace {

constexpr std::uint64_t kAlignment = 4;

struct Shape {
  std::string_view type;
  std::uint64_t components;
};
/// Types without padded columns.
constexpr std::array kShapes{Shape{"SCALAR", 1}, Shape{"VEC2", 2}, Shape{"VEC3", 3}, Shape{"VEC4", 4},
                             Shape{"MAT4", 16}};

std::uint64_t wholeAt(const Json& object, std::string_view name) {
  return static_cast<std::uint64_t>(std::max(object.at(name).number(0.0), 0.0));
}

std::uint64_t componentBytes(std::uint64_t componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

/// 0: unknown.
std::uint64_t elementBytes(const Json& accessor, std::uint64_t componentType) {
  const std::string type = accessor.at("type").text("");
  const auto* const shape = std::ranges::find(kShapes, type, &Shape::type);
  return shape == kShapes.end() ? 0 : shape->components * componentBytes(componentType);
}

/// Used intervals of a view, and their places without the rest: at multiples of 4, in order, to keep numbers aligned.
class UsedBytes {
 public:
  void add(std::uint64_t begin, std::uint64_t end) {
    intervals_.emplace_back(begin / kAlignment * kAlignment, (end + kAlignment - 1) / kAlignment * kAlignment);
  }

  /// Merges the intervals, once all are added. @param length  of the view
  void close(std::uint64_t length) {
    std::ranges::sort(intervals_);
    std::vector<std::pair<std::uint64_t, std::uint64_t>> merged;
    for (const auto& [begin, end] : intervals_) {
      if (!merged.empty() && begin <= merged.back().second) merged.back().second = std::max(merged.back().second, end);
      else merged.emplace_back(begin, end);
    }
    if (!merged.empty()) merged.back().second = std::min(merged.back().second, length);
    intervals_ = std::move(merged);
  }

  /// After close(): in order, with unused bytes between them.
  [[nodiscard]] const std::vector<std::pair<std::uint64_t, std::uint64_t>>& intervals() const { return intervals_; }

  /// Sum of all lengths.
  [[nodiscard]] std::uint64_t length() const {
    std::uint64_t sum = 0;
    for (const auto& [begin, end] : intervals_) sum += end - begin;
    return sum;
  }

  /// New place of a used byte.
  [[nodiscard]] std::uint64_t placeOf(std::uint64_t byte) const {
    std::uint64_t before = 0;
    for (const auto& [begin, end] : intervals_) {
      if (byte < end || end == intervals_.back().second) return before + byte - begin;
      before += end - begin;
    }
    return byte;
  }

 private:
  std::vector<std::pair<std::uint64_t, std::uint64_t>> intervals_;  ///< Begin and end.
};

/// Calls visit(user of a bufferView, bytes used from its byteOffset; 0: unknown) for all accessors and sparse parts.
void visitUses(Json& root, const std::function<void(Json& user, std::uint64_t bytes)>& visit) {
  Json* const accessors = memberOf(root, "accessors");
  if (!accessors) return;
  const std::vector<Json>& views = root.at("bufferViews").items();
  const auto visitOne = [&](Json& user, std::uint64_t count, std::uint64_t element) {
    const Json* const index = user.find("bufferView");
    if (!index) return;
    const double view = index->number(-1.0);
    if (!(view >= 0.0 && view < static_cast<double>(views.size()))) return;
    const std::uint64_t stride = wholeAt(views[static_cast<std::size_t>(view)], "byteStride");
    const bool isKnown = count > 0 && element > 0;
    visit(user, isKnown ? (count - 1) * std::max(stride, element) + element : 0);
  };
  for (Json& accessor : accessors->children) {
    const std::uint64_t element = elementBytes(accessor, wholeAt(accessor, "componentType"));
    visitOne(accessor, wholeAt(accessor, "count"), element);
    Json* const sparse = memberOf(accessor, "sparse");
    if (!sparse) continue;
    const std::uint64_t entries = wholeAt(*sparse, "count");
    if (Json* const indices = memberOf(*sparse, "indices")) {
      visitOne(*indices, entries, componentBytes(wholeAt(*indices, "componentType")));
    }
    if (Json* const values = memberOf(*sparse, "values")) visitOne(*values, entries, element);
  }
}

constexpr std::uint64_t kMostBytes = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kLeastUnused = 16;  ///< Fewer unused bytes of a view are padding, and stay.

/// Beginnings of the names of extensions that use no accessor and no bufferView.
constexpr std::array<std::string_view, 10> kWithoutData{
    "KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_",          "KHR_mesh_quantization", "VRM",
    "KHR_xmp",        "KHR_node_",    "MSFT_lod",     "KHR_animation_pointer"};

bool isWithoutData(const std::string& extension) {
  return std::ranges::any_of(kWithoutData, [&](std::string_view known) { return extension.starts_with(known); });
}

/// Calls visit(Json& number) for every index of an accessor.
void visitAccessors(Json& root, const std::function<void(Json&)>& visit) {
  const auto visitMember = [&](Json& object, std::string_view name) {
    if (Json* index = memberOf(object, name)) visit(*index);
  };
  const auto visitAll = [&](Json* object) {
    if (!object) return;
    for (Json& child : object->children) visit(child);
  };
  const auto each = [](Json& object, std::string_view list, const std::function<void(Json&)>& use) {
    if (Json* items = memberOf(object, list)) std::ranges::for_each(items->children, use);
  };
  each(root, "meshes", [&](Json& mesh) {
    each(mesh, "primitives", [&](Json& primitive) {
      visitAll(memberOf(primitive, "attributes"));
      visitMember(primitive, "indices");
      each(primitive, "targets", [&](Json& target) { visitAll(&target); });
    });
  });
  each(root, "skins", [&](Json& skin) { visitMember(skin, "inverseBindMatrices"); });
  each(root, "animations", [&](Json& animation) {
    each(animation, "samplers", [&](Json& sampler) {
      visitMember(sampler, "input");
      visitMember(sampler, "output");
    });
  });
}

/// The same for indices of bufferViews.
void visitViews(Json& root, const std::function<void(Json&)>& visit) {
  const auto visitIn = [&](Json* object) {
    if (Json* index = object ? memberOf(*object, "bufferView") : nullptr) visit(*index);
  };
  if (Json* accessors = memberOf(root, "accessors")) {
    for (Json& accessor : accessors->children) {
      visitIn(&accessor);
      if (Json* sparse = memberOf(accessor, "sparse")) {
        visitIn(memberOf(*sparse, "indices"));
        visitIn(memberOf(*sparse, "values"));
      }
    }
  }
  if (Json* images = memberOf(root, "images")) {
    for (Json& image : images->children) visitIn(&image);
  }
}

/// [bufferViews] used intervals of partly used views, empty for whole ones; moves accessors to their new places.
std::vector<UsedBytes> findUsedBytes(Json& root) {
  const std::vector<Json>& views = root.at("bufferViews").items();
  std::vector<UsedBytes> used(views.size());
  std::vector<bool> isWhole(views.size(), false);
  const auto viewOf = [](const Json& user) { return static_cast<std::size_t>(user.at("bufferView").number(0.0)); };
  for (const Json& image : root.at("images").items()) {
    if (image.find("bufferView") && viewOf(image) < views.size()) isWhole[viewOf(image)] = true;
  }
  visitUses(root, [&](Json& user, std::uint64_t bytes) {
    const double begin = user.at("byteOffset").number(0.0);
    const double length = views[viewOf(user)].at("byteLength").number(0.0);
    if (bytes == 0 || begin + static_cast<double>(bytes) > length) isWhole[viewOf(user)] = true;
    else used[viewOf(user)].add(static_cast<std::uint64_t>(begin), static_cast<std::uint64_t>(begin) + bytes);
  });
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto length = static_cast<std::uint64_t>(views[i].at("byteLength").number(0.0));
    used[i].close(length);
    if (isWhole[i] || used[i].length() + kLeastUnused > length) used[i] = {};
  }
  visitUses(root, [&](Json& user, std::uint64_t) {
    const UsedBytes& own = used[viewOf(user)];
    if (own.intervals().empty()) return;
    const auto begin = static_cast<std::uint64_t>(user.at("byteOffset").number(0.0));
    if (own.placeOf(begin) != begin) user.set("byteOffset", static_cast<long long>(own.placeOf(begin)));
  });
  return used;
}

using Visit = void (*)(Json&, const std::function<void(Json&)>&);

/// Removes unreferenced elements of a list, and renumbers the references.
void keepReferenced(Json& root, std::string_view list, Visit visitAll, const std::function<void(std::size_t)>& kept) {
  Json* items = memberOf(root, list);
  if (!items) return;
  std::vector<bool> used(items->children.size(), false);
  const auto inList = [&](const Json& index) {
    const double number = index.number(-1.0);
    return number >= 0.0 && number < static_cast<double>(used.size());
  };
  visitAll(root, [&](Json& index) {
    if (inList(index)) used[static_cast<std::size_t>(index.number(0.0))] = true;
  });
  std::vector<long long> place(used.size(), 0);
  std::vector<Json> remaining;
  for (std::size_t i = 0; i < used.size(); ++i) {
    place[i] = static_cast<long long>(remaining.size());
    if (!used[i]) continue;
    remaining.push_back(std::move(items->children[i]));
    kept(i);
  }
  items->children = std::move(remaining);
  visitAll(root, [&](Json& index) {
    if (!inList(index)) return;
    std::string key = std::move(index.key);
    index = place[static_cast<std::size_t>(index.number(0.0))];
    index.key = std::move(key);
  });
}

/// "" for an unknown kind.
std::string mimeTypeOf(gltf::Bytes bytes) {
  if (startsWith(bytes, "\x89PNG")) return "image/png";
  if (startsWith(bytes, "\xff\xd8\xff")) return "image/jpeg";
  if (isWebp(bytes)) return "image/webp";
  if (startsWith(bytes, "\xabKTX 20")) return "image/ktx2";
  return {};
}

void appendNumber(std::string& out, std::size_t value) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

void align(std::string& bytes, char with) { bytes.append((4 - bytes.size() % 4) % 4, with); }

std::string percentEncode(const std::string& name) {
  static constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~").find(c) != std::string_view::npos;
    if (plain) result += c;
    else result += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
  }
  return result;
}

}  // namespace

Json* memberOf(Json& object, std::string_view name) {
  if (object.kind != Json::Kind::kObject) return nullptr;
  const auto found = std::ranges::find(object.children, name, &Json::key);
  return found == object.children.end() ? nullptr : &*found;
}

Json& ensureMember(Json& object, std::string_view name, const Json& empty) {
  if (!memberOf(object, name)) object.set(std::string(name), empty);
  return *memberOf(object, name);
}

Json numbersOf(const glm::dvec3& values) { return Json::array({values.x, values.y, values.z}); }

Json numbersOf(const std::vector<float>& values) { return Json::array({values.begin(), values.end()}); }

void removeMember(Json& object, std::string_view name) {
  std::erase_if(object.children, [&](const Json& child) { return child.key == name; });
}

Json& GltfRewrite::element(std::string_view list, int index) { return at(memberOf(root_, list)->children, index); }

int GltfRewrite::append(std::string_view list, Json element) {
  Json& items = ensureMember(root_, list, Json::array());
  items.push(std::move(element));
  return static_cast<int>(items.children.size()) - 1;
}

int GltfRewrite::addView(std::string_view bytes, int target) {
  added_.emplace_back(bytes);
  Json view = Json::object();
  view.set("buffer", 0).set("byteOffset", 0).set("byteLength", static_cast<long long>(bytes.size()));
  if (target != 0) view.set("target", target);
  return append("bufferViews", std::move(view));
}

int GltfRewrite::addAccessor(const AccessorData& data) {
  Json accessor = Json::object();
  accessor.set("bufferView", addView(data.bytes, data.target)).set("componentType", data.componentType);
  accessor.set("count", static_cast<long long>(data.count)).set("type", data.type);
  if (data.bounds) accessor.set("min", numbersOf(data.bounds->low)).set("max", numbersOf(data.bounds->high));
  return append("accessors", std::move(accessor));
}

/// Images that cannot be read stay references.
void GltfRewrite::takeImages() {
  Json* images = memberOf(root_, "images");
  if (!images) return;
  for (std::size_t i = 0; i < images->children.size(); ++i) {
    const Json* uri = images->children[i].find("uri");
    if (!uri) continue;
    const Result<gltf::EncodedImage> encoded = file_.encodedImage(i);
    const std::string mimeType = encoded ? mimeTypeOf(encoded->bytes) : std::string();
    if (mimeType.empty()) continue;
    const std::string_view bytes(reinterpret_cast<const char*>(encoded->bytes.data()), encoded->bytes.size());
    const int view = addView(bytes, 0);
    Json& image = images->children[i];
    removeMember(image, "uri");
    image.set("bufferView", view).set("mimeType", mimeType);
  }
}

void GltfRewrite::dropUnused() {
  const std::size_t own = file_.model().bufferViews.size();
  const Json& extensions = root_.at("extensionsUsed");
  const bool known =
      std::ranges::all_of(extensions.items(), [](const Json& name) { return isWithoutData(name.content); });
  std::vector<std::size_t> views;
  if (known) {
    keepReferenced(root_, "accessors", visitAccessors, [](std::size_t) {});
    keepReferenced(root_, "bufferViews", visitViews, [&](std::size_t view) { views.push_back(view); });
  } else {
    for (std::size_t view = 0; view < root_.at("bufferViews").items().size(); ++view) views.push_back(view);
  }
  const std::vector<UsedBytes> used = known ? findUsedBytes(root_) : std::vector<UsedBytes>(views.size());
  Json* list = memberOf(root_, "bufferViews");
  for (std::size_t i = 0; i < views.size(); ++i) {
    Json& view = list->children[i];
    align(binary_, '\0');
    view.set("buffer", 0).set("byteOffset", static_cast<long long>(binary_.size()));
    std::string_view bytes;
    if (views[i] >= own) {
      bytes = added_[views[i] - own];
    } else {
      const gltf::Bytes all = file_.bufferView(views[i]);
      const double length = view.at("byteLength").number(0.0);  // shortened for unused views
      bytes = {reinterpret_cast<const char*>(all.data()), std::min(all.size(), static_cast<std::size_t>(length))};
    }
    if (used[i].intervals().empty()) binary_ += bytes;
    for (const auto& [begin, end] : used[i].intervals()) binary_ += bytes.substr(begin, end - begin);
    if (!used[i].intervals().empty()) view.set("byteLength", static_cast<long long>(used[i].length()));
    if (views[i] >= own) added_[views[i] - own] = {};
  }
  align(binary_, '\0');
}

PackedGltf GltfRewrite::pack() && {
  takeImages();
  dropUnused();
  for (const char* list : {"accessors", "bufferViews"}) {
    if (root_.at(list).items().empty()) removeMember(root_, list);
  }
  Json buffer = Json::object();
  buffer.set("byteLength", static_cast<long long>(binary_.size()));
  root_.set("buffers", Json::array({std::move(buffer)}));
  return {std::move(root_), std::move(binary_)};
}

Result<std::string> glbOf(const PackedGltf& packed) {
  std::string json = packed.root.dump();
  align(json, ' ');
  const std::uint64_t size = 12 + 8 + json.size() + 8 + packed.binary.size();
  if (size > kMostBytes) {
    return errorAt({}, "the character needs " + std::to_string(size) +
                           " bytes, a .glb holds at most 4 GiB; choose a smaller depth");
  }
  std::string file = "glTF";
  file.reserve(size);
  appendNumber(file, 2);
  appendNumber(file, size);
  appendNumber(file, json.size());
  file += "JSON";
  file += json;
  appendNumber(file, packed.binary.size());
  file += std::string_view("BIN\0", 4);
  file += packed.binary;
  return file;
}

std::string gltfOf(const PackedGltf& packed, const std::string& binaryName) {
  Json root = packed.root;
  memberOf(root, "buffers")->children.front().set("uri", percentEncode(binaryName));
  return root.dump(true) + '\n';
}

// Animations.

std::string clipName(const Json& clip, int index) {
  const std::string name = clip.at("name").text("");
  return name.empty() ? "clip " + std::to_string(index) : name;
}

namespace {

constexpr float kUnitWithin = 1e-5f;

const char* wordFor(Interpolation interpolation) {
  if (interpolation == Interpolation::kStep) return "STEP";
  return interpolation == Interpolation::kCubicSpline ? "CUBICSPLINE" : "LINEAR";
}

const char* wordFor(ChannelPath path) {
  if (path == ChannelPath::kRotation) return "rotation";
  return path == ChannelPath::kScale ? "scale" : "translation";
}

int addKeys(int clip, const std::vector<float>& times, Interpolation interpolation, const AccessorData& values,
            GltfRewrite& rewrite) {
  const int input = addTimes(times, rewrite);
  const int sampler = addSampler(clip, input, rewrite.addAccessor(values), rewrite);
  Json& samplers = *memberOf(rewrite.element("animations", clip), "samplers");
  at(samplers.children, sampler).set("interpolation", wordFor(interpolation));
  return sampler;
}

/// Normalizes rotations, as glTF requires, but not tangents.
std::vector<float> fileValues(const Channel& channel) {
  const bool turns = channel.path == ChannelPath::kRotation;
  const bool cubic = channel.interpolation == Interpolation::kCubicSpline;
  std::vector<float> values;
  for (std::size_t i = 0; i < channel.values.size(); ++i) {
    glm::vec4 value = channel.values[i];
    const float length = glm::length(value);
    const bool isValue = !cubic || i % 3 == 1;
    if (turns && isValue && length > 0.0f && std::abs(length - 1.0f) > kUnitWithin) value /= length;
    for (int c = 0; c < (turns ? 4 : 3); ++c) values.push_back(value[c]);
  }
  return values;
}

}  // namespace

void addClip(const AnimationClip& clip, std::span<const int> fileNode, std::span<const MorphTarget> targets,
             GltfRewrite& rewrite) {
  Json made = Json::object();
  made.set("name", clip.name).set("samplers", Json::array()).set("channels", Json::array());
  const int index = rewrite.append("animations", std::move(made));
  for (const Channel& channel : clip.channels) {
    const std::vector<float> values = fileValues(channel);
    const char* const type = channel.path == ChannelPath::kRotation ? "VEC4" : "VEC3";
    const AccessorData data{bytesOf(values), TINYGLTF_COMPONENT_TYPE_FLOAT, type, channel.values.size()};
    const int sampler = addKeys(index, channel.times, channel.interpolation, data, rewrite);
    addChannel(index, sampler, at(fileNode, channel.node), wordFor(channel.path), rewrite);
  }
  for (const MorphChannel& channel : clip.morphChannels) {
    const AccessorData data{bytesOf(channel.values), TINYGLTF_COMPONENT_TYPE_FLOAT, "SCALAR", channel.values.size()};
    const int sampler = addKeys(index, channel.times, channel.interpolation, data, rewrite);
    addChannel(index, sampler, at(targets, channel.firstTarget).node, "weights", rewrite);
  }
}

int addTimes(const std::vector<float>& times, GltfRewrite& rewrite) {
  const int input = rewrite.addAccessor({bytesOf(times), TINYGLTF_COMPONENT_TYPE_FLOAT, "SCALAR", times.size()});
  rewrite.element("accessors", input)
      .set("min", Json::array({static_cast<double>(times.front())}))
      .set("max", Json::array({static_cast<double>(times.back())}));
  return input;
}

int addSampler(int clip, int input, int output, GltfRewrite& rewrite) {
  Json sampler = Json::object();
  sampler.set("input", input).set("interpolation", "LINEAR").set("output", output);
  Json& samplers = *memberOf(rewrite.element("animations", clip), "samplers");
  samplers.push(std::move(sampler));
  return static_cast<int>(samplers.children.size()) - 1;
}

int addWeightSampler(int clip, const std::vector<float>& times, const std::vector<float>& weights,
                     GltfRewrite& rewrite) {
  const int input = addTimes(times, rewrite);
  const int output = rewrite.addAccessor({bytesOf(weights), TINYGLTF_COMPONENT_TYPE_FLOAT, "SCALAR", weights.size()});
  return addSampler(clip, input, output, rewrite);
}

void addChannel(int clip, int sampler, int node, const char* path, GltfRewrite& rewrite) {
  Json channel = Json::object();
  channel.set("sampler", sampler).set("target", Json::object().set("node", node).set("path", path));
  memberOf(rewrite.element("animations", clip), "channels")->push(std::move(channel));
}

}  // namespace sinew::exporting
