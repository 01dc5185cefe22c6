// app/window/picture.h: the viewport's picture with the gizmo, redrawn only when it changes; the frame in the window.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/editor/editor_state.h"
#include "app/ui/changed_tiles.h"
#include "app/viewport/gpu/drawn_on_card.h"
#include "app/viewport/render/thumbnails.h"
#include "app/viewport/render/viewport.h"

struct ImDrawList;
struct ImDrawData;
namespace sinew::app {

/// Draws the interface into the back buffer; without a graphics card only the changed parts, over the last frame.
class Screen {
 public:
  Screen();

  /// @param parts  changed parts of the picture; window coordinates
  /// @param covered  by the opaque picture: low x and y, high x and y; window coordinates
  /// @param still  an unchanged frame need not be shown
  /// @return whether to swap the buffers
  [[nodiscard]] bool draw(ImDrawData& data, const glm::ivec2& size, std::span<const TextureRevision> textures,
                          std::span<const glm::vec4> parts, const glm::vec4& covered, bool still);
  /// Call right after the swap: checks what the back buffer holds; later the check would wait for the picture.
  void noteShown();
  /// Draws all of the next frame, for example after fonts were rebuilt.
  void forget() { tiles_ = {}; }

 private:
  bool software_ = false;
  ChangedTiles tiles_;
  int mark_ = 0;  ///< Of the last frame, in a corner of the back buffer.
};

/// Durations of a frame, seconds.
struct FrameCost {
  double drawing = 0.0;  ///< Picture and window, which a lower resolution makes cheaper.
  double other = 0.0;    ///< Interface, pose, surface.
  double hidden = 0.0;   ///< Part of `other` during which the last picture may have been drawn. 0..other.
};

/// Lowers the resolution of a moving picture step by step until frames meet kFrameGoal, and raises it when they would
/// meet it on a finer step. Depends on the given durations alone.
class MovingResolution {
 public:
  static constexpr double kFrameGoal = 1.0 / 42.0;  ///< Seconds; a little faster than 40 frames a second.
  static constexpr std::array<float, 5> kScales{1.0f, 0.85f, 0.72f, 0.61f, 0.52f};  ///< Factors on width and height.
  static constexpr std::size_t kFewFrames = 3;    ///< Slow frames in a row for a step down.
  static constexpr std::size_t kManyFrames = 20;  ///< Fast frames in a row for a step up.

  void add(const FrameCost& cost);  ///< A frame was drawn at scale() while the picture moved.
  /// Scale of the next moving picture, kept between movements.
  [[nodiscard]] float scale() const { return kScales[step_]; }
  /// Seconds that drawing may take: at least half of the goal, so that a slow surface does not coarsen the picture.
  [[nodiscard]] static double room(double other);

 private:
  void change(std::size_t step);

  std::size_t step_ = 0;
  std::size_t slow_ = 0;  ///< Frames in a row.
  std::size_t fast_ = 0;
  double least_ = 0.0;  ///< Shortest drawing of the slow frames.
};

/// Everything the picture depends on: equal keys, equal pictures.
struct PictureKey {
  std::size_t document = 0;
  std::size_t surface = 0;
  View view;
  DisplaySettings display;
  std::vector<PrimitiveShape> shapes;
  std::vector<float> territory;
  std::vector<int> territoryBones;
  std::vector<LitPart> litParts;
  int selectedBone = -1;
  int hoveredBone = -1;
  std::vector<bool> hiddenBones;
  std::vector<ReferencePlane> references;
  bool onCard = false;  ///< The surface is the graphics card's.

  friend bool operator==(const PictureKey&, const PictureKey&) = default;
};

/// Draws the document into the viewport's texture, and texture and gizmo into a draw list.
class Picture {
 public:
  Picture(Viewport& viewport, Thumbnails& thumbnails) : viewport_(viewport), thumbnails_(thumbnails) {}

  /// Draws nothing without a character. Times go to state.session.stats. The OpenGL context must be current.
  /// @param card  the graphics card's surface, valid until the next call; null: use the processor's
  /// @param now  seconds, for secondsUntilRefining()  @param moving  as for Viewport::draw()
  void draw(EditorState& state, const DrawnOnCard* card, const View& view, ImDrawList& list, double now,
            std::optional<float> moving);
  /// The last draw() drew a new picture.
  [[nodiscard]] bool isNew() const { return new_; }

  /// The texture of draw(); a new revision if more has changed than changed() reports.
  [[nodiscard]] TextureRevision revision() const { return {viewport_.colorTexture(), revision_}; }
  /// By the last draw(): low x and y, high x and y; window coordinates.
  [[nodiscard]] const std::vector<glm::vec4>& changed() const { return changed_; }

  /// Seconds until refine() has work; nullopt: the picture is final, or there is none.
  [[nodiscard]] std::optional<double> secondsUntilRefining(const EditorState& state, double now) const;
  bool refine(EditorState& state);  ///< Adds a sample to a resting picture. @return whether the picture changed

  /// Writes the picture with all samples, without hover and selection, as PNG. The next frame draws the picture again.
  Result<void> save(EditorState& state, const std::filesystem::path& file);

  /// Stores the last picture as its document's thumbnail, once for each state on disk, unless there were unsaved
  /// changes. draw() calls it for a refined picture and before another document.
  void keepThumbnail();

 private:
  void render(EditorState& state, PictureKey key, double now, std::optional<float> moving);
  void noteChange(const glm::vec4& shown, bool whole);
  bool showsNow(const EditorState& state) const;

  [[nodiscard]] Scene sceneOf(const EditorState& state, const PictureKey& key) const;

  Viewport& viewport_;
  Thumbnails& thumbnails_;
  const DrawnOnCard* card_ = nullptr;  ///< Of the last draw().
  std::filesystem::path file_;         ///< The document's; "": it has unsaved changes.
  std::size_t shownDocument_ = 0;
  std::uint64_t revision_ = 0;
  std::vector<glm::vec4> changed_;
  double drawnAt_ = 0.0;
  bool passing_ = false;  ///< The picture is one of a movement.
  bool new_ = false;
  std::pair<std::filesystem::path, std::filesystem::file_time_type> thumbnailOf_;  ///< The last one kept.
  PictureKey drawn_;
};

}  // namespace sinew::app
