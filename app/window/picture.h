// app/window/picture.h: the viewport's picture with the gizmo over it, redrawn only when it changes.
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

// The finished frame on its way to the window; what has not changed is not drawn again.

/// Draws the interface into the window's back buffer. Where the processor draws, a pixel of the interface costs as much
/// as one of the picture: there only the changed parts are drawn, over the frame before. A graphics processor draws
/// all.
class Screen {
 public:
  Screen();

  /// @param parts  of the picture that have changed; window coordinates
  /// @param covered  by the picture, which lets nothing shine through: low x and y, high x and y; window coordinates
  /// @param still  the window shows the frame before, and an equal one need not be shown again
  /// @return whether there is a frame to be shown, by swapping the buffers.
  [[nodiscard]] bool draw(ImDrawData& data, const glm::ivec2& size, std::span<const TextureRevision> textures,
                          std::span<const glm::vec4> parts, const glm::vec4& covered, bool still);
  /// The frame of draw() was shown: looks at what the back buffer holds now. Nothing waits to be drawn just then; later
  /// the look would wait for the picture.
  void noteShown();
  /// Draws all of the next frame: fonts or another texture with a known revision were made anew.
  void forget() { tiles_ = {}; }

 private:
  bool software_ = false;
  ChangedTiles tiles_;
  int mark_ = 0;  ///< What the frame before has left in a corner of the back buffer.
};

// How fine the picture is drawn while it moves.

/// What a frame took, seconds.
struct FrameCost {
  double drawing = 0.0;  ///< The picture and the window: what a lower resolution makes cheaper.
  double other = 0.0;    ///< Interface, pose, surface.
  double hidden = 0.0;   ///< Of `other`: while the picture before may have been drawn. 0..other.
};

/// Lowers the resolution of a moving picture step by step until frames keep to kFrameGoal, and raises it where they
/// would keep to it on a finer step too. A function of the times given to it and of nothing else.
class MovingResolution {
 public:
  static constexpr double kFrameGoal = 1.0 / 42.0;  ///< Seconds; a little below what is aimed at, 40 a second.
  static constexpr std::array<float, 5> kScales{1.0f, 0.85f, 0.72f, 0.61f, 0.52f};  ///< Factors on width and height.
  static constexpr std::size_t kFewFrames = 3;    ///< Slow ones in a row: a step down.
  static constexpr std::size_t kManyFrames = 20;  ///< Fast ones in a row: a step up.

  /// A frame was drawn at scale() while the picture moved.
  void add(const FrameCost& cost);
  /// Scale of the next moving picture. Kept from one movement to the next: they cost about the same.
  [[nodiscard]] float scale() const { return kScales[step_]; }
  /// Seconds that drawing may take after all else: at least half of the goal, so that a slow surface does not make a
  /// picture coarse that is not the reason.
  [[nodiscard]] static double room(double other);

 private:
  void change(std::size_t step);

  std::size_t step_ = 0;
  std::size_t slow_ = 0;  ///< Frames in a row.
  std::size_t fast_ = 0;
  double least_ = 0.0;  ///< Drawing of the slow ones.
};

/// Everything the picture depends on; equal keys, equal pictures.
struct PictureKey {
  std::size_t document = 0;
  std::size_t surface = 0;
  View view;
  DisplaySettings display;
  std::vector<PrimitiveShape> shapes;
  std::vector<float> territory;  ///< Scene::territory.
  std::vector<int> territoryBones;
  std::vector<LitPart> litParts;  ///< Scene::litParts.
  int selectedBone = -1;
  int hoveredBone = -1;
  std::vector<bool> hiddenBones;  ///< Scene::hiddenBones.
  std::vector<ReferencePlane> references;
  bool onCard = false;  ///< The surface is the graphics card's.

  friend bool operator==(const PictureKey&, const PictureKey&) = default;
};

/// Draws the document into the viewport's texture and puts that, and the gizmo, into a draw list.
class Picture {
 public:
  Picture(Viewport& viewport, Thumbnails& thumbnails) : viewport_(viewport), thumbnails_(thumbnails) {}

  /// Without a character: nothing. Times go to state.session.stats. The OpenGL context must be current.
  /// @param card  the surface, if the graphics card has made it; must live until the next call. Null: the processor's.
  /// @param now  seconds on the clock of secondsUntilRefining()
  /// @param moving  as Viewport::draw() has it, for a picture that is drawn anew
  void draw(EditorState& state, const DrawnOnCard* card, const View& view, ImDrawList& list, double now,
            std::optional<float> moving);
  /// The last draw() has drawn a picture.
  [[nodiscard]] bool isNew() const { return new_; }

  /// The texture that draw() shows; a new revision where more has changed than changed() says.
  [[nodiscard]] TextureRevision revision() const { return {viewport_.colorTexture(), revision_}; }

  /// Window coordinates: low x and y, high x and y. Of the last draw().
  [[nodiscard]] const std::vector<glm::vec4>& changed() const { return changed_; }

  /// Seconds until refine() has work, 0: it has; nullopt: the picture is as good as it gets, or there is none.
  [[nodiscard]] std::optional<double> secondsUntilRefining(const EditorState& state, double now) const;
  /// Takes one more sample of a picture that rests. @return whether it shows.
  bool refine(EditorState& state);

  /// Writes the picture with all samples, without what marks hover and selection, as PNG. What is shown is drawn anew
  /// with the next frame.
  Result<void> save(EditorState& state, const std::filesystem::path& file);

  /// Keeps the last picture as the thumbnail of its document as that is on the disk, once for each state of it; not
  /// where there were unsaved changes. draw() does so by itself for a refined picture, and before another document's.
  void keepThumbnail();

 private:
  void render(EditorState& state, PictureKey key, double now, std::optional<float> moving);
  void noteChange(const glm::vec4& shown, bool whole);
  bool showsNow(const EditorState& state) const;

  [[nodiscard]] Scene sceneOf(const EditorState& state, const PictureKey& key) const;

  Viewport& viewport_;
  Thumbnails& thumbnails_;
  const DrawnOnCard* card_ = nullptr;  ///< As given to draw().
  std::filesystem::path file_;         ///< File of the document in the picture; "": it has unsaved changes.
  std::size_t shownDocument_ = 0;
  std::uint64_t revision_ = 0;
  std::vector<glm::vec4> changed_;
  double drawnAt_ = 0.0;
  bool passing_ = false;  ///< What is drawn is one picture of a movement.
  bool new_ = false;
  std::pair<std::filesystem::path, std::filesystem::file_time_type> thumbnailOf_;  ///< The last one kept.
  PictureKey drawn_;
};

}  // namespace sinew::app
