// app/command/inspect_facts.h: what `inspect` reports about a character or rig.
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

/// Topology of the mesh as it is bound, and joined where separately moving parts touch: only the joined one shows edges
/// where triangles of several parts meet.
struct MeshFacts {
  Topology bound;
  ControlMesh joined;
  Topology touching;
  float tolerance = 0.0f;  ///< For joining, in units of the character.
  std::size_t coloredWedges = 0;
};

struct RigFacts {
  std::vector<std::string> lines;
  std::vector<std::string> channels;  ///< Each name once.
  std::vector<std::string> unattached;
  std::vector<MissingBone> missing;
  std::vector<std::string> missingShapes;  ///< In the rig only.
  std::vector<std::string> missingParts;   ///< With a layer in the rig only.
  std::size_t shaped = 0;                  ///< Muscles that are not plain ellipsoids.
  std::size_t keys = 0;                    ///< Of all numbers, in all clips.
  std::size_t keyed = 0;                   ///< Numbers with keys.
  std::size_t drivers = 0;
  std::vector<Wedge> shadedWedges;  ///< As the rig's crease angle splits them.
};

struct InspectFacts {
  const Document& document;
  MeshFacts mesh;
  std::vector<std::string> helpers;  ///< Joints that move no skin.
  std::vector<std::string> shapes;   ///< Morph targets, each name once.
  float rangeOfMotion = 0.0f;        ///< Seconds; 0: no joint can turn.
  BodySlots body{};
  std::vector<SkinLayer> layers{};  ///< [parts]
  std::vector<bool> isGuessed{};    ///< [parts] not set by the rig.
  RigFacts rig{};                   ///< Empty for a character without a rig.

  [[nodiscard]] bool hasRig() const { return !document.rigFile.empty(); }
};

[[nodiscard]] InspectFacts factsOf(const Document& document);  ///< The document must outlive the facts.

/// The text for people, or the JSON object. @param file  as given
[[nodiscard]] std::string inspectText(const InspectFacts& facts);
[[nodiscard]] Json inspectJson(const InspectFacts& facts, const std::string& file);

/// A row of the table for several files, and its head.
[[nodiscard]] std::vector<std::string> inspectRow(const InspectFacts& facts, const std::string& file);
[[nodiscard]] std::vector<std::string> inspectHead();

}  // namespace sinew::app
