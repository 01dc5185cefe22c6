// app/viewport/tools/camera.h: the orbit camera: a value, functions that move it, and the View it gives.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "app/viewport/render/view.h"

namespace sinew::app {

// The parts of a picture that nothing lies over.

inline constexpr float kLeastPart = 0.35f;  ///< Least width and height, fractions of the picture.

/// Uncovered rectangles, among them all maximal ones: low x and y, high x and y, 0..1 of the picture. If none is large
/// enough, ignores the largest covers.
[[nodiscard]] std::vector<glm::vec4> freeParts(std::span<const glm::vec4> covered);

enum class StandardView { kFront, kBack, kLeft, kRight, kTop, kBottom };

/// Position and direction of a camera. Characters face +Z, so yaw 0 shows the front.
struct CameraStand {
  glm::vec3 target{0.0f, 0.9f, 0.0f};  ///< World.
  float distance = 4.0f;               ///< From target to eye, > 0; also scales orthographic pictures.
  float yaw = 0.5f;                    ///< Radians; grows as the eye goes from +Z to +X.
  float pitch = 0.2f;                  ///< Radians, -pi/2..pi/2; positive: the eye is above.
  glm::vec2 aim{0.0f};  ///< Position of the target in the picture, -1..1, right and up. Does not rotate the eye.
};

struct CameraTransition {
  CameraStand from;
  CameraStand to;
  float elapsed = 0.0f;  ///< Seconds, of kCameraTransitionSeconds.
};

inline constexpr float kCameraTransitionSeconds = 0.24f;
inline constexpr float kNearestView = 0.02f;    ///< Smallest distance, of H.
inline constexpr float kFarthestView = 60.0f;   ///< Largest distance, of H.
inline constexpr float kAlmostAsLarge = 1.08f;  ///< Factor on distances that look alike when framing.

struct Camera {
  CameraStand stand;
  std::optional<CameraTransition> transition;
  bool orthographic = false;
  float characterHeight = 1.8f;                            ///< H: scales limits and clipping planes.
  Bounds scene{{-0.5f, 0.0f, -0.5f}, {0.5f, 1.8f, 0.5f}};  ///< World, never clipped; may be empty.
};

/// Sets limits and clipping planes for a character without moving.
void setScene(Camera& camera, const Bounds& boundsInWorld, float characterHeight);

// Drags are in pixels of a picture of `size`. They stop a transition.
/// A drag across the height of the picture is half a rotation. Pitch stops at the poles.
void orbit(Camera& camera, const glm::vec2& drag, const glm::ivec2& size);
void pan(Camera& camera, const glm::vec2& drag, const glm::ivec2& size);  ///< The target's plane follows the pointer.
/// One step is 12 %. The point at the pixel stays: `pointInWorld`, or the point in the target's plane.
void zoomToward(Camera& camera, float steps, const glm::vec2& pixel, const glm::ivec2& size,
                const std::optional<glm::vec3>& pointInWorld);

/// Shows a whole box with a margin, from the current direction. Ignores empty boxes.
/// @param covered  parts of the picture to avoid: low x and y, high x and y, 0..1 from the top left. The box is framed
/// in the free part that shows it largest, or nearly so with more room around it.
void frameBounds(Camera& camera, const Bounds& boundsInWorld, const glm::ivec2& size, bool animated,
                 std::span<const glm::vec4> covered = {});
/// Looks along an axis at the current target. kLeft: the character's left, with the eye on +X.
void showStandardView(Camera& camera, StandardView view);
bool advance(Camera& camera, float deltaSeconds);  ///< Advances a transition. @return whether the camera still moves
[[nodiscard]] inline bool isMoving(const Camera& camera) { return camera.transition.has_value(); }

/// Matrices of the current position. Near and far planes depend on the distance and the scene's bounds.
[[nodiscard]] View viewOf(const Camera& camera, const glm::ivec2& size);

}  // namespace sinew::app
