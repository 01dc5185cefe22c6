// app/command/inspect_facts.h: what `inspect` tells of a character or rig, counted and named.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "core/bodies/body_map.h"
#include "core/files/json/json.h"
#include "core/geometry/weld.h"
#include "core/rig/attachment.h"

namespace sinew::app {

/// The mesh as it is bound, and the same joined where separately moving parts touch: only there do edges with more than
/// two triangles show that no single part has.
struct MeshFacts {
  Topology bound;
  ControlMesh joined;
  Topology touching;
  float tolerance = 0.0f;  ///< Of the joining, units of the character.
  std::size_t coloredWedges = 0;
};

struct RigFacts {
  std::vector<std::string> lines;
  std::vector<std::string> channels;  ///< Each name once.
  std::vector<std::string> unattached;
  std::vector<MissingBone> missing;
  std::vector<std::string> missingShapes;  ///< That the rig changes and the character lacks.
  std::vector<std::string> missingParts;   ///< Whose layer the rig names and the character lacks.
  std::size_t shaped = 0;                  ///< Muscles that are no plain ellipsoids.
  std::size_t keys = 0;                    ///< Of all numbers, in all clips.
  std::size_t keyed = 0;                   ///< Numbers that have them.
  std::size_t drivers = 0;
  std::vector<Wedge> shadedWedges;  ///< As the rig's crease angle splits them.
};

struct InspectFacts {
  const Document& document;
  MeshFacts mesh;
  std::vector<std::string> helpers;  ///< Joints that move no skin.
  std::vector<std::string> shapes;   ///< Morph targets, each name once.
  float rangeOfMotion = 0.0f;        ///< Seconds; 0: nothing can turn.
  BodySlots body{};
  std::vector<SkinLayer> layers{};  ///< [parts]
  std::vector<bool> isGuessed{};    ///< [parts] the rig does not say so.
  RigFacts rig{};                   ///< Empty for a character without a rig.

  [[nodiscard]] bool hasRig() const { return !document.rigFile.empty(); }
};

/// @param document  outlives the facts
[[nodiscard]] InspectFacts factsOf(const Document& document);

/// A file's lines for people, or its object. @param file  as it was named
[[nodiscard]] std::string inspectText(const InspectFacts& facts);
[[nodiscard]] Json inspectJson(const InspectFacts& facts, const std::string& file);

/// A line of the table of several files, and the line above all.
[[nodiscard]] std::vector<std::string> inspectRow(const InspectFacts& facts, const std::string& file);
[[nodiscard]] std::vector<std::string> inspectHead();

}  // namespace sinew::app
