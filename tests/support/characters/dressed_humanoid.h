// tests/support/characters/dressed_humanoid.h: the bundled humanoid with clothes, hair and eyes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "sinew/character/character.h"

namespace sinew::test {

/// assets/humanoid.glb, untouched, with four more meshes on its skin: "Shirt" and "Trousers" over it, of other
/// triangles than the body's (its edges are turned about the middles of its triangles), "Hair" over the head, and
/// "Eyes", two balls inside of it. As a .glb.
[[nodiscard]] std::string dressedHumanoidGlb();
/// Writes it to a folder and gives its path.
std::filesystem::path writeDressedHumanoid(const std::filesystem::path& folder);
/// Imported; made once.
[[nodiscard]] std::shared_ptr<const Character> dressedHumanoid();

}  // namespace sinew::test
