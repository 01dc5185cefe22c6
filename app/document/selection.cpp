// app/document/selection.cpp: what the designer has picked.

#include "app/document/selection.h"

#include <algorithm>
#include <utility>

namespace sinew::app {

bool Selection::contains(PrimitiveId primitive) const {
  return std::ranges::find(primitives, primitive) != primitives.end();
}

PrimitiveId Selection::active() const { return primitives.empty() ? PrimitiveId{} : primitives.back(); }

void Selection::set(PrimitiveId primitive) {
  primitives.assign(1, primitive);
  bone = -1;
}

void Selection::toggle(PrimitiveId primitive) {
  const auto found = std::ranges::find(primitives, primitive);
  if (found != primitives.end()) {
    primitives.erase(found);
  } else {
    primitives.push_back(primitive);
  }
}

void Selection::setAll(std::span<const PrimitiveId> several, bool add) {
  if (add) remove(several);
  else clear();
  for (const PrimitiveId primitive : several) {
    if (!contains(primitive)) primitives.push_back(primitive);
  }
}

void Selection::remove(std::span<const PrimitiveId> several) {
  std::erase_if(primitives, [&](const PrimitiveId id) { return std::ranges::find(several, id) != several.end(); });
}

void Selection::invert(std::span<const PrimitiveId> all) {
  std::vector<PrimitiveId> others;
  for (const PrimitiveId id : all) {
    if (!contains(id)) others.push_back(id);
  }
  primitives = std::move(others);
}

void Selection::clear() {
  primitives.clear();
  bone = -1;
}

}  // namespace sinew::app
