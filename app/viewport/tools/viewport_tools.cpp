// app/viewport/tools/viewport_tools.cpp: the table of tools.

#include "app/viewport/tools/viewport_tools.h"

#include <array>

#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

constexpr std::array<const Tool*, kToolCount> kTools{&kSelectTool, &kAddMuscleTool, &kMuscleLineTool, &kSheetTool,
                                                     &kMoveTool,   &kRotateTool,    &kScaleTool,      &kPoseTool};

}  // namespace

std::string nameOf(ToolKind tool) { return lowerCase(kTools[static_cast<std::size_t>(tool)]->label); }

bool addsMuscles(ToolKind tool) {
  return tool == ToolKind::kAddMuscle || tool == ToolKind::kMuscleLine || tool == ToolKind::kSheet;
}

std::span<const Tool* const, kToolCount> tools() { return kTools; }

const Tool& activeTool(const ViewportTools& state) {
  return state.territoryMode ? kTerritoryTool : *kTools[static_cast<std::size_t>(state.tool)];
}

}  // namespace sinew::app
