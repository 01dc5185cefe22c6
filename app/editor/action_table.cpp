// app/editor/action_table.cpp: every action there is, menu by menu.

#include "app/editor/action_table.h"

#include <vector>

namespace sinew::app {
namespace {

constexpr Menu kMenus[] = {{"file", "File"}, {"edit", "Edit"}, {"muscles", "Muscles"}, {"view", "View"},
                           {"tool", "Tool"}, {"play", "Play"}, {"window", "Window"},   {"help", "Help"}};

std::vector<Action> allActions() {
  std::vector<Action> all;
  for (const std::span<const Action> menu :
       {table::fileActions(), table::editActions(), table::muscleActions(), table::viewActions(), table::toolActions(),
        table::playActions(), table::windowActions(), table::helpActions()}) {
    all.insert(all.end(), menu.begin(), menu.end());
  }
  return all;
}

}  // namespace

std::span<const Menu> menus() { return kMenus; }

std::span<const Action> actions() {
  static const std::vector<Action> all = allActions();
  return all;
}

}  // namespace sinew::app
