// app/window/picture.h: the viewport's picture with the gizmo over it, redrawn only when it changes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "app/editor/editor_state.h"
#include "app/ui/changed_tiles.h"
#include "app/viewport/gpu/drawn_on_card.h"
#include "app/viewport/render/thumbnails.h"
#include "app/viewport/render/viewport.h"

struct ImDrawList;

namespace sinew::app {

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
