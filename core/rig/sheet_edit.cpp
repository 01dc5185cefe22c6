// core/rig/sheet_edit.cpp: sheets checked, added, renamed, removed, broken up and mirrored.
#include "core/rig/sheet_edit.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/character/bone_names.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/references.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

float profileAt(const Profile& profile, float place) {
  if (profile.empty()) return 1.0f;
  if (place <= profile.front().x) return profile.front().y;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const glm::vec2& to = profile[i];
    if (place > to.x) continue;
    const glm::vec2& from = profile[i - 1];
    const float share = to.x > from.x ? (place - from.x) / (to.x - from.x) : 1.0f;
    return from.y + (to.y - from.y) * share * share * (3.0f - 2.0f * share);
  }
  return profile.back().y;
}

namespace {

struct SheetRange {
  const char* key;
  const char* words;
  float value;
  float least;
  float most;
};

Result<void> validateEdges(const MuscleSheet& sheet, const std::string& place) {
  const std::size_t count = sheet.edges.size();
  if (count < 2 || count > kMostSheetEdges) {
    return errorAt(place + ".edges",
                   "expected 2 to 16 edges, from the origin to the insertion, got " + std::to_string(count), "edges");
  }
  for (std::size_t e = 0; e < count; ++e) {
    const std::string edge = place + indexed(".edges", e);
    const std::vector<LineAnchor>& points = sheet.edges[e].points;
    if (points.empty() || points.size() > kMostEdgePoints) {
      return errorAt(edge + ".points", "expected 1 to 64 points, got " + std::to_string(points.size()),
                     "edge " + std::to_string(e + 1));
    }
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (auto anchor = validateAnchor(points[p], edge + indexed(".points", p), "point"); !anchor) return anchor;
    }
  }
  return {};
}

Result<void> validateProfile(const Profile& profile, const std::string& place, const char* words) {
  if (profile.empty() || profile.size() > kMostEdgePoints) {
    return errorAt(place, "expected 1 to 64 points, got " + std::to_string(profile.size()), words);
  }
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const float x = profile[i].x;
    const float y = profile[i].y;
    const std::string point = place + indexed("", i);
    const float least = i > 0 ? profile[i - 1].x : 0.0f;
    if (!(x >= least && x <= 1.0f)) {
      return outOfRange(point + "[0]", "a number from " + numberText(least) + " to 1", x, words);
    }
    if (!(std::abs(y) <= kMostProfile)) return outOfRange(point + "[1]", "a number from -2 to 2", y, words);
  }
  return {};
}

Result<void> validateNumbers(const MuscleSheet& sheet, const std::string& place) {
  const auto validateCountOf = [&](const char* key, int count, int most) -> Result<void> {
    if (count >= 1 && count <= most) return {};
    return errorAt(place + '.' + key,
                   "expected a whole number from 1 to " + std::to_string(most) + ", got " + std::to_string(count), key);
  };
  if (auto strips = validateCountOf("strips", sheet.strips, kMostStrips); !strips) return strips;
  if (auto bellies = validateCountOf("bellies", sheet.bellies, kMostStripBellies); !bellies) return bellies;
  const std::array numbers = {
      SheetRange{".thickness", "thickness", sheet.thickness, 1e-4f, kMostSheetHeight},
      SheetRange{".width", "width", sheet.width, 0.0f, kMostSheetHeight},
      SheetRange{".crest", "crest", sheet.crest, -kMostSheetHeight, kMostSheetHeight},
      SheetRange{".sunk", "sunk", sheet.sunk, -kMostSheetHeight, kMostSheetHeight},
      SheetRange{".spacing", "spacing", sheet.spacing, kLeastSpacing, kMostSpacing},
      SheetRange{".amount", "amount", sheet.amount, 0.0f, kMostAmount},
  };
  for (const auto& [key, words, value, least, most] : numbers) {
    if (value >= least && value <= most) continue;
    return outOfRange(place + key, "a number from " + numberText(least) + " to " + numberText(most), value, words);
  }
  if (sheet.strips == 1 && sheet.width == 0.0f) {
    return outOfRange(place + ".width", "a number > 0, since there is only one strip", sheet.width, "width");
  }
  if (!(std::isfinite(sheet.reach) && sheet.reach > 1.0f)) {
    return outOfRange(place + ".reach", "a number > 1", sheet.reach, "reach");
  }
  if (sheet.sign != 1 && sheet.sign != -1) {
    return errorAt(place + ".sign", "expected 1 or -1, got " + std::to_string(sheet.sign), "sign");
  }
  return {};
}

}  // namespace

Result<void> validateSheetSettings(const MuscleSheet& sheet, const std::string& place) {
  if (auto numbers = validateNumbers(sheet, place); !numbers) return numbers;
  if (auto across = validateProfile(sheet.across, place + ".across", "profile across"); !across) return across;
  if (auto along = validateProfile(sheet.along, place + ".along", "profile along"); !along) return along;
  return sheet.line ? validateSettings(*sheet.line, place + ".line") : Result<void>();
}

namespace {

Result<void> validateSheetParts(const MuscleSheet& sheet, const std::string& place) {
  if (auto name = validateName(sheet.name, place + ".name"); !name) return name;
  if (auto edges = validateEdges(sheet, place); !edges) return edges;
  return validateSheetSettings(sheet, place);
}

Result<void> validateSheet(const MuscleSheet& sheet, std::size_t index) {
  auto parts = validateSheetParts(sheet, indexed("sheets", index));
  if (parts) return parts;
  return about(sheet.name.empty() ? "a sheet" : quoted("sheet", sheet.name), parts.error());
}

Result<void> validateOwnName(const Rig& rig, std::size_t index) {
  const MuscleSheet& sheet = rig.sheets[index];
  const std::string place = indexed("sheets", index);
  const std::string subject = quoted("sheet", sheet.name);
  if (const int first = findSheet(rig, sheet.name); first != static_cast<int>(index)) {
    return errorAt(place + ".name",
                   "expected a name of its own, but \"" + sheet.name + "\" is also the name of " +
                       indexed("sheets", toIndex(first)),
                   subject);
  }
  return {};
}

/// Groups and twins.
Result<void> validateReferences(const Rig& rig, std::size_t index) {
  const MuscleSheet& sheet = rig.sheets[index];
  const std::string place = indexed("sheets", index);
  const std::string subject = quoted("sheet", sheet.name);
  if (findGroup(rig, sheet.group) < 0) {
    return errorAt(place + ".group", "expected the name of a group, but there is no \"" + sheet.group + '"',
                   subject + ", group");
  }
  if (sheet.mirror.empty()) return {};
  const int twin = findSheet(rig, sheet.mirror);
  if (twin >= 0 && twin != static_cast<int>(index) && at(rig.sheets, twin).mirror == sheet.name) return {};
  return errorAt(place + ".mirror", "expected the name of another sheet whose mirror is this one", subject + ", twin");
}

void dropSheetTwin(Rig& rig, const std::string& name) {
  for (MuscleSheet& sheet : rig.sheets) {
    if (sheet.mirror == name) sheet.mirror.clear();
  }
}

/// Bellies and lines of a sheet, each by its number within it.
void renameMembers(Rig& rig, const std::string& from, const std::string& to) {
  const auto renamed = [&](const std::string& name) {
    return name.starts_with(from) ? to + name.substr(from.size()) : name;
  };
  for (MuscleLine& line : rig.lines) {
    if (line.sheet != from) continue;
    const std::string former = std::exchange(line.name, freeLineName(rig, renamed(line.name)));
    line.sheet = to;
    renameReferences(rig, Named::kLine, former, line.name);
  }
  for (Primitive& belly : rig.primitives) {
    if (belly.sheet != from) continue;
    belly.name = freePrimitiveName(rig, renamed(belly.name));
    belly.sheet = to;
  }
}

}  // namespace

Result<void> validateSheets(const Rig& rig) {
  if (auto count = validateCount("sheets", "sheets", rig.sheets.size(), kMostSheets); !count) return count;
  for (std::size_t i = 0; i < rig.sheets.size(); ++i) {
    if (auto own = validateSheet(rig.sheets[i], i); !own) return own;
    if (auto name = validateOwnName(rig, i); !name) return name;
  }
  for (std::size_t i = 0; i < rig.sheets.size(); ++i) {
    if (auto references = validateReferences(rig, i); !references) return references;
  }
  return {};
}

Rig withoutBellies(Rig rig) {
  std::erase_if(rig.primitives, [](const Primitive& belly) { return !belly.sheet.empty(); });
  std::erase_if(rig.lines, [](const MuscleLine& line) { return !line.sheet.empty(); });
  return rig;
}

std::vector<int> bellies(const Rig& rig, const std::string& sheet) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (!sheet.empty() && rig.primitives[i].sheet == sheet) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

Result<Rig> addSheet(Rig rig, MuscleSheet sheet) {
  sheet.name = freeSheetName(rig, sheet.name.empty() ? "sheet" : sheet.name);
  if (auto own = validateSheet(sheet, rig.sheets.size()); !own) return own.error();
  if (findGroup(rig, sheet.group) < 0) {
    Result<Rig> grouped = addGroup(std::move(rig), sheet.group);
    if (!grouped) return grouped;
    rig = std::move(grouped).value();
  }
  if (const int twin = findSheet(rig, sheet.mirror); twin >= 0) {
    dropSheetTwin(rig, sheet.mirror);
    at(rig.sheets, twin).mirror = sheet.name;
  } else {
    sheet.mirror.clear();
  }
  rig.sheets.push_back(std::move(sheet));
  return rig;
}

Result<Rig> editSheet(Rig rig, int sheet, const std::function<void(MuscleSheet&)>& change) {
  MuscleSheet& edited = at(rig.sheets, sheet);
  [[maybe_unused]] const std::pair names(edited.name, edited.mirror);
  change(edited);
  assert(names == std::pair(edited.name, edited.mirror));
  if (auto own = validateSheet(edited, toIndex(sheet)); !own) return own.error();
  if (auto references = validateReferences(rig, toIndex(sheet)); !references) return references.error();
  return rig;
}

Result<Rig> renameSheet(Rig rig, int sheet, const std::string& name) {
  if (auto valid = validateName(name, indexed("sheets", toIndex(sheet)) + ".name"); !valid) return valid.error();
  const auto rename = [&](int index, const std::string& to) {
    const std::string former = std::exchange(at(rig.sheets, index).name, to);
    for (MuscleSheet& other : rig.sheets) {
      if (other.mirror == former) other.mirror = to;
    }
    renameMembers(rig, former, to);
  };
  if (const int owner = findSheet(rig, name); owner >= 0 && owner != sheet) {
    return errorAt(indexed("sheets", toIndex(sheet)) + ".name", "the name \"" + name + "\" is taken", "name");
  }
  const int twin = findSheet(rig, at(rig.sheets, sheet).mirror);
  rename(sheet, name);
  const std::optional<std::string> image = mirroredName(name);
  if (twin >= 0 && image && findSheet(rig, *image) < 0) rename(twin, *image);
  return rig;
}

Rig removeSheet(Rig rig, int sheet) {
  const std::string name = at(rig.sheets, sheet).name;
  dropSheetTwin(rig, name);
  rig.sheets.erase(rig.sheets.begin() + sheet);
  return removePrimitives(std::move(rig), bellies(rig, name));
}

Rig breakIntoStrips(Rig rig, int sheet) {
  const std::string name = at(rig.sheets, sheet).name;
  const std::string twin = at(rig.sheets, sheet).mirror;
  const auto isBroken = [&](const std::string& of) { return !of.empty() && (of == name || of == twin); };
  std::erase_if(rig.sheets, [&](const MuscleSheet& one) { return isBroken(one.name); });
  for (Primitive& belly : rig.primitives) {
    if (isBroken(belly.sheet)) belly.sheet.clear();
  }
  for (MuscleLine& line : rig.lines) {
    if (isBroken(line.sheet)) line.sheet.clear();
  }
  return rig;
}

namespace {

void pairUpSheets(Rig& rig, int sheet, int twin) {
  dropSheetTwin(rig, at(rig.sheets, sheet).name);
  dropSheetTwin(rig, at(rig.sheets, twin).name);
  at(rig.sheets, sheet).mirror = at(rig.sheets, twin).name;
  at(rig.sheets, twin).mirror = at(rig.sheets, sheet).name;
}

/// " L" or " R", by the first point of its insertion.
std::string sideOfSheet(const MirrorPlan& plan, const MuscleSheet& sheet) {
  const LineAnchor& point = sheet.edges.back().points.front();
  Primitive there;
  there.bone = point.bone;
  there.placement.center = point.point;
  return sideOf(plan, there) == Side::kRight ? " R" : " L";
}

}  // namespace

Result<Rig> linkSheets(Rig rig, int leader, int follower, const MirrorPlan& plan) {
  Result<MuscleSheet> image = mirroredSheet(plan, at(rig.sheets, leader));
  if (!image) return about(quoted("sheet", at(rig.sheets, leader).name), image.error());
  MuscleSheet& second = at(rig.sheets, follower);
  image.value().name = second.name;
  image.value().group = second.group;
  second = std::move(image).value();
  pairUpSheets(rig, leader, follower);
  return rig;
}

Result<Rig> mirrorSheetToOtherSide(Rig rig, int sheet, const MirrorPlan& plan) {
  if (const int twin = findSheet(rig, at(rig.sheets, sheet).mirror); twin >= 0) {
    return linkSheets(std::move(rig), sheet, twin, plan);
  }
  const std::string name = at(rig.sheets, sheet).name;
  if (!mirroredName(name)) {
    const std::string own = freeSheetName(rig, name + sideOfSheet(plan, at(rig.sheets, sheet)));
    Result<Rig> renamed = renameSheet(std::move(rig), sheet, own);
    if (!renamed) return renamed;
    rig = std::move(renamed).value();
  }
  Result<MuscleSheet> image = mirroredSheet(plan, at(rig.sheets, sheet));
  if (!image) return about(quoted("sheet", name), image.error());
  image.value().mirror = at(rig.sheets, sheet).name;
  return addSheet(std::move(rig), std::move(image).value());
}

std::vector<std::string> sheetsOf(const Rig& rig, std::span<const int> primitives) {
  std::vector<std::string> names;
  for (const MuscleSheet& sheet : rig.sheets) {
    const auto isOf = [&](int index) { return at(rig.primitives, index).sheet == sheet.name; };
    if (std::ranges::any_of(primitives, isOf)) names.push_back(sheet.name);
  }
  return names;
}

Result<Rig> flipSheetsOf(Rig rig, std::span<const int> bellies, const MirrorPlan& plan) {
  for (const std::string& name : sheetsOf(rig, bellies)) {
    MuscleSheet& sheet = at(rig.sheets, findSheet(rig, name));
    Result<MuscleSheet> image = mirroredSheet(plan, sheet);
    if (!image) return about(quoted("sheet", name), image.error());
    sheet.edges = std::move(image.value().edges);
  }
  return rig;
}

Rig duplicateSheetsOf(Rig rig, std::span<const int> bellies) {
  std::unordered_map<std::string, std::string> copyOf;
  for (const std::string& name : sheetsOf(rig, bellies)) {
    MuscleSheet copy = at(rig.sheets, findSheet(rig, name));
    const auto twin = copyOf.find(copy.mirror);
    const std::optional<std::string> image = twin != copyOf.end() ? mirroredName(twin->second) : std::nullopt;
    copy.name = freeSheetName(rig, image.value_or(name));
    copy.mirror = twin != copyOf.end() ? twin->second : "";
    copyOf.emplace(name, copy.name);
    rig.sheets.push_back(std::move(copy));
    if (twin != copyOf.end()) at(rig.sheets, findSheet(rig, twin->second)).mirror = rig.sheets.back().name;
  }
  return rig;
}

Rig withBellyTwins(Rig rig) {
  for (Primitive& belly : rig.primitives) {
    if (!belly.sheet.empty()) belly.mirror.clear();
  }
  for (MuscleLine& line : rig.lines) {
    if (!line.sheet.empty()) line.mirror.clear();
  }
  for (const MuscleSheet& sheet : rig.sheets) {
    const std::vector<int> own = bellies(rig, sheet.name);
    const std::vector<int> others = bellies(rig, sheet.mirror);
    if (own.size() != others.size()) continue;
    for (std::size_t i = 0; i < own.size(); ++i) {
      at(rig.primitives, own[i]).mirror = at(rig.primitives, others[i]).name;
      const int line = findLine(rig, at(rig.primitives, own[i]).line);
      const int other = findLine(rig, at(rig.primitives, others[i]).line);
      if (line >= 0 && other >= 0) at(rig.lines, line).mirror = at(rig.lines, other).name;
    }
  }
  return rig;
}

Result<MuscleSheet> mirroredSheet(const MirrorPlan& plan, const MuscleSheet& sheet) {
  MuscleSheet image = sheet;
  image.mirror.clear();
  image.group = mirroredName(sheet.group).value_or(sheet.group);
  for (SheetEdge& edge : image.edges) {
    for (LineAnchor& point : edge.points) {
      Result<LineAnchor> other = mirroredAnchor(plan, point);
      if (!other) return other.error();
      point = std::move(other).value();
    }
  }
  image.name = imageName(plan, sheet.name, sheet.edges.back().points.front().bone);
  return image;
}

}  // namespace sinew
