// tests/viewport/tools/sheet_scene.h: the limb with a sheet on its front.
#pragma once

#include "core/rig/sheet_edit.h"
#include "tests/support/rigs/sheet_on_skin.h"
#include "tests/viewport/tools/limb_scene.h"

namespace sinew::test {

/// A sheet from the limb's root to its end, and behind it in the rig's order nothing.
struct SheetScene : LimbScene {
  explicit SheetScene(const std::shared_ptr<const Character>& character = makeLimb(), const std::string& from = "root",
                      const std::string& to = "end")
      : LimbScene(character) {
    app::prepareMirror(document);
    document.commands.apply("Add sheet",
                            addSheet(document.rig(), sheetBetweenBones(character, "plate", from, to)).value());
    smooth();
  }
  [[nodiscard]] const MuscleSheet& sheet(int index = 0) const {
    return document.rig().sheets[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] glm::vec3 inWorld(const LineAnchor& anchor) const {
    const int bone = *document.character->skeleton.findBone(anchor.bone);
    return glm::vec3(pose.boneInWorld[static_cast<std::size_t>(bone)] * glm::vec4(anchor.point, 1.0f));
  }
  [[nodiscard]] glm::vec2 pixelOf(const glm::vec3& point) const {
    return glm::vec2(app::viewOf(tools.camera, kSize).toPixel(point));
  }
  [[nodiscard]] glm::vec2 pixelOf(const LineAnchor& anchor) const { return pixelOf(inWorld(anchor)); }
  /// The pixel of a belly's middle.
  [[nodiscard]] glm::vec2 pixelOfBelly(int belly) const {
    const PosedRig& posed = document.posedRig(pose);
    const auto& [carrier, placement] = posed.muscles[static_cast<std::size_t>(belly)].body;
    return pixelOf(glm::vec3(carrier * glm::vec4(placement.center, 1.0f)));
  }
};

}  // namespace sinew::test
