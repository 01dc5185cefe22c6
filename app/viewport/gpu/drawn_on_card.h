// app/viewport/gpu/drawn_on_card.h: a character's surface computed and drawn on the graphics card.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewport/gpu/card_surface.h"
#include "app/viewport/render/scene.h"
#include "core/surface/posed_field.h"
#include "sinew/geometry/geometry.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// Bounds of a surface that is not read back: a skinned vertex lies between the places that its bindings give it.
class CarriedBounds {
 public:
  explicit CarriedBounds(const Character& character);

  /// Contains the surface of a pose: the skin, the bulge of its patches, and the muscles.
  /// @param matrices [bindings] from the bind pose to the pose
  [[nodiscard]] Bounds at(std::span<const glm::mat4> matrices, std::span<const PosedPrimitive> muscles) const;

 private:
  std::vector<Bounds> boxes_;  ///< [bindings] bind pose.
  float bulge_ = 0.0f;         ///< World.
};

/// For one preparation. Needs the OpenGL context in which it was created to be current.
class DrawnOnCard {
 public:
  /// Error: leftToProcessor, or a buffer is too large for the card.
  [[nodiscard]] static Result<std::unique_ptr<DrawnOnCard>> create(std::shared_ptr<const StagePrograms> programs,
                                                                   std::shared_ptr<const Preparation> preparation);
  /// Creates programs and preparation itself. Error: also a shader or rig that is refused.
  [[nodiscard]] static Result<std::unique_ptr<DrawnOnCard>> create(std::shared_ptr<const Character> character,
                                                                   const Rig& rig);
  DrawnOnCard(const DrawnOnCard&) = delete;
  DrawnOnCard& operator=(const DrawnOnCard&) = delete;

  [[nodiscard]] std::optional<std::string> make(const Pose& pose);  ///< @return why it needs the processor, or nullopt
  /// For Scene::surface: refinement and classes without vertices.
  [[nodiscard]] const Surface& surface() const { return shell_; }
  [[nodiscard]] const CardVertices& vertices() const { return vertices_; }
  [[nodiscard]] const Preparation& preparation() const { return card_.preparation(); }
  /// Times of the last make(), when finished.
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
