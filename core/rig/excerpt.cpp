// core/rig/excerpt.cpp: what a muscle takes along.
#include "core/rig/excerpt.h"

#include <string>
#include <unordered_set>

#include "core/geometry/at.h"
#include "core/rig/references.h"

namespace sinew {

Rig excerpt(const Rig& rig, std::span<const int> primitives) {
  using Names = std::unordered_set<std::string>;
  Rig part;
  part.character = rig.character;
  Names muscles, groups, ridden, read, channels;
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
  for (const auto& link : rig.links) {
    if (groups.contains(link[0]) && groups.contains(link[1])) part.links.push_back(link);
  }
  return part;
}

}  // namespace sinew
