// tests/support/characters/vrm_post.h: turns the morphing post into an avatar, in both versions of VRM.
#pragma once

#include <nlohmann/json.hpp>

namespace sinew::test {

/// The file's "extensions", for makeMorphingPost(3, 1): "hip" is the hips and "knee" the left upper leg; "happy" is
/// half of the first target and all of the third.
[[nodiscard]] nlohmann::ordered_json newVrm();  ///< 1.0
[[nodiscard]] nlohmann::ordered_json oldVrm();  ///< 0.x

}  // namespace sinew::test
