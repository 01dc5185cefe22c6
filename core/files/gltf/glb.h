// core/files/gltf/glb.h: the container of a glTF file; refusals and notes of the import.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <tiny_gltf.h>

#include "sinew/geometry/result.h"

namespace sinew::gltf {

// Extensions, which tinygltf keeps as loose values; the guard has checked their types.

/// Null if absent.
inline const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

inline double looseNumber(const tinygltf::Value& object, const char* key, double fallback) {
  return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

template <std::size_t N>
void looseNumbers(const tinygltf::Value& object, const char* key, std::array<double, N>& out) {
  for (std::size_t i = 0; object.Has(key) && i < N; ++i) {
    out[i] = object.Get(key).Get(static_cast<int>(i)).GetNumberAsDouble();
  }
}

/// Parts of a file that the import does not use, one line each; repeated lines are counted.
class Notes {
 public:
  void add(const std::string& line) {
    if (counts_.size() >= kMaxLines && !counts_.contains(line)) {
      ++beyond_;
      return;
    }
    if (++counts_[line] == 1) order_.push_back(line);
  }

  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> result;
    for (const std::string& line : order_) {
      const int count = counts_.at(line);
      result.push_back(count == 1 ? line : line + " (" + std::to_string(count) + " times)");
    }
    if (beyond_ > 0) result.push_back("and " + std::to_string(beyond_) + " more");
    return result;
  }

 private:
  static constexpr std::size_t kMaxLines = 200;
  std::map<std::string, int> counts_;
  std::vector<std::string> order_;
  int beyond_ = 0;
};

// Refusals.

/// Thrown by the stages of the import; it never leaves core/files.
struct Refusal {
  Error error;
};
/// @param subject  for people who do not know the format
[[noreturn]] inline void refuse(std::string place, std::string reason, std::string subject = {}) {
  throw Refusal{errorAt(std::move(place), std::move(reason), std::move(subject))};
}

/// "nodes[3]": JSON path of an element.
[[nodiscard]] inline std::string placeOf(const std::string& list, std::size_t index) {
  return list + '[' + std::to_string(index) + ']';
}

[[nodiscard]] inline std::string placeOfPrimitive(std::size_t mesh, std::size_t primitive) {
  return placeOf(placeOf("meshes", mesh) + ".primitives", primitive);
}

// Components.

/// Calls use(T{}) with the C++ type of a component type of glTF.
template <class Use>
decltype(auto) withComponent(int type, const Use& use) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return use(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return use(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return use(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return use(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return use(std::uint32_t{});
    default:
      return use(float{});
  }
}

// The container.

using Bytes = std::span<const std::uint8_t>;

struct Container {
  std::string_view json;
  std::optional<Bytes> binary;  ///< Bytes of buffer 0 without a uri.
};

/// The parts of a .glb or a .gltf, distinguished by content. Refuses at the byte.
[[nodiscard]] Container openContainer(Bytes file);

}  // namespace sinew::gltf
