// core/include/sinew/rig/muscle_sheet.h: a broad muscle as one object that is laid on the skin as strips of bellies.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sinew/geometry/geometry.h"
#include "sinew/rig/line_anchor.h"
#include "sinew/rig/muscle_line.h"

namespace sinew {

// Ranges of the numbers of a sheet.
inline constexpr int kMostStrips = 16;
inline constexpr int kMostStripBellies = 16;
inline constexpr int kMostEdgePoints = 64;
inline constexpr int kMostSheetEdges = 16;
inline constexpr int kMostSheets = 1024;
inline constexpr float kMostSheetHeight = 0.2f;  ///< Of thickness, width, crest and sunk, fraction of H.
inline constexpr float kMostProfile = 2.0f;      ///< Of the values of profiles, positive or negative.
inline constexpr float kLeastSpacing = 0.3f;
inline constexpr float kMostSpacing = 1.5f;
inline constexpr float kEvenSpacing = 0.644f;  ///< Of grids of bellies whose sum is even (docs/muscles.md, Sheets).

/// A line across the fibres of a sheet, from one of its sides to the other. All edges of a sheet run the same way.
struct SheetEdge {
  std::vector<LineAnchor> points;  ///< Near the skin, 1..kMostEdgePoints. One: all strips meet there.
  std::string unknownKeys;

  friend bool operator==(const SheetEdge&, const SheetEdge&) = default;
};

/// Points (place 0..1, ascending; value), joined by smooth steps; constant outside.
using Profile = std::vector<glm::vec2>;

/// From an origin edge to an insertion edge, with edges between that its fibres pass. docs/muscles.md, Sheets.
///
/// A rig that is in use also has the sheet's bellies and lines (Primitive::sheet, MuscleLine::sheet), which follow from
/// the sheet and the skin (core/bodies/sheets); files have the sheet alone. Lengths are fractions of H, in the bind
/// pose.
struct MuscleSheet {
  std::string name;              ///< Unique among sheets, not empty. Strips are "name 1", bellies "name 1.1".
  std::string group;             ///< Name of a group of the rig.
  std::string mirror;            ///< Name of the linked twin, or empty.
  std::vector<SheetEdge> edges;  ///< Origin first, insertion last, 2..kMostSheetEdges.
  int strips = 3;                ///< Side by side, 1..kMostStrips.
  int bellies = 3;               ///< Along a strip, 1..kMostStripBellies.
  float thickness = 0.018f;      ///< Half height of the bellies, > 0; less where strips are narrow.
  float width = 0.0f;            ///< Half width of a belly; 0: from the distance between strips, which must be several.
  float crest = 0.015f;          ///< Height of the top over the skin where both profiles are 1.
  float sunk = -0.008f;          ///< The same where one of them is 0: ends below the skin leave no rim.
  Profile across{{0.0f, 0.3f}, {0.4f, 1.0f}, {0.6f, 1.0f}, {1.0f, 0.3f}};   ///< From the first to the last strip.
  Profile along{{0.0f, 0.1f}, {0.35f, 1.0f}, {0.65f, 1.0f}, {1.0f, 0.0f}};  ///< From origin to insertion.
  float reach = 1.5f;                                                       ///< As Primitive::reach.
  float spacing = kEvenSpacing;  ///< Distance between bellies over a sqrt(reach^2 - 1), kLeastSpacing..kMostSpacing.
  float amount = 0.0f;           ///< As Primitive::amount; 0: such that the sum at the top is that of one belly.
  int sign = 1;                  ///< As Primitive::sign.
  std::optional<LineSettings> line;  ///< Each strip is on a line of its own; without, its bellies only follow bones.
  std::string unknownLineKeys;
  std::string unknownActivationKeys;
  std::string unknownKeys;

  friend bool operator==(const MuscleSheet&, const MuscleSheet&) = default;
};

/// The value of a profile at a place 0..1; 1 if it has no points.
[[nodiscard]] float profileAt(const Profile& profile, float place);

}  // namespace sinew
