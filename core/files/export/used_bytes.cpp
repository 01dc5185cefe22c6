// core/files/export/used_bytes.cpp: stretches merged; the bytes of accessors by their types.
#include "core/files/export/used_bytes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/files/gltf/file.h"

namespace sinew::exporting {
namespace {

constexpr std::uint64_t kAlignment = 4;

struct Shape {
  std::string_view type;
  std::uint64_t components;
};
/// Those whose columns are never padded.
constexpr std::array kShapes{Shape{"SCALAR", 1}, Shape{"VEC2", 2}, Shape{"VEC3", 3}, Shape{"VEC4", 4},
                             Shape{"MAT4", 16}};

Json* memberIn(Json& object, std::string_view name) {
  const auto found = std::ranges::find(object.children, name, &Json::key);
  return found == object.children.end() ? nullptr : &*found;
}

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

/// 0: it is not known.
std::uint64_t elementBytes(const Json& accessor, std::uint64_t componentType) {
  const std::string type = accessor.at("type").text("");
  const auto* const shape = std::ranges::find(kShapes, type, &Shape::type);
  return shape == kShapes.end() ? 0 : shape->components * componentBytes(componentType);
}

}  // namespace

void UsedBytes::add(std::uint64_t begin, std::uint64_t end) {
  stretches_.emplace_back(begin / kAlignment * kAlignment, (end + kAlignment - 1) / kAlignment * kAlignment);
}

void UsedBytes::close(std::uint64_t length) {
  std::ranges::sort(stretches_);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> merged;
  for (const auto& [begin, end] : stretches_) {
    if (!merged.empty() && begin <= merged.back().second) merged.back().second = std::max(merged.back().second, end);
    else merged.emplace_back(begin, end);
  }
  if (!merged.empty()) merged.back().second = std::min(merged.back().second, length);
  stretches_ = std::move(merged);
}

std::uint64_t UsedBytes::length() const {
  std::uint64_t sum = 0;
  for (const auto& [begin, end] : stretches_) sum += end - begin;
  return sum;
}

std::uint64_t UsedBytes::placeOf(std::uint64_t byte) const {
  std::uint64_t before = 0;
  for (const auto& [begin, end] : stretches_) {
    if (byte < end || end == stretches_.back().second) return before + byte - begin;
    before += end - begin;
  }
  return byte;
}

void visitUses(Json& root, const std::function<void(Json& user, std::uint64_t bytes)>& visit) {
  Json* const accessors = memberIn(root, "accessors");
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
    Json* const sparse = memberIn(accessor, "sparse");
    if (!sparse) continue;
    const std::uint64_t entries = wholeAt(*sparse, "count");
    if (Json* const indices = memberIn(*sparse, "indices")) {
      visitOne(*indices, entries, componentBytes(wholeAt(*indices, "componentType")));
    }
    if (Json* const values = memberIn(*sparse, "values")) visitOne(*values, entries, element);
  }
}

}  // namespace sinew::exporting
