// app/document/clipboard.cpp: muscles as text, and back.
#include "app/document/clipboard.h"

#include <utility>

#include "core/geometry/at.h"
#include "core/rig/merge.h"
#include "sinew/files/rig_json.h"

namespace sinew::app {
namespace {

Result<Rig> rigInText(const std::string& text) {
  Result<Rig> rig = rigFromJson(text);
  if (!rig) return errorAt("", "the clipboard holds no muscles");
  if (rig->primitives.empty()) return errorAt("", "the rig in the clipboard has no muscles");
  return rig;
}

Result<Pasted> pasteRig(const Rig& rig, const Rig& copied, const Skeleton& skeleton, const MirrorPlan* mirror) {
  Result<Merged> merged = mergeRigs(rig, copied, skeleton, mirror);
  if (!merged) return merged.error();
  Pasted pasted{std::move(merged.value().rig), {}, {}};
  for (const int index : merged->primitives) {
    if (index >= 0) pasted.names.push_back(at(pasted.rig.primitives, index).name);
  }
  for (const auto& [primitive, why] : merged->refusals) {
    pasted.leftOut.push_back('"' + at(copied.primitives, primitive).name + "\" is not pasted: " + why.plainText());
  }
  for (const auto& [owner, line] : merged->lostDrivers) {
    pasted.leftOut.push_back('"' + owner + "\" is pasted without a driver: there is no muscle line \"" + line + '"');
  }
  if (pasted.names.empty()) return errorAt("", pasted.leftOut.front());
  return pasted;
}

}  // namespace

std::string musclesAsText(const Rig& rig, std::span<const int> indices) {
  Rig copied = excerpt(rig, indices);
  if (copied.character.empty()) copied.character = "clipboard";  // A rig file names one.
  return rigToJson(copied);
}

Result<Pasted> pasteText(const Rig& rig, const std::string& text, const Skeleton& skeleton, const MirrorPlan* mirror) {
  const Result<Rig> copied = rigInText(text);
  return copied ? pasteRig(rig, copied.value(), skeleton, mirror) : copied.error();
}

Result<Pasted> pasteTextOnBone(const Rig& rig, const std::string& text, const Skeleton& skeleton, int bone,
                               const MirrorPlan* plan) {
  const Result<Rig> copied = rigInText(text);
  if (!copied) return copied.error();
  const std::optional<Rig> moved = moveToBone(copied.value(), skeleton, bone, plan);
  return pasteRig(rig, moved ? *moved : copied.value(), skeleton, nullptr);
}

}  // namespace sinew::app
