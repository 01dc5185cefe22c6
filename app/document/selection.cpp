// app/document/selection.cpp: what the designer has picked.

#include "app/document/selection.h"

#include <algorithm>
#include <utility>

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

void Selection::setAll(std::span<const std::string> several, bool add) {
  if (add) remove(several);
  else primitives.clear();
  for (const std::string& primitive : several) {
    if (!contains(primitive)) primitives.push_back(primitive);
  }
}

void Selection::remove(std::span<const std::string> several) {
  std::erase_if(primitives, [&](const std::string& name) { return std::ranges::find(several, name) != several.end(); });
}

void Selection::invert(std::span<const std::string> all) {
  std::vector<std::string> others;
  for (const std::string& name : all) {
    if (!contains(name)) others.push_back(name);
  }
  primitives = std::move(others);
}

void Selection::extendTo(const std::string& primitive, std::span<const std::string> shown, bool add) {
  const auto from = std::ranges::find(shown, active());
  const auto to = std::ranges::find(shown, primitive);
  if (from == shown.end() || to == shown.end()) {
    if (add) setAll(std::span(&primitive, 1), true);
    else set(primitive);
    return;
  }
  // The one clicked last is active.
  std::vector<std::string> range(std::min(from, to), std::max(from, to) + 1);
  if (to < from) std::ranges::reverse(range);
  setAll(range, add);
}

void Selection::clear() {
  primitives.clear();
  bone = -1;
}

}  // namespace sinew::app
