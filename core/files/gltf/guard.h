// core/files/gltf/guard.h: what tinygltf gets to see of a glTF file's JSON.
#pragma once

#include <map>
#include <string>

#include "core/files/gltf/refusal.h"
#include "core/files/json/json.h"

namespace sinew::gltf {

/// JSON that tinygltf reads whole and as it stands: every member is one of rules.h, of its type and in its range;
/// extras, unknown extensions and all that Sinew does not read are gone.
struct Guarded {
  std::string text;
  std::map<std::string, Error> faults;  ///< [JSON path] what is wrong there and stands as a blank in `text`.

  /// Refuses if the element or value at this place is wrong. To be asked before it is used.
  void expectSound(const std::string& place) const {
    if (faults.empty()) return;
    if (const auto fault = faults.find(place); fault != faults.end()) throw Refusal{fault->second};
  }
};

/// Refuses versions of glTF other than 2, wrong members (those something uses), and more elements than fit memory;
/// every refusal names its JSON path.
[[nodiscard]] Guarded guard(const Json& root);

}  // namespace sinew::gltf
