// app/viewport/tools/camera.h: the orbit camera: a value, functions that move it, and the View it gives.
#pragma once

#include <optional>
#include <span>

#include "app/viewport/render/view.h"

namespace sinew::app {

enum class StandardView { kFront, kBack, kLeft, kRight, kTop, kBottom };

/// Where a camera stands. The eye is `distance` from the target; characters face +Z, so yaw 0 sees them from the front.
struct CameraStand {
  glm::vec3 target{0.0f, 0.9f, 0.0f};  ///< World.
  float distance = 4.0f;               ///< Character units, > 0. Orthographic: sets the size of the picture alike.
  float yaw = 0.5f;                    ///< Radians; grows as the eye goes from +Z to +X.
  float pitch = 0.2f;                  ///< Radians, -pi/2..pi/2; positive: the eye is above.
  /// Where the target is seen: -1..1 of the picture, right and up; 0: in its middle. The eye does not turn for it.
  glm::vec2 aim{0.0f};
};

/// A move between two stands.
struct CameraTransition {
  CameraStand from;
  CameraStand to;
  float elapsed = 0.0f;  ///< Seconds, of kCameraTransitionSeconds.
};

inline constexpr float kCameraTransitionSeconds = 0.24f;
inline constexpr float kNearestView = 0.02f;    ///< Smallest distance, of H.
inline constexpr float kFarthestView = 60.0f;   ///< Largest distance, of H.
inline constexpr float kAlmostAsLarge = 1.08f;  ///< A box that is framed from so many times as far looks as large.

struct Camera {
  CameraStand stand;
  std::optional<CameraTransition> transition;
  bool orthographic = false;
  float characterHeight = 1.8f;                            ///< H: scales limits and clipping planes.
  Bounds scene{{-0.5f, 0.0f, -0.5f}, {0.5f, 1.8f, 0.5f}};  ///< World: what must not be clipped. May be empty.
};

/// Tells the camera about a character: limits and clipping planes follow. Moves nothing.
void setScene(Camera& camera, const Bounds& boundsInWorld, float characterHeight);

/// All drags are in pixels of a picture of `size`. They end a transition where it stands.
/// Dragging right turns the scene right; across the picture's height is half a turn. Pitch stops at the poles.
void orbit(Camera& camera, const glm::vec2& drag, const glm::ivec2& size);
/// What lies in the target's plane stays under the pointer.
void pan(Camera& camera, const glm::vec2& drag, const glm::ivec2& size);
/// One step is 12 %. A point stays at its pixel: `pointInWorld` if given (it should lie under `pixel`), else what is
/// under `pixel` in the target's plane.
void zoomToward(Camera& camera, float steps, const glm::vec2& pixel, const glm::ivec2& size,
                const std::optional<glm::vec3>& pointInWorld);

/// Shows all of a box with a margin, from the present direction. An empty box changes nothing.
/// @param animated false: at once (a character was just opened).
/// @param covered  parts of the picture to stay clear of: low x and y, high x and y, 0..1 from its top left. The box is
///                 framed in the free part that shows it largest, or nearly so with more room around it.
void frameBounds(Camera& camera, const Bounds& boundsInWorld, const glm::ivec2& size, bool animated,
                 std::span<const glm::vec4> covered = {});
/// Looks along an axis at the present target. kLeft is the character's left: the eye on +X.
void showStandardView(Camera& camera, StandardView view);
/// Moves a transition on. @return whether the camera still moves.
bool advance(Camera& camera, float deltaSeconds);
[[nodiscard]] inline bool isMoving(const Camera& camera) { return camera.transition.has_value(); }

/// Matrices of the present stand. Near and far follow the distance and the scene's bounds.
[[nodiscard]] View viewOf(const Camera& camera, const glm::ivec2& size);

}  // namespace sinew::app
