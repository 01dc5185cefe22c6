// app/viewport/gpu/drawn_on_card.h: a character's surface made on the graphics card and drawn from there.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/viewport/gpu/card_bounds.h"
#include "app/viewport/gpu/card_surface.h"
#include "app/viewport/render/card_vertices.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

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
