// app/document/playback.h: from clip time to pose to surface.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/document.h"
#include "core/character/pose_override.h"
#include "core/surface/preparation.h"
#include "core/surface/smooth.h"
#include "sinew/character/character.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/geometry/result.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

// Automatic detail: refinement depth or tolerance from the character's size on screen (paper 5).

inline constexpr int kMaxAutoDepth = 8;  ///< Greatest automatic depth: neither the paper (5) nor we gain beyond it.
inline constexpr float kAutoEdgePixels = 8.0f;  ///< Wanted length of a refined edge on screen, pixels.
/// Mean length of the control mesh's edges in the bind pose, as a fraction of the character's height.
[[nodiscard]] float meanEdgeFraction(const ControlMesh& mesh, float height);

/// Depth at which a mean edge is about kAutoEdgePixels long on screen: 1..kMaxAutoDepth. Keeps `current` until the
/// ideal depth is more than 3/4 of a step away, so that small camera movements do not flicker.
/// @param heightPixels  the character's height H on screen  @param current  depth in use, or 0 for none
[[nodiscard]] int autoDepth(float meanEdgeFraction, float heightPixels, int current);

inline constexpr float kAutoErrorPixels = 0.5f;  ///< Allowed distance of adaptive detail from the surface, pixels.

/// Tolerance of adaptive detail that meets kAutoErrorPixels, with the same hysteresis: a power of sqrt(2) within
/// kLeastTolerance..kMostTolerance, so that a moving camera needs few meshes.  @param current  in use, or 0 for none
[[nodiscard]] float autoTolerance(float heightPixels, float current);

inline constexpr double kFrameSeconds = 1.0 / 30.0;  ///< One frame of a clip when stepping.

/// Clip, time and pose that are shown. View state: not part of the document.
struct Transport {
  int clip = -1;      ///< Index into Character::clips, or -1: the bind pose.
  double time = 0.0;  ///< Seconds, 0..duration.
  bool playing = false;
  bool loop = true;
  float speed = 1.0f;         ///< Factor, 0.1..4.
  PlayRanges ranges{};        ///< Parts of clips that play; set by setPlayRange.
  PoseOverrides overrides{};  ///< Joints rotated by hand, on top of the clip.
  float flex = 0.0f;          ///< Pose::flex
  std::vector<int> flexedLines{};
};

/// Length of the chosen clip, seconds; 0 for the bind pose.
[[nodiscard]] double clipDuration(const Transport& transport, const Character& character);

/// The chosen clip's range, else the whole clip.
[[nodiscard]] PlayRange playRange(const Transport& transport, const Character& character);

[[nodiscard]] bool hasPlayRange(const Transport& transport);  ///< The chosen clip has a range.

/// Snaps the range to whole frames, at least one, within the clip. A range of the whole clip is removed.
void setPlayRange(Transport& transport, const PlayRange& range, const Character& character);

/// At the end of the range a looping clip starts over, any other stops. A time after the range plays to the clip's end.
void advance(Transport& transport, double seconds, const Character& character);

/// Moves by whole frames and pauses; wraps when looping.
void stepFrames(Transport& transport, int frames, const Character& character);

/// Chooses a clip (or -1) at the start of its range. Keeps `playing` for a clip that moves.
void chooseClip(Transport& transport, int clip, const Character& character);

/// Plays or pauses; at its end a clip starts over. The bind pose cannot play.
void togglePlaying(Transport& transport, const Character& character);

/// The transport's pose, with joints rotated by hand. All poses of the editor are made here.
[[nodiscard]] Pose poseAt(const Transport& transport, const Character& character);

/// How the view affects the surface. View state.
struct SurfaceView {
  float heightPixels = 0.0f;  ///< The character's height H on screen, for automatic detail; 0: unknown.
  std::vector<int> hidden{};  ///< Rig indices of muscles left out of the surface, ascending.
  bool onCard = false;        ///< The graphics card computes the surface; this one waits until it is needed.
};

/// The document's surface: prepared after an edit, smoothed after an edit or when the time changes.
class LiveSurface {
 public:
  /// Error: the rig cannot be prepared for its character.
  [[nodiscard]] static Result<LiveSurface> create(const Document& document, const Transport& transport);

  /// Poses the character as the transport says; the surface follows with the next update().
  void movePose(const Transport& transport);

  /// Updates the surface to rig, pose and view. @return whether it changed. Error: the rig was refused; the surface
  /// keeps the last accepted rig, and the same rig is not tried again.  @param document  with the same character
  [[nodiscard]] Result<bool> update(const Document& document, const SurfaceView& view = {});

  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// Of the last update(); computed now if it waited (SurfaceView::onCard).
  [[nodiscard]] const Surface& surface() const;
  /// While surface() waits: without times.
  [[nodiscard]] const SmoothingReport& report() const { return made_.surface.report; }
  /// Of the last accepted rig.
  [[nodiscard]] const std::shared_ptr<const Preparation>& preparation() const { return preparation_; }
  /// [parts] Layers where the rig names none.
  [[nodiscard]] const std::vector<SkinLayer>& guessedLayers() const { return tables_->guessedLayers; }
  /// Detail in use; differs from the surface's while a rig is refused.
  [[nodiscard]] int depth() const { return detail_.depth; }
  [[nodiscard]] float tolerance() const { return detail_.tolerance; }
  /// Grows with every change of the surface.
  [[nodiscard]] std::size_t revision() const { return revision_; }
  [[nodiscard]] double prepareSeconds() const { return prepareSeconds_; }

 private:
  explicit LiveSurface(std::shared_ptr<const Character> character);
  void smooth(const PosedRig& rig, double posingSeconds) const;  ///< @param rig  posed by the preparation's poser
  /// Given to prepare() in place of the rig's own.
  struct Detail {
    int depth = 0;  ///< 0: nothing was given yet.
    float tolerance = 0.0f;
    friend bool operator==(const Detail&, const Detail&) = default;
  };
  [[nodiscard]] Detail detailFor(const SmoothingSettings& settings, float heightPixels) const;
  [[nodiscard]] Result<bool> prepareIfChanged(const Document& document, const Detail& detail,
                                              const std::vector<int>& hidden);

  std::shared_ptr<const CharacterTables> tables_;
  std::shared_ptr<const Preparation> preparation_;
  BlendingGraphMemo graphs_;
  Pose pose_;
  /// The processor's surface; `waits` until it is needed.
  struct Made {
    SmoothingMemory memory;
    PosedRig rig;  ///< The accepted rig in pose_, where the document has not posed it.
    Surface surface;
    bool waits = false;  ///< For rig and pose of the last update().
  };
  mutable Made made_;
  std::size_t revision_ = 0;
  float meanEdge_ = 0.0f;                ///< meanEdgeFraction()
  Detail detail_;                        ///< Last given to prepare().
  bool followed_ = false;                ///< detail_ came from the size on screen.
  bool keptLevels_ = false;              ///< Levels of adaptive detail are from before the drag.
  std::optional<std::size_t> triedRig_;  ///< CommandStack::revision() last given to prepare().
  std::vector<int> hidden_;              ///< Last given to prepare().
  std::optional<Transport> posed_;       ///< Of pose_.
  bool moved_ = false;                   ///< pose_ is newer than the last update().
  double prepareSeconds_ = 0.0;
};

}  // namespace sinew::app
