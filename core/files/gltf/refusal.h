// core/files/gltf/refusal.h: how the stages of the import give up.
#pragma once

#include <string>
#include <utility>

#include "sinew/geometry/result.h"

namespace sinew::gltf {

/// importGltf turns it into a Result; it never leaves core/files.
struct Refusal {
  Error error;
};
/// @param subject  what it is about, where the reason is one that people understand who do not know the format
[[noreturn]] inline void refuse(std::string place, std::string reason, std::string subject = {}) {
  throw Refusal{errorAt(std::move(place), std::move(reason), std::move(subject))};
}

/// "nodes[3]", the JSON path of an element.
[[nodiscard]] inline std::string placeOf(const std::string& list, std::size_t index) {
  return list + '[' + std::to_string(index) + ']';
}

}  // namespace sinew::gltf
