// core/rig/merge.cpp: makes names free and follows references by index.
#include "core/rig/merge.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/character/bone_names.h"
#include "core/geometry/at.h"
#include "core/rig/animated_edit.h"
#include "core/rig/line_edit.h"
#include "core/rig/references.h"
#include "core/rig/sheet_edit.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

Rig excerpt(const Rig& rig, std::span<const int> primitives) {
  using Names = std::unordered_set<std::string>;
  Rig part;
  part.character = rig.character;
  Names muscles, groups, ridden, read, channels;  // Lines and channels that drivers read.
  const auto note = [&](Named kind, const std::string& name) { (kind == Named::kLine ? read : channels).insert(name); };
  for (const int index : primitives) muscles.insert(at(rig.primitives, index).name);
  for (const int index : primitives) {
    Primitive& copy = part.primitives.emplace_back(at(rig.primitives, index));
    if (!muscles.contains(copy.mirror)) copy.mirror.clear();
    groups.insert(copy.group);
    ridden.insert(copy.line);
    eachReference(copy.animated, note);
  }
  for (const MuscleLine& line : rig.lines) {
    if (!ridden.contains(line.name)) continue;
    MuscleLine& copy = part.lines.emplace_back(line);
    if (!ridden.contains(copy.mirror)) copy.mirror.clear();
    eachReference(copy.animated, note);
  }
  for (const Link& link : rig.links) {
    if (!groups.contains(link.groups[0]) || !groups.contains(link.groups[1])) continue;
    eachReference(part.links.emplace_back(link).animated, note);
  }
  for (const MuscleLine& line : rig.lines) {
    if (!read.contains(line.name) || ridden.contains(line.name)) continue;
    MuscleLine& copy = part.lines.emplace_back(line);
    copy.mirror.clear();
    copy.animated.clear();
  }
  for (const RigChannel& channel : rig.channels) {
    if (channels.contains(channel.name)) part.channels.push_back(channel);
  }
  for (const Group& group : rig.groups) {
    if (groups.contains(group.name)) part.groups.push_back(group);
  }
  const std::vector<std::string> sheets = sheetsOf(rig, primitives);
  for (const std::string& name : sheets) {
    MuscleSheet& copy = part.sheets.emplace_back(at(rig.sheets, findSheet(rig, name)));
    if (std::ranges::find(sheets, copy.mirror) == sheets.end()) copy.mirror.clear();
  }
  return part;
}

namespace {

Error lacksBone(const std::string& bone) { return errorAt("", "this character has no bone \"" + bone + '"'); }

/// Adds groups of `from` that the rig lacks, with their links.
/// @param mirror  of the muscles that come, or null
Result<void> addGroups(Rig& rig, const Rig& from, const MirrorPlan* mirror) {
  const auto former = static_cast<int>(rig.groups.size());
  for (const Group& group : from.groups) {
    if (findGroup(rig, group.name) < 0) rig.groups.push_back({group.name, {}});
  }
  for (const Link& link : from.links) {
    const auto isNew = [&](const std::string& group) { return findGroup(rig, group) >= former; };
    if (!std::ranges::any_of(link.groups, isNew)) continue;
    Link& added = rig.links.emplace_back(link);
    if (mirror) added.animated = mirroredAnimation(*mirror, link);
  }
  return static_cast<int>(rig.groups.size()) > former ? validateLinks(rig) : Result<void>();
}

/// Adds channels that the rig lacks, with all their tracks.
void addChannels(Rig& rig, const Rig& from) {
  const std::size_t former = rig.channels.size();
  for (const RigChannel& channel : from.channels) {
    const std::span own(rig.channels.data(), former);
    if (std::ranges::find(own, channel.name, &RigChannel::name) == own.end()) rig.channels.push_back(channel);
  }
}

class Merge {
 public:
  Merge(Rig into, const Rig& from, const Skeleton& skeleton, const MirrorPlan* mirror)
      : from_(from), skeleton_(skeleton), mirror_(mirror), formerLines_(static_cast<int>(into.lines.size())) {
    merged_.rig = std::move(into);
    merged_.primitives.assign(from.primitives.size(), -1);
    merged_.lines.assign(from.lines.size(), -1);
  }

  Result<Merged> run() {
    const std::size_t formerLinks = rig().links.size();
    if (auto grouped = addGroups(rig(), from_, mirror_); !grouped) return grouped.error();
    addChannels(rig(), from_);
    for (const MuscleSheet& sheet : from_.sheets) addSheetOf(sheet);
    for (int i = 0; i < static_cast<int>(from_.primitives.size()); ++i) {
      if (!at(from_.primitives, i).sheet.empty()) continue;
      if (auto added = addWithLine(i); !added) merged_.refusals.push_back({i, added.error()});
    }
    linkLines();
    relinkDrivers(merged_.lines, rig().lines);
    relinkDrivers(merged_.primitives, rig().primitives);
    for (Link& link : std::span(rig().links).subspan(formerLinks)) {
      relinkDrivers(link.groups[0] + " and " + link.groups[1], link.animated);
    }
    return std::move(merged_);
  }

 private:
  Rig& rig() { return merged_.rig; }

  /// Bellies are laid where the rig is used.
  void addSheetOf(const MuscleSheet& sheet) {
    Result<MuscleSheet> copy = sheet;
    for (const SheetEdge& edge : sheet.edges) {
      for (const LineAnchor& point : edge.points) {
        if (!skeleton_.findBone(point.bone)) copy = lacksBone(point.bone);
      }
    }
    if (copy && mirror_) copy = mirroredSheet(*mirror_, sheet);
    if (!copy) {
      merged_.sheetRefusals.push_back({sheet.name, copy.error()});
      return;
    }
    const auto twin = sheetNow_.find(sheet.mirror);
    const std::optional<std::string> image = twin != sheetNow_.end() ? mirroredName(twin->second) : std::nullopt;
    copy.value().name = image.value_or(copy->name);
    copy.value().mirror = twin != sheetNow_.end() ? twin->second : "";
    if (findGroup(rig(), copy->group) < 0) copy.value().group = sheet.group;
    Result<Rig> added = addSheet(std::move(rig()), std::move(copy).value());
    if (!added) {
      merged_.sheetRefusals.push_back({sheet.name, added.error()});
      return;
    }
    rig() = std::move(added).value();
    merged_.sheets.push_back(rig().sheets.back().name);
    sheetNow_.emplace(sheet.name, rig().sheets.back().name);
  }

  /// Removes a line that was added for a primitive if that is then left out.
  Result<void> addWithLine(int index) {
    const int line = findLine(from_, at(from_.primitives, index).line);
    const bool isNew = line >= 0 && at(merged_.lines, line) < 0;
    if (!skeleton_.findBone(at(from_.primitives, index).bone)) return lacksBone(at(from_.primitives, index).bone);
    if (isNew) {
      if (auto added = addLine(line); !added) return added;
    }
    auto added = addPrimitive(index, line);
    if (!added && isNew) {
      rig().lines.pop_back();
      at(merged_.lines, line) = -1;
    }
    return added;
  }

  Result<void> addLine(int index) {
    MuscleLine line = at(from_.lines, index);
    for (const LineAnchor* anchor : {&line.origin, &line.insertion, line.via ? &*line.via : nullptr}) {
      if (anchor != nullptr && !skeleton_.findBone(anchor->bone)) return lacksBone(anchor->bone);
    }
    if (mirror_) {
      Result<MuscleLine> image = mirroredLine(*mirror_, line);
      if (!image) return image.error();
      line = std::move(image).value();
    }
    line.mirror.clear();
    line.identity = {};
    auto added = append(rig(), std::move(line));
    if (added) at(merged_.lines, index) = static_cast<int>(rig().lines.size()) - 1;
    return added;
  }

  Result<void> addPrimitive(int index, int line) {
    Primitive primitive = at(from_.primitives, index);
    if (mirror_) {
      Result<Primitive> image = mirroredPrimitive(*mirror_, primitive);
      if (!image) return image.error();
      primitive = std::move(image).value();
    }
    const int twin = twinOf(from_, index);
    const int twinNow = twin < 0 ? -1 : at(merged_.primitives, twin);
    primitive.mirror = twinNow < 0 ? "" : at(rig().primitives, twinNow).name;
    if (twinNow >= 0 && mirroredName(at(from_.primitives, twin).name) == at(from_.primitives, index).name) {
      primitive.name = twinName(rig(), primitive.mirror);
    }
    primitive.line = line < 0 ? "" : at(rig().lines, at(merged_.lines, line)).name;
    primitive.identity = {};
    auto added = append(rig(), std::move(primitive));
    if (added) at(merged_.primitives, index) = static_cast<int>(rig().primitives.size()) - 1;
    return added;
  }

  void linkLines() {
    for (std::size_t i = 0; i < from_.lines.size(); ++i) {
      const int twin = findLine(from_, from_.lines[i].mirror);
      if (twin <= static_cast<int>(i) || merged_.lines[i] < 0 || at(merged_.lines, twin) < 0) continue;
      rig() = setLineMirror(std::move(rig()), merged_.lines[i], at(merged_.lines, twin));
    }
  }

  /// The name here of a line of `from`: that of the merged line, else of one that existed before; null: none.
  const std::string* lineNow(const std::string& name) {
    const int line = findLine(from_, name);
    const int came = line < 0 ? -1 : at(merged_.lines, line);
    const int own = came >= 0 ? came : findLine(rig(), name);
    return own >= 0 && (came >= 0 || own < formerLines_) ? &at(rig().lines, own).name : nullptr;
  }

  template <class Item>
  void relinkDrivers(const std::vector<int>& came, std::vector<Item>& items) {
    for (const int index : came) {
      if (index < 0) continue;
      relinkDrivers(at(items, index).name, at(items, index).animated);
    }
  }

  void relinkDrivers(const std::string& owner, std::vector<AnimatedNumber>& animated) {
    keepDrivers(animated, [&](const DriverInput& input) {
      if (input.kind != DriverInputKind::kLength || lineNow(input.line)) return true;
      merged_.lostDrivers.push_back({owner, input.line});
      return false;
    });
    eachReference(animated, [&](Named kind, std::string& name) {
      const std::string* now = kind == Named::kLine ? lineNow(name) : nullptr;
      if (now) name = *now;
    });
  }

  const Rig& from_;
  const Skeleton& skeleton_;
  const MirrorPlan* mirror_;
  int formerLines_;
  std::unordered_map<std::string, std::string> sheetNow_;  ///< Name in `from` -> name here.
  Merged merged_;
};

// To another bone --------------------------------------------------------------------------------------------------

/// Side of the plane of a bone's joint, 1 or -1; 0: the bone is missing.
int sideOfBone(const MirrorPlan& plan, const Skeleton& skeleton, const std::string& bone) {
  const std::optional<int> index = skeleton.findBone(bone);
  if (!index) return 0;
  return distanceTo(plan.plane, glm::dvec3(at(skeleton.bones, *index).bindInWorld[3])) < 0.0 ? -1 : 1;
}

/// Indices of primitives without twins, and for twins of the one on the side of `bone`, else the first by name.
std::vector<int> leaders(const Rig& rig, const Skeleton& skeleton, const std::string& bone, const MirrorPlan* plan) {
  const auto isThere = [&](int index) {
    return plan && sideOfBone(*plan, skeleton, at(rig.primitives, index).bone) == sideOfBone(*plan, skeleton, bone);
  };
  std::vector<int> indices;
  for (int i = 0; i < static_cast<int>(rig.primitives.size()); ++i) {
    const int twin = twinOf(rig, i);
    if (twin >= 0 && at(rig.primitives, twin).name < at(rig.primitives, i).name) continue;
    indices.push_back(twin >= 0 && !isThere(i) && isThere(twin) ? twin : i);
  }
  return indices;
}

}  // namespace

Result<Merged> mergeRigs(Rig into, const Rig& from, const Skeleton& skeleton, const MirrorPlan* mirror) {
  return Merge(std::move(into), from, skeleton, mirror).run();
}

std::optional<Rig> moveToBone(const Rig& rig, const Skeleton& skeleton, int bone, const MirrorPlan* plan) {
  const std::vector<int> moving = leaders(rig, skeleton, skeleton.fileName(bone), plan);
  if (moving.empty()) return std::nullopt;
  const std::string& from = at(rig.primitives, moving.front()).bone;
  const auto movable = [&](int i) { return at(rig.primitives, i).bone == from && at(rig.primitives, i).line.empty(); };
  if (!rig.sheets.empty()) return std::nullopt;
  if (!std::ranges::all_of(moving, movable) || skeleton.findBone(from) == bone) return std::nullopt;
  Rig moved = rig;
  moved.primitives.clear();
  for (const int index : moving) {
    Primitive& primitive = moved.primitives.emplace_back(scaleToBone(at(rig.primitives, index), skeleton, bone));
    const std::string twin = std::exchange(primitive.mirror, {});
    if (twin.empty() || !plan) continue;
    Result<Primitive> image = mirroredPrimitive(*plan, primitive);
    if (!image) continue;
    primitive.mirror = twin;
    image.value().name = twin;
    image.value().mirror = primitive.name;
    moved.primitives.push_back(std::move(image).value());
  }
  return moved;
}

}  // namespace sinew
