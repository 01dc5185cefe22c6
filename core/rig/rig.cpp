// core/rig/rig.cpp: finds parts of a rig; free names; names of settings.
#include "sinew/rig/rig.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string_view>
#include <system_error>

namespace sinew {
namespace {

template <class Named>
int findNamed(std::span<const Named> items, const std::string& name) {
  const auto found = std::ranges::find(items, name, &Named::name);
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

template <class Item, class Id>
int findId(const std::vector<Item>& items, Id id) {
  const auto found = std::ranges::find_if(items, [id](const Item& item) { return id && item.id() == id; });
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

/// "thigh 12" -> "thigh" and 12; anything else -> itself and 1.
struct CountedName {
  std::string base;
  long long count = 1;
};

CountedName splitCount(const std::string& name) {
  const std::size_t space = name.rfind(' ');
  if (space == std::string::npos || space == 0) return {name, 1};
  const std::string_view digits = std::string_view(name).substr(space + 1);
  if (digits.empty() || digits.size() > 9 || digits[0] == '0') return {name, 1};
  long long count = 1;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  const bool whole = status == std::errc{} && end == digits.data() + digits.size() && count > 0;
  return whole ? CountedName{name.substr(0, space), count} : CountedName{name, 1};
}

template <class Named>
std::string freeName(std::span<const Named> items, const std::string& wanted) {
  if (findNamed(items, wanted) < 0) return wanted;
  const auto [base, count] = splitCount(wanted);
  for (long long next = count + 1;; ++next) {
    std::string candidate = base + ' ' + std::to_string(next);
    if (findNamed(items, candidate) < 0) return candidate;
  }
}

template <class Enum, std::size_t N>
std::optional<Enum> named(const std::array<Enum, N>& values, const std::string& name) {
  for (const Enum value : values) {
    if (name == nameOf(value)) return value;
  }
  return std::nullopt;
}

}  // namespace

int findPrimitive(const Rig& rig, const std::string& name) {
  return findNamed(std::span<const Primitive>(rig.primitives), name);
}

int findGroup(const Rig& rig, const std::string& name) { return findNamed(std::span<const Group>(rig.groups), name); }

int findLine(const Rig& rig, const std::string& name) {
  return findNamed(std::span<const MuscleLine>(rig.lines), name);
}

int findSheet(const Rig& rig, const std::string& name) {
  return findNamed(std::span<const MuscleSheet>(rig.sheets), name);
}

int findMorph(const Rig& rig, const std::string& name) {
  return findNamed(std::span<const MorphWeight>(rig.morphs), name);
}

float linkAmount(const Rig& rig, const std::string& a, const std::string& b) {
  float amount = 0.0f;
  for (const Link& link : rig.links) {
    if (link.joins(a, b)) amount = std::max(amount, link.amount);  // Files may contain it twice.
  }
  return amount;
}

int findLink(const Rig& rig, const std::string& a, const std::string& b) {
  const auto found = std::ranges::find_if(rig.links, [&](const Link& link) { return link.joins(a, b); });
  return found == rig.links.end() ? -1 : static_cast<int>(found - rig.links.begin());
}

const MuscleLine* lineOf(const Rig& rig, const Primitive& primitive) {
  const int line = primitive.line.empty() ? -1 : findLine(rig, primitive.line);
  return line < 0 ? nullptr : &rig.lines[static_cast<std::size_t>(line)];
}

int findPrimitive(const Rig& rig, PrimitiveId id) { return findId(rig.primitives, id); }

int findGroup(const Rig& rig, GroupId id) { return findId(rig.groups, id); }

int findLine(const Rig& rig, LineId id) { return findId(rig.lines, id); }

std::string freePrimitiveName(const Rig& rig, const std::string& wanted) {
  return freeName(std::span<const Primitive>(rig.primitives), wanted);
}

std::string freeGroupName(const Rig& rig, const std::string& wanted) {
  return freeName(std::span<const Group>(rig.groups), wanted);
}

std::string freeLineName(const Rig& rig, const std::string& wanted) {
  return freeName(std::span<const MuscleLine>(rig.lines), wanted);
}

std::string freeSheetName(const Rig& rig, const std::string& wanted) {
  return freeName(std::span<const MuscleSheet>(rig.sheets), wanted);
}

std::string freeChannelName(const Rig& rig, const std::string& wanted) {
  return freeName(std::span<const RigChannel>(rig.channels), wanted);
}

const char* nameOf(SurfaceMode mode) { return mode == SurfaceMode::kSwell ? "swell" : "replace"; }

const char* nameOf(PatchKind patch) {
  constexpr std::array kPatches{"pn", "phong", "spherigon", "flat"};
  return kPatches[static_cast<std::size_t>(patch)];
}

const char* nameOf(DetailKind detail) { return detail == DetailKind::kAdaptive ? "adaptive" : "uniform"; }

std::optional<SurfaceMode> surfaceModeNamed(const std::string& name) {
  return named(std::array{SurfaceMode::kSwell, SurfaceMode::kReplace}, name);
}

std::optional<PatchKind> patchKindNamed(const std::string& name) {
  return named(std::array{PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon, PatchKind::kFlat}, name);
}

std::optional<DetailKind> detailKindNamed(const std::string& name) {
  return named(std::array{DetailKind::kUniform, DetailKind::kAdaptive}, name);
}

}  // namespace sinew
