// core/rig/references.cpp: assigns identities to items that edits have added or copied.

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

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
  // If several share an identity, the one with the old name is the original, else the first.
  std::unordered_map<std::uint32_t, const Item*> ownerOf;
  for (const Item& item : items) {
    const std::uint32_t id = item.id().value;
    if (id == 0) continue;
    last = std::max(last, id);  // Identities may come from another source.
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

/// `edited` begins with all items of `before`, under the same names.
template <class Item>
bool onlyAdded(const std::vector<Item>& before, const std::vector<Item>& edited) {
  const auto same = [](const Item& a, const Item& b) { return a.id() == b.id() && a.name == b.name; };
  return std::ranges::mismatch(before, edited, same).in1 == before.end();
}

using Renames = std::unordered_map<std::string, std::string>;

/// Names items as in `edited` and removes those gone there, whose names may be in use. @return former name -> name
template <class Item>
Renames rename(std::vector<Item>& items, const std::vector<Item>& edited) {
  std::unordered_map<std::uint32_t, const std::string*> nameOf;
  for (const Item& item : edited) nameOf.emplace(item.id().value, &item.name);
  std::erase_if(items, [&](const Item& item) { return item.id() && !nameOf.contains(item.id().value); });
  Renames renames;
  for (Item& item : items) {
    if (item.id()) renames.emplace(std::exchange(item.name, *nameOf.at(item.id().value)), item.name);
  }
  return renames;
}

}  // namespace

std::optional<Rig> withNamesOf(const Rig& before, const Rig& edited) {
  if (onlyAdded(before.primitives, edited.primitives) && onlyAdded(before.groups, edited.groups) &&
      onlyAdded(before.lines, edited.lines)) {
    return std::nullopt;
  }
  Rig renamed = before;
  const Renames primitives = rename(renamed.primitives, edited.primitives);
  const Renames groups = rename(renamed.groups, edited.groups);
  const Renames lines = rename(renamed.lines, edited.lines);
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
