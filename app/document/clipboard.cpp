// app/document/clipboard.cpp: muscles as text, and back.

#include "app/document/clipboard.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/rig/animated_edit.h"
#include "core/rig/line_edit.h"
#include "core/rig/rig_edit.h"
#include "core/skeleton/side_names.h"
#include "core/symmetry/line_twins.h"
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

/// What lines of the text are called where they were pasted.
using LineNames = std::map<std::string, std::string>;

/// The line of a pasted primitive, added when the first one of it comes. Error: its bones are not there.
Result<Rig> withLine(Rig rig, const Rig& copied, const std::string& name, const Skeleton& skeleton,
                     const MirrorPlan* mirror, LineNames& lines) {
  if (name.empty() || lines.contains(name)) return rig;
  MuscleLine line = copied.lines[static_cast<std::size_t>(findLine(copied, name))];
  for (const LineAnchor* anchor : {&line.origin, &line.insertion, line.via ? &*line.via : nullptr}) {
    if (anchor == nullptr || skeleton.findBone(anchor->bone)) continue;
    return errorAt("", "this character has no bone \"" + anchor->bone + '"');
  }
  if (mirror) {
    Result<MuscleLine> image = mirroredLine(*mirror, line);
    if (!image) return image.error();
    line = std::move(image).value();
  }
  line.mirror.clear();
  line.identity = {};
  Result<Rig> added = addLine(rig, std::move(line));
  if (added) lines.emplace(name, added->lines.back().name);
  return added;
}

void linkPastedLines(Rig& rig, const Rig& copied, const LineNames& lines) {
  for (const MuscleLine& line : copied.lines) {
    const auto own = lines.find(line.name);
    const auto twin = lines.find(line.mirror);
    if (own == lines.end() || twin == lines.end() || line.mirror < line.name) continue;
    rig = setLineMirror(rig, findLine(rig, own->second), findLine(rig, twin->second));
  }
}

/// Channels that the rig lacks. One that is there stays as it is.
void addChannels(Rig& rig, const Rig& copied) {
  const Rig before = rig;
  for (const RigChannel& channel : copied.channels) {
    const bool known =
        std::ranges::any_of(before.channels, [&](const RigChannel& own) { return own.name == channel.name; });
    if (!known) rig.channels.push_back(channel);
  }
}

/// Drivers read lines under the names that they were pasted with; those of lines that are not there are left out.
void readPastedLines(Pasted& pasted, const LineNames& lines) {
  const auto settle = [&](std::vector<AnimatedNumber>& animated, const std::string& name) {
    keepDrivers(animated, [&](const DriverInput& input) {
      if (input.kind != DriverInputKind::kLength || lines.contains(input.line)) return true;
      if (findLine(pasted.rig, input.line) >= 0) return true;
      pasted.leftOut.push_back('"' + name + "\" is pasted without a driver: there is no muscle line \"" + input.line +
                               '"');
      return false;
    });
    for (AnimatedNumber& number : animated) {
      for (Driver& driver : number.drivers) {
        const auto found = lines.find(driver.input.line);
        if (driver.input.kind == DriverInputKind::kLength && found != lines.end()) driver.input.line = found->second;
      }
    }
  };
  for (const auto& [from, to] : lines) {
    settle(pasted.rig.lines[static_cast<std::size_t>(findLine(pasted.rig, to))].animated, to);
  }
  for (const std::string& name : pasted.names) {
    settle(pasted.rig.primitives[static_cast<std::size_t>(findPrimitive(pasted.rig, name))].animated, name);
  }
}

/// The lines and channels that muscles and their lines read.
void addInputs(const Rig& rig, Rig& copied) {
  std::vector<std::string> lines;
  std::vector<std::string> channels;
  const auto note = [&](const std::vector<AnimatedNumber>& animated) {
    for (const AnimatedNumber& number : animated) {
      for (const Driver& driver : number.drivers) {
        lines.push_back(driver.input.line);
        channels.push_back(driver.input.channel);
      }
    }
  };
  for (const Primitive& primitive : copied.primitives) note(primitive.animated);
  for (const MuscleLine& line : copied.lines) note(line.animated);
  for (const MuscleLine& line : rig.lines) {
    if (!contains(lines, line.name) || findLine(copied, line.name) >= 0) continue;
    copied.lines.push_back(line);
    copied.lines.back().mirror.clear();
    copied.lines.back().animated.clear();
  }
  for (const RigChannel& channel : rig.channels) {
    if (contains(channels, channel.name)) copied.channels.push_back(channel);
  }
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

/// Which side of the mirror plane a bone lies on; 0 if it is absent.
int sideOf(const MirrorPlan& plan, const Skeleton& skeleton, const std::string& bone) {
  const std::optional<int> index = skeleton.findBone(bone);
  if (!index) return 0;
  const double distance =
      distanceTo(plan.plane, glm::dvec3(glm::vec3(skeleton.bones[static_cast<std::size_t>(*index)].bindInWorld[3])));
  return distance < 0.0 ? -1 : 1;
}

/// The muscles that lead: of twins the one on the side of `bone`.
std::vector<Primitive> leaders(const Rig& copied, const Skeleton& skeleton, const std::string& bone,
                               const MirrorPlan* plan) {
  std::vector<Primitive> result;
  for (const Primitive& primitive : copied.primitives) {
    const int twin = primitive.mirror.empty() ? -1 : findPrimitive(copied, primitive.mirror);
    if (twin < 0) {
      result.push_back(primitive);
      continue;
    }
    const Primitive& other = copied.primitives[static_cast<std::size_t>(twin)];
    const bool first = primitive.name < other.name;
    if (!first) continue;
    const bool swapped = plan && sideOf(*plan, skeleton, primitive.bone) != sideOf(*plan, skeleton, bone) &&
                         sideOf(*plan, skeleton, other.bone) == sideOf(*plan, skeleton, bone);
    result.push_back(swapped ? other : primitive);
  }
  return result;
}

/// Length of a bone in its own space.
float lengthOf(const Skeleton& skeleton, int bone) {
  const Bone& own = skeleton.bones[static_cast<std::size_t>(bone)];
  return glm::length(own.tip);
}

/// Keyed and driven lengths grow with the muscle.
void scaleLengths(std::vector<AnimatedNumber>& animated, float factor) {
  const auto scale = [&](Curve& curve) {
    for (glm::vec2& point : curve.points) point.y *= factor;
  };
  for (AnimatedNumber& number : animated) {
    if (!isLength(number.parameter)) continue;
    for (KeyTrack& track : number.keys) scale(track.curve);
    for (Driver& driver : number.drivers) {
      if (driver.mode != DriverMode::kMultiply) scale(driver.curve);
    }
  }
}

void placeOnBone(Primitive& primitive, const Skeleton& skeleton, int bone) {
  const std::optional<int> from = skeleton.findBone(primitive.bone);
  const float before = from ? lengthOf(skeleton, *from) : 0.0f;
  const float factor = before > 0.0f ? lengthOf(skeleton, bone) / before : 1.0f;
  if (factor > 0.0f && std::isfinite(factor)) {
    primitive.placement.center *= factor;
    primitive.placement.radii *= factor;
    scaleLengths(primitive.animated, factor);
  }
  primitive.bone = skeleton.fileName(bone);
  primitive.territory.reset();
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
  std::vector<std::string> lines;
  for (const Primitive& primitive : copied.primitives) lines.push_back(primitive.line);
  for (const MuscleLine& line : rig.lines) {
    if (!contains(lines, line.name)) continue;
    copied.lines.push_back(line);
    if (!contains(lines, line.mirror)) copied.lines.back().mirror.clear();
  }
  addInputs(rig, copied);
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
  addChannels(pasted.rig, copied.value());
  std::map<std::string, std::string> nameOf;
  LineNames lines;
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
    Result<Rig> lined = withLine(pasted.rig, copied.value(), primitive.line, skeleton, mirror, lines);
    if (!lined) {
      pasted.leftOut.push_back('"' + name + "\" is not pasted: " + lined.error().plainText());
      continue;
    }
    if (!primitive.line.empty()) primitive.line = lines[primitive.line];
    // The second of a pair is named after what the first has become.
    const auto twin = nameOf.find(primitive.mirror);
    if (twin != nameOf.end() && mirroredName(twin->first) == name) primitive.name = twinName(pasted.rig, twin->second);
    primitive.mirror.clear();
    Result<Rig> added = addPrimitive(lined.value(), std::move(primitive));
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
  linkPastedLines(pasted.rig, copied.value(), lines);
  readPastedLines(pasted, lines);
  return pasted;
}

Result<Pasted> pastedOnBone(const Rig& rig, const std::string& text, const Skeleton& skeleton, int bone,
                            const MirrorPlan* plan) {
  const Result<Rig> copied = rigFromJson(text);
  if (!copied) return pastedMuscles(rig, text, skeleton, nullptr);
  std::vector<Primitive> moved = leaders(copied.value(), skeleton, skeleton.fileName(bone), plan);
  const bool one = std::ranges::all_of(moved, [&](const Primitive& p) { return p.bone == moved.front().bone; });
  const bool spans = std::ranges::any_of(moved, [](const Primitive& p) { return !p.line.empty(); });
  if (moved.empty() || !one || spans || skeleton.findBone(moved.front().bone) == bone) {
    return pastedMuscles(rig, text, skeleton, nullptr);
  }
  Rig onBone = copied.value();
  onBone.primitives.clear();
  for (Primitive& primitive : moved) {
    placeOnBone(primitive, skeleton, bone);
    const std::string twin = std::exchange(primitive.mirror, {});
    onBone.primitives.push_back(primitive);
    if (twin.empty() || plan == nullptr) continue;
    Result<Primitive> image = mirroredPrimitive(*plan, primitive);
    if (!image) continue;
    onBone.primitives.back().mirror = twin;
    image.value().name = twin;
    image.value().mirror = primitive.name;
    onBone.primitives.push_back(std::move(image).value());
  }
  return pastedMuscles(rig, rigToJson(onBone), skeleton, nullptr);
}

}  // namespace sinew::app
