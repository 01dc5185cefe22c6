// core/files/gltf/vrm.h: the humanoid bones and expressions of .vrm files, 1.0 (VRMC_vrm) and 0.x (VRM).
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"

namespace sinew::gltf {

/// As the file has them; nothing is checked but that numbers are indices.
struct Vrm {
  struct HumanBone {
    std::string name;  ///< "leftUpperArm"
    int node = -1;
  };
  struct Bind {
    int node = -1;  ///< 1.0
    int mesh = -1;  ///< 0.x: of all nodes that show it.
    int target = 0;
    float weight = 1.0f;
  };
  struct Expression {
    std::string name;
    std::vector<Bind> binds;
  };
  std::vector<HumanBone> bones;
  std::vector<Expression> expressions;
};

/// Empty for a file that is no VRM. What is not as the specification says is left out.
[[nodiscard]] Vrm readVrm(const Json& root);

}  // namespace sinew::gltf
