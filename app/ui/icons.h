// app/ui/icons.h: icons drawn as vectors, without an icon font.
#pragma once

#include <cstddef>

#include <imgui.h>

namespace sinew::app {

enum class Icon {
  kNone,
  kSelect,
  kMove,
  kRotate,
  kScale,
  kAddMuscle,
  kMuscleLine,
  kSheet,
  kPlay,
  kPause,
  kNext,
  kPrevious,
  kStart,
  kLoop,
  kEnd,
  kPose,
  kPlus,
  kClose,
  kBone,
  kMuscle,
  kCarve,
  kAxes,
  kFolder,
  kFile,
  kBack,
  kForward,
  kUp,
  kNewFolder,
  kHidden,
  kNote,
  kWarning,
  kError,
  kCopy,
  kMinimize,
  kSymmetry,
  kBox,
  // Marks of the outliner, the groups and the territory.
  kEye,
  kEyeShut,
  kLock,
  kUnlocked,
  kSolo,
  kFilter,
  kMatrix,
  kGraph,
  kArrange,
  kBefore,
  kTerritory,
  kFoldOpen,
  kFoldClosed,
  kReset,
};
inline constexpr std::size_t kIconCount = static_cast<std::size_t>(Icon::kReset) + 1;

/// @param topLeft, size  of a square, screen coordinates
void drawIcon(ImDrawList& list, Icon icon, const ImVec2& topLeft, float size, ImU32 color);

}  // namespace sinew::app
