// app/viewport/gpu/card_figures.h: the graphics card beside the processor, in time and in place: `sinew bench gpu`.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "app/viewport/gpu/stages.h"
#include "app/viewport/gpu/surface_parts.h"
#include "core/files/json/json.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// How far the card's surface lies from the processor's.
struct CardDifference {
  double roots = 0.0;    ///< Largest, before folds, fraction of the height.
  double surface = 0.0;  ///< Largest, fraction of the height.
  double normals = 0.0;  ///< Largest, degrees.
  int farVertices = 0;   ///< More than 1e-4 of the height away.
  int farNormals = 0;    ///< Turned by more than 1 degree.
  int notNumbers = 0;
  int vertices = 0;  ///< Compared, of all moments.
  int unsure = 0;    ///< Roots that the card left to double precision.
  // Refined triangles that face against the normals at their corners.
  int turned = 0;
  int turnedOnProcessor = 0;

  void add(const CardDifference& other);
};

struct CardFigures {
  int vertices = 0;  ///< Of one body.
  int triangles = 0;
  int bodies = 1;              ///< Made for each frame.
  int together = 1;            ///< ... so many at once.
  PartSeconds card{};          ///< Medians over the frames, all bodies, by the card's own clock.
  double cardWhole = 0.0;      ///< The same with posing and upload, by the processor's clock.
  StageSeconds processor;      ///< Medians, of one body.
  CardDifference difference;   ///< Of the first frames' first bodies.
  std::size_t tableBytes = 0;  ///< On the card: the preparation,
  std::size_t bodyBytes = 0;   ///< and one body.
  std::size_t poseBytes = 0;   ///< Uploaded for one body's frame.
};

class CardSurface;

/// One moment by both. Makes the surface on the card.
/// @param card  of this preparation, one body or more; the first is looked at.  Error: the pose is left to the
/// processor.
[[nodiscard]] Result<CardDifference> compareWithProcessor(const std::shared_ptr<const Preparation>& preparation,
                                                          const Pose& pose, CardSurface& card);

/// Error: the card does not compute this surface.
/// @param frames  at least one; body b of a crowd is at frame i + b, around and around.
/// @param bodies  of a crowd, or 1
[[nodiscard]] Result<CardFigures> measureCard(const StagePrograms& programs,
                                              const std::shared_ptr<const Preparation>& preparation,
                                              std::span<const Pose> frames, int bodies);

/// For people. @param name  of the scene
[[nodiscard]] std::string textOf(const std::string& name, const CardFigures& figures);
/// For programs (docs/formats.md).
[[nodiscard]] Json jsonOf(const std::string& name, const CardFigures& figures);

}  // namespace sinew::app
