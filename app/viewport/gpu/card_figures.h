// app/viewport/gpu/card_figures.h: `sinew bench gpu`: speed and result of the graphics card against the processor.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "app/viewport/gpu/card_surface.h"
#include "app/viewport/gpu/surface_parts.h"
#include "core/files/json/json.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// Differences between the card's surface and the processor's; the largest of roots, surface and normals.
struct CardDifference {
  double roots = 0.0;    ///< Before folds are removed, fraction of the height.
  double surface = 0.0;  ///< Fraction of the height.
  double normals = 0.0;  ///< Degrees.
  int farVertices = 0;   ///< More than 1e-4 of the height away.
  int farNormals = 0;    ///< More than 1 degree away.
  int notNumbers = 0;    ///< Vertices with a NaN or an infinity.
  int vertices = 0;      ///< Compared over all poses.
  int unsure = 0;        ///< Roots that the card computed in double precision.
  int turned = 0;        ///< Refined triangles that face against their corners' normals.
  int turnedOnProcessor = 0;

  void add(const CardDifference& other);
};

struct CardFigures {
  int vertices = 0;  ///< Per body.
  int triangles = 0;
  int bodies = 1;              ///< Computed per frame.
  int together = 1;            ///< Bodies in one batch.
  PartSeconds card{};          ///< Medians over the frames, all bodies, from the card's timers.
  double cardWhole = 0.0;      ///< With posing and upload, from the processor's clock.
  StageSeconds processor;      ///< Medians for one body.
  CardDifference difference;   ///< First bodies of the first frames.
  std::size_t tableBytes = 0;  ///< On the card, for the preparation.
  std::size_t bodyBytes = 0;   ///< On the card, per body.
  std::size_t poseBytes = 0;   ///< Uploaded per body and frame.
};

class CardSurface;

/// One pose on both. Error: it needs the processor. @param card  with this preparation; its first body is compared
[[nodiscard]] Result<CardDifference> compareWithProcessor(const std::shared_ptr<const Preparation>& preparation,
                                                          const Pose& pose, CardSurface& card);

/// @param frames  at least one; body b is at frame i + b, modulo count. Error: the card does not compute this surface.
[[nodiscard]] Result<CardFigures> measureCard(const StagePrograms& programs,
                                              const std::shared_ptr<const Preparation>& preparation,
                                              std::span<const Pose> frames, int bodies);

/// Report for the terminal. @param name  of the scene
[[nodiscard]] std::string textOf(const std::string& name, const CardFigures& figures);
[[nodiscard]] Json jsonOf(const std::string& name, const CardFigures& figures);  ///< See docs/formats.md.

}  // namespace sinew::app
