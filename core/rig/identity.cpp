// core/rig/identity.cpp: identities for what edits have added or copied.

#include "core/rig/identity.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/rig/references.h"

namespace sinew {
namespace {

/// `Item` is Primitive, Group or MuscleLine.
template <class Item>
void complete(std::vector<Item>& items, const std::vector<Item>& before, std::uint32_t& last) {
  std::unordered_map<std::uint32_t, std::string_view> nameOf;
  std::unordered_map<std::string_view, std::uint32_t> idOf;
  for (const Item& item : before) {
    nameOf.emplace(item.id().value, item.name);
    idOf.emplace(item.name, item.id().value);
  }
  // Of several that share an identity, the one with the old name is the original; without one, the first.
  std::unordered_map<std::uint32_t, const Item*> ownerOf;
  for (const Item& item : items) {
    const std::uint32_t id = item.id().value;
    if (id == 0) continue;
    const auto [owner, isFirst] = ownerOf.emplace(id, &item);
    const auto old = nameOf.find(id);
    if (!isFirst && old != nameOf.end() && item.name == old->second && owner->second->name != old->second) {
      owner->second = &item;
    }
  }
  for (Item& item : items) {
    if (const auto owner = ownerOf.find(item.id().value); owner != ownerOf.end() && owner->second == &item) continue;
    const auto old = idOf.find(item.name);
    const bool free = old != idOf.end() && old->second != 0 && !ownerOf.contains(old->second);
    const std::uint32_t id = free ? old->second : ++last;
    item.identity.value.value = id;
    ownerOf.emplace(id, &item);
  }
}

using Renames = std::unordered_map<std::string_view, std::string_view>;

/// Former name -> name, of what is called otherwise now.
template <class Item>
Renames renamesOf(const std::vector<Item>& before, const std::vector<Item>& edited) {
  const auto same = [](const Item& a, const Item& b) { return a.id() == b.id() && a.name == b.name; };
  if (std::ranges::equal(before, edited, same)) return {};
  std::unordered_map<std::uint32_t, std::string_view> nameOf;
  for (const Item& item : edited) {
    if (item.id()) nameOf.emplace(item.id().value, item.name);
  }
  Renames renames;
  for (const Item& item : before) {
    const auto name = nameOf.find(item.id().value);
    if (name != nameOf.end() && name->second != item.name) renames.emplace(item.name, name->second);
  }
  return renames;
}

/// Items that are gone go first: their names may be taken.
template <class Item>
void rename(std::vector<Item>& items, const std::vector<Item>& edited, const Renames& renames) {
  if (renames.empty()) return;
  std::unordered_set<std::uint32_t> there;
  for (const Item& item : edited) there.insert(item.id().value);
  std::erase_if(items, [&](const Item& item) { return !there.contains(item.id().value); });
  for (Item& item : items) {
    if (const auto name = renames.find(item.name); name != renames.end()) item.name = name->second;
  }
}

}  // namespace

std::optional<Rig> withNamesOf(const Rig& before, const Rig& edited) {
  const Renames primitives = renamesOf(before.primitives, edited.primitives);
  const Renames groups = renamesOf(before.groups, edited.groups);
  const Renames lines = renamesOf(before.lines, edited.lines);
  if (primitives.empty() && groups.empty() && lines.empty()) return std::nullopt;
  Rig renamed = before;
  rename(renamed.primitives, edited.primitives, primitives);
  rename(renamed.groups, edited.groups, groups);
  rename(renamed.lines, edited.lines, lines);
  eachReference(renamed, [&](Named kind, std::string& name) {
    if (kind == Named::kChannel) return;
    const Renames& renames = kind == Named::kPrimitive ? primitives : kind == Named::kGroup ? groups : lines;
    if (const auto found = renames.find(name); found != renames.end()) name = found->second;
  });
  return renamed;
}

void IdentitySource::identify(Rig& rig, const Rig& before) {
  complete(rig.primitives, before.primitives, lastPrimitive_);
  complete(rig.groups, before.groups, lastGroup_);
  complete(rig.lines, before.lines, lastLine_);
}

}  // namespace sinew
