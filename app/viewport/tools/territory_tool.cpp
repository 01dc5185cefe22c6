// app/viewport/tools/territory_tool.cpp: clicks on bones choose the skin that the active muscle may move.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "app/document/shown_names.h"
#include "app/viewport/tools/status_line.h"
#include "app/viewport/tools/viewport_tools.h"
#include "core/geometry/at.h"
#include "core/rig/attachment.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

/// Bones of the territory as named in a file, or those of the default.
std::vector<std::string> namesOf(const Rig& rig, const Primitive& primitive, const Skeleton& skeleton) {
  if (primitive.territory) return *primitive.territory;
  std::vector<std::string> names;
  const std::optional<int> own = skeleton.findBone(primitive.bone);
  if (!own) return names;
  for (const int bone : territoryBones(primitive, *own, lineOf(rig, primitive), skeleton))
    names.push_back(skeleton.fileName(bone));
  return names;
}

/// Picks bones as if the skeleton were shown.
ViewportHover hoverBone(const ViewportContext& context, const View& view, const glm::vec2& pixel) {
  ViewportContext withBones = context;
  withBones.display.skeleton = true;
  return hoverAt(withBones, view, pixel);
}

void clickBone(ToolFrame& frame) {
  if (frame.tools.hover.bone < 0) return;
  const Result<void> done = toggleTerritoryBone(frame.document(), frame.tools.hover.bone);
  if (!done) frame.result.refusal = done.error();
}

std::string describeTerritory(const ToolFrame& frame) {
  const int bone = frame.tools.hover.bone;
  if (bone < 0) {
    return statusLine("Territory", {"Click on a bone or its skin adds or removes it", "Drag orbits", "Right+drag pans",
                                    "Wheel zooms", "Esc ends"});
  }
  const std::string name = shownBoneName(frame.document().character->skeleton, bone);
  return statusLine("Bone " + name, {"Click adds it to the territory or removes it", "Drag orbits", "Right+drag pans",
                                     "Wheel zooms", "Esc ends"});
}

}  // namespace

int territorySubject(const Document& document) {
  const int active = document.activePrimitive();
  if (active < 0) return -1;
  const Primitive& primitive = at(document.rig().primitives, active);
  return primitive.sheet.empty() && document.character->skeleton.findBone(primitive.bone) ? active : -1;
}

Result<Rig> withTerritoryBone(const Rig& rig, int index, int bone, const Skeleton& skeleton) {
  std::vector<std::string> names = namesOf(rig, at(rig.primitives, index), skeleton);
  const auto removed = std::erase_if(names, [&](const std::string& name) { return skeleton.findBone(name) == bone; });
  if (removed == 0) names.push_back(skeleton.fileName(bone));
  const bool any =
      std::ranges::any_of(names, [&](const std::string& name) { return skeleton.findBone(name).has_value(); });
  if (!any) return errorAt("territory", "a muscle must be allowed to move the skin of at least one bone", "territory");
  return editPrimitives(rig, std::vector<int>{index}, [&](Primitive& primitive) { primitive.territory = names; });
}

Result<void> toggleTerritoryBone(Document& document, int bone) {
  const int index = document.activePrimitive();
  if (index < 0) return {};
  Result<Rig> changed = withTerritoryBone(document.rig(), index, bone, document.character->skeleton);
  if (!changed) return changed.error();
  const std::string name = at(document.rig().primitives, index).name;
  document.commands.apply("Territory of " + name, std::move(changed).value());
  return {};
}

constinit const Tool kTerritoryTool{
    .id = "tool/territory",
    .label = "Edit territory",
    .hint = "Click the bones whose skin the selected muscle may move",
    .key = GLFW_KEY_B,
    .hover = hoverBone,
    .click = clickBone,
    .describe = describeTerritory,
};

}  // namespace sinew::app
