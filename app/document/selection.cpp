// app/document/selection.cpp: what the designer has picked.

#include "app/document/selection.h"

#include <algorithm>

namespace sinew::app {

bool Selection::contains(const std::string& primitive) const {
  return std::ranges::find(primitives, primitive) != primitives.end();
}

const std::string& Selection::active() const {
  static const std::string kNone;
  return primitives.empty() ? kNone : primitives.back();
}

void Selection::set(const std::string& primitive) { primitives.assign(1, primitive); }

void Selection::toggle(const std::string& primitive) {
  const auto found = std::ranges::find(primitives, primitive);
  if (found != primitives.end()) {
    primitives.erase(found);
  } else {
    primitives.push_back(primitive);
  }
}

void Selection::clear() {
  primitives.clear();
  bone = -1;
}

}  // namespace sinew::app
