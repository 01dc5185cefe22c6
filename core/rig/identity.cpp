// core/rig/identity.cpp: identities for what edits have added or copied.

#include "core/rig/identity.h"

#include <string_view>
#include <unordered_map>
#include <vector>

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

}  // namespace

void IdentitySource::identify(Rig& rig, const Rig& before) {
  complete(rig.primitives, before.primitives, lastPrimitive_);
  complete(rig.groups, before.groups, lastGroup_);
  complete(rig.lines, before.lines, lastLine_);
}

}  // namespace sinew
