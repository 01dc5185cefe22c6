// app/document/clipboard.cpp: muscles as text, and back.

#include "app/document/clipboard.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/rig/rig_edit.h"
#include "core/skeleton/side_names.h"
#include "core/symmetry/twins.h"
#include "sinew/io/rig_json.h"

namespace sinew::app {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Groups of the text that the rig lacks, and the links that join a new one to another.
Result<Rig> withGroups(Rig rig, const Rig& copied) {
  std::vector<std::string> made;
  for (const Group& group : copied.groups) {
    if (findGroup(rig, group.name) >= 0) continue;
    Result<Rig> grown = addGroup(rig, group.name);
    if (!grown) return grown;
    rig = std::move(grown).value();
    made.push_back(group.name);
  }
  for (const auto& [a, b] : copied.links) {
    if (!contains(made, a) && !contains(made, b)) continue;
    Result<Rig> linked = setLink(rig, findGroup(rig, a), findGroup(rig, b), true);
    if (!linked) return linked;
    rig = std::move(linked).value();
  }
  return rig;
}

/// Twins of the text, both pasted, are twins again.
void linkPasted(Rig& rig, const Rig& copied, const std::map<std::string, std::string>& nameOf) {
  for (const Primitive& primitive : copied.primitives) {
    const auto own = nameOf.find(primitive.name);
    const auto twin = nameOf.find(primitive.mirror);
    if (own == nameOf.end() || twin == nameOf.end() || primitive.mirror < primitive.name) continue;
    rig = setMirror(rig, findPrimitive(rig, own->second), findPrimitive(rig, twin->second));
  }
}

}  // namespace

std::string musclesAsText(const Rig& rig, std::span<const int> indices) {
  Rig copied;
  copied.character = rig.character.empty() ? "clipboard" : rig.character;  // A rig file names one.
  std::vector<std::string> names;
  std::vector<std::string> groups;
  for (const int index : indices) names.push_back(rig.primitives[static_cast<std::size_t>(index)].name);
  for (const int index : indices) {
    Primitive primitive = rig.primitives[static_cast<std::size_t>(index)];
    if (!contains(names, primitive.mirror)) primitive.mirror.clear();
    if (!contains(groups, primitive.group)) groups.push_back(primitive.group);
    copied.primitives.push_back(std::move(primitive));
  }
  for (const Group& group : rig.groups) {
    if (contains(groups, group.name)) copied.groups.push_back(group);
  }
  for (const auto& link : rig.links) {
    if (contains(groups, link[0]) && contains(groups, link[1])) copied.links.push_back(link);
  }
  return rigToJson(copied);
}

Result<Pasted> pastedMuscles(const Rig& rig, const std::string& text, const Skeleton& skeleton,
                             const MirrorPlan* mirror) {
  const Result<Rig> copied = rigFromJson(text);
  if (!copied) return errorAt("", "the clipboard holds no muscles");
  if (copied->primitives.empty()) return errorAt("", "the rig in the clipboard has no muscles");
  Result<Rig> grown = withGroups(rig, copied.value());
  if (!grown) return grown.error();
  Pasted pasted{std::move(grown).value(), {}, {}};
  std::map<std::string, std::string> nameOf;
  for (Primitive primitive : copied->primitives) {
    const std::string name = primitive.name;
    if (!skeleton.findBone(primitive.bone)) {
      pasted.leftOut.push_back('"' + name + "\" is not pasted: this character has no bone \"" + primitive.bone + '"');
      continue;
    }
    if (mirror) {
      Result<Primitive> image = mirroredPrimitive(*mirror, primitive);
      if (!image) {
        pasted.leftOut.push_back('"' + name + "\" is not pasted: " + image.error().plainText());
        continue;
      }
      image.value().mirror = primitive.mirror;
      primitive = std::move(image).value();
    }
    // The second of a pair is named after what the first has become.
    const auto twin = nameOf.find(primitive.mirror);
    if (twin != nameOf.end() && mirroredName(twin->first) == name) primitive.name = twinName(pasted.rig, twin->second);
    primitive.mirror.clear();
    Result<Rig> added = addPrimitive(pasted.rig, std::move(primitive));
    if (!added) {
      pasted.leftOut.push_back('"' + name + "\" is not pasted: " + added.error().plainText());
      continue;
    }
    pasted.rig = std::move(added).value();
    pasted.names.push_back(pasted.rig.primitives.back().name);
    nameOf.emplace(name, pasted.names.back());
  }
  if (pasted.names.empty()) return errorAt("", pasted.leftOut.front());
  linkPasted(pasted.rig, copied.value(), nameOf);
  return pasted;
}

}  // namespace sinew::app
