// tests/support/characters/dressed_humanoid.h: the bundled humanoid with clothes, hair and eyes.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew::test {

enum class Outfit {
  kUsual,        ///< A shirt with sleeves to the elbow, 1.6 cm off the skin, and trousers, 1.2 cm.
  kTight,        ///< The same 3 and 2 mm off the skin.
  kLoose,        ///< 4 and 3 cm.
  kLongSleeves,  ///< The shirt's reach to the wrists and are 1 cm off the skin.
  kSkirt,        ///< In place of trousers, from the waist to the knees.
};
inline constexpr Outfit kOutfits[] = {Outfit::kUsual, Outfit::kTight, Outfit::kLoose, Outfit::kLongSleeves,
                                      Outfit::kSkirt};
/// "usual", "long sleeves"
[[nodiscard]] const char* nameOf(Outfit outfit);

/// assets/humanoid.glb, unchanged, with four more meshes on its skin: "Shirt" and "Trousers" over it, with other
/// triangles than the body's (its edges are rotated about the middles of its triangles), "Hair" over the head, and
/// "Eyes", two balls inside it. As a .glb.
[[nodiscard]] std::string dressedHumanoidGlb(Outfit outfit = Outfit::kUsual);
/// Writes it to a folder and gives its path.
std::filesystem::path writeDressedHumanoid(const std::filesystem::path& folder, Outfit outfit = Outfit::kUsual);
/// Imported; each is made once.
[[nodiscard]] std::shared_ptr<const Character> dressedHumanoid(Outfit outfit = Outfit::kUsual);
/// This many poses of each clip.
[[nodiscard]] std::vector<Pose> posesOfClips(const Character& character, int each);

}  // namespace sinew::test
