// app/document/playback.h: clip time -> pose -> surface.
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
#include "sinew/geometry/result.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

inline constexpr double kFrameSeconds = 1.0 / 30.0;  ///< What "one frame" of a clip is when stepping.

/// Which moment is shown. View state: not part of the document.
struct Transport {
  int clip = -1;      ///< Index into Character::clips, or -1: the bind pose.
  double time = 0.0;  ///< Seconds, 0..duration.
  bool playing = false;
  bool loop = true;
  float speed = 1.0f;         ///< Factor, 0.1..4.
  PlayRanges ranges{};        ///< Playing keeps to these parts of clips; through setPlayRange.
  PoseOverrides overrides{};  ///< Joints turned by hand, on top of the clip.
  float flex = 0.0f;          ///< Pose::flex, and the next Pose::flexedLines.
  std::vector<int> flexedLines{};
};

/// Length of the chosen clip, seconds; 0 for the bind pose.
[[nodiscard]] double clipDuration(const Transport& transport, const Character& character);

/// What plays of the chosen clip: its range, else all of it.
[[nodiscard]] PlayRange playRange(const Transport& transport, const Character& character);

/// Whether a part of the chosen clip plays, not all of it.
[[nodiscard]] bool hasPlayRange(const Transport& transport);

/// At least one frame long, on whole frames, within the clip; all of the clip is no range.
void setPlayRange(Transport& transport, const PlayRange& range, const Character& character);

/// Time passes. At the end of what plays a looping clip goes on from the beginning by what was left over, another stops
/// there. A moment after the end of the range plays on to the clip's end.
void advance(Transport& transport, double seconds, const Character& character);

/// One clip frame (kFrameSeconds) onwards or back, landing on whole frames; wraps when looping; pauses.
void stepFrames(Transport& transport, int frames, const Character& character);

/// Chooses a clip (or -1) from its start, or the start of its range. Keeps `playing` for a clip that moves.
void chooseClip(Transport& transport, int clip, const Character& character);

/// Plays or pauses; a clip that stands at the end of what plays starts over. The bind pose cannot play.
void togglePlaying(Transport& transport, const Character& character);

/// The pose the transport points at, turned joints and all: the one place where the editor's poses are made.
[[nodiscard]] Pose poseAt(const Transport& transport, const Character& character);

/// What the surface's picture asks of it. View state: none of it touches the rig.
struct SurfaceView {
  std::optional<glm::vec3> eye;  ///< World: skip what cannot be seen from here (Smoother::smooth); none: all is made.
  float heightPixels = 0.0f;     ///< The character's H as seen: detail follows it where the rig says so; 0: unknown.
  std::vector<int> hidden{};     ///< Rig indices of muscles that are left out of the surface, ascending.
  bool onCard = false;           ///< The graphics card makes what is drawn: this surface waits until it is asked for.
};

/// The surface kept in step with rig and time: prepares after an edit, smooths after an edit, when time has moved, or
/// when an eye it was made for has.
class LiveSurface {
 public:
  /// Error: the rig cannot be prepared for its character.
  [[nodiscard]] static Result<LiveSurface> create(const Document& document, const Transport& transport);

  /// Brings the pose to the transport's moment; the surface follows with the next update().
  void movePose(const Transport& transport);

  /// Brings the surface up to date with rig, pose and view. True if it changed. Error: the rig was refused; the surface
  /// then goes on with the last rig that was accepted, and the same rig is not tried again.
  /// @param document  of the character that this was created with
  [[nodiscard]] Result<bool> update(const Document& document, const SurfaceView& view = {});

  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// Of the last update(); made now where it waited (SurfaceView::onCard). The bytes are the same either way.
  [[nodiscard]] const Surface& surface() const;
  /// On surface(). While that waits: what is known without it, and no times.
  [[nodiscard]] const SmoothingReport& report() const { return made_.surface.report; }
  /// Of the last rig that was accepted.
  [[nodiscard]] const std::shared_ptr<const Preparation>& preparation() const { return preparation_; }
  /// [parts] What the character's parts are where the rig does not say.
  [[nodiscard]] const std::vector<SkinLayer>& guessedLayers() const { return tables_->guessedLayers; }
  /// In use: the rig's, or what its size on screen asks for. Differs from the surface's while a rig is refused.
  [[nodiscard]] int depth() const { return detail_.depth; }
  [[nodiscard]] float tolerance() const { return detail_.tolerance; }
  /// Counts smoothings: what a picture of the surface compares.
  [[nodiscard]] std::size_t revision() const { return revision_; }
  [[nodiscard]] double prepareSeconds() const { return prepareSeconds_; }

 private:
  explicit LiveSurface(std::shared_ptr<const Character> character);
  /// @param rig  posed by the preparation's poser
  void smooth(const PosedRig& rig, double posingSeconds) const;
  /// What is given to prepare() in place of the rig's own.
  struct Detail {
    int depth = 0;  ///< 0: nothing was given yet.
    float tolerance = 0.0f;
    friend bool operator==(const Detail&, const Detail&) = default;
  };
  /// Follows the size on screen where the rig asks for it and the size is known; else keeps still, or is the rig's.
  [[nodiscard]] Detail detailFor(const SmoothingSettings& settings, float heightPixels) const;
  [[nodiscard]] Result<bool> prepareIfChanged(const Document& document, const Detail& detail,
                                              const std::vector<int>& hidden);

  std::shared_ptr<const CharacterTables> tables_;
  std::shared_ptr<const Preparation> preparation_;  ///< Preparation of the last rig that was accepted.
  BlendingGraphMemo graphs_;
  Pose pose_;
  /// The processor's surface, which may wait for someone to ask.
  struct Made {
    SmoothingMemory memory;
    PosedRig rig;  ///< The accepted rig in pose_, where the document has not posed it.
    Surface surface;
    bool waits = false;  ///< For rig, pose and eye of the last update().
  };
  mutable Made made_;
  std::size_t revision_ = 0;
  float meanEdge_ = 0.0f;                ///< Mean edge of the control mesh, fraction of H.
  Detail detail_;                        ///< Last given to prepare().
  bool followed_ = false;                ///< detail_ came from the size on screen.
  bool keptLevels_ = false;              ///< Levels of adaptive detail are those from before the drag.
  std::optional<std::size_t> triedRig_;  ///< CommandStack::revision() last given to prepare().
  Result<void> valid_;                   ///< Whether that rig is.
  std::vector<int> hidden_;              ///< Last left out of what was given to prepare().
  std::optional<glm::vec3> eye_;         ///< What the surface is made for.
  std::optional<Transport> posed_;       ///< What pose_ shows: clip, time, turned joints and flex count.
  bool moved_ = false;                   ///< pose_ is newer than the last update().
  double prepareSeconds_ = 0.0;
};

}  // namespace sinew::app
