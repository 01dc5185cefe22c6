// app/viewport/gpu/drawn_on_card.h: a character's surface made on the graphics card and drawn from there.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewport/gpu/card_surface.h"
#include "app/viewport/render/card_vertices.h"
#include "core/surface/posed_field.h"
#include "sinew/geometry/geometry.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

// A box around a surface whose vertices nobody reads back.

/// What each binding carries of the control mesh: a skinned vertex lies between the places that its bindings give it.
class CarriedBounds {
 public:
  explicit CarriedBounds(const Character& character);

  /// Holds the surface of a pose: the skin, the bulge of its patches, and what muscles add.
  /// @param matrices [bindings] from the bind pose to the pose
  [[nodiscard]] Bounds at(std::span<const glm::mat4> matrices, std::span<const PosedPrimitive> muscles) const;

 private:
  std::vector<Bounds> boxes_;  ///< [bindings] bind pose.
  float bulge_ = 0.0f;         ///< World.
};

/// Serves one preparation. Needs the context it was made in to be current.
class DrawnOnCard {
 public:
  /// Error: leftToProcessor, or a buffer that the card does not hold.
  [[nodiscard]] static Result<std::unique_ptr<DrawnOnCard>> create(std::shared_ptr<const StagePrograms> programs,
                                                                   std::shared_ptr<const Preparation> preparation);
  /// The same with programs and a preparation of its own. Error: also a shader or a rig that is refused.
  [[nodiscard]] static Result<std::unique_ptr<DrawnOnCard>> create(std::shared_ptr<const Character> character,
                                                                   const Rig& rig);
  DrawnOnCard(const DrawnOnCard&) = delete;
  DrawnOnCard& operator=(const DrawnOnCard&) = delete;

  /// Makes the surface of a pose. @return why it is left to the processor, or nullopt
  [[nodiscard]] std::optional<std::string> make(const Pose& pose);
  /// For Scene::surface: refinement and classes, no vertices.
  [[nodiscard]] const Surface& surface() const { return shell_; }
  [[nodiscard]] const CardVertices& vertices() const { return vertices_; }
  [[nodiscard]] const Preparation& preparation() const { return card_.preparation(); }
  /// Of the last make(), once the card has finished it.
  [[nodiscard]] std::optional<PartSeconds> secondsIfDone() const { return card_.secondsIfDone(); }
  [[nodiscard]] PartSeconds seconds() const { return card_.seconds(); }  ///< Waits for the card.

 private:
  DrawnOnCard(std::shared_ptr<const StagePrograms> programs, CardSurface card);

  std::shared_ptr<const StagePrograms> programs_;
  CardSurface card_;
  CarriedBounds bounds_;
  Surface shell_;
  CardVertices vertices_;
};

}  // namespace sinew::app
