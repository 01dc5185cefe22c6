// core/files/gltf/guard.h: checks a glTF file's JSON before tinygltf reads it.
#pragma once

#include <map>
#include <string>

#include "core/files/gltf/glb.h"
#include "core/files/json/json.h"

namespace sinew::gltf {

/// JSON for tinygltf: every member is one of rules.h, of its type and in its range; everything else is removed.
struct Guarded {
  std::string text;
  std::map<std::string, Error> faults;  ///< [JSON path] errors; `text` has a placeholder there.

  /// Refuses a faulty element or value. Call before using it.
  void expectSound(const std::string& place) const {
    if (faults.empty()) return;
    if (const auto fault = faults.find(place); fault != faults.end()) throw Refusal{fault->second};
  }
};

/// Refuses versions other than 2, wrong members in use, and too many elements, with the JSON path.
[[nodiscard]] Guarded guard(const Json& root);

}  // namespace sinew::gltf
