// app/editor/reference_commands.cpp: reference pictures.

#include "app/editor/reference_commands.h"

#include <algorithm>
#include <array>
#include <memory>
#include <system_error>
#include <utility>

#include <glm/common.hpp>

#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/picture_commands.h"
#include "app/editor/session.h"
#include "app/viewport/render/view.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array kReferenceViews{StandardView::kFront, StandardView::kBack, StandardView::kLeft,
                                     StandardView::kRight, StandardView::kTop};  ///< ReferenceSide
static_assert(kReferenceViews.size() == kReferenceSides);

ReferenceSide sideSeen(const CameraStand& stand) {
  const glm::vec3 backward = cameraAxes(stand.yaw, stand.pitch)[2];
  const glm::vec3 size = glm::abs(backward);
  if (backward.y > std::max(size.x, size.z)) return ReferenceSide::kTop;
  if (size.z >= size.x) return backward.z >= 0.0f ? ReferenceSide::kFront : ReferenceSide::kBack;
  return backward.x >= 0.0f ? ReferenceSide::kLeft : ReferenceSide::kRight;
}

/// Samples start in the user's folder for pictures.
fs::path folderOfDocument(const Document& document) {
  const fs::path& file = document.file();
  std::error_code ignored;
  return file.empty() || isSample(file) ? picturesFolder() : fs::absolute(file, ignored).parent_path();
}

}  // namespace

void toggleReferencePanel(EditorState& state) {
  ReferenceState& reference = state.open.reference;
  reference.shown = !reference.shown;
  const Camera& camera = state.view.tools.camera;
  if (reference.shown) reference.side = sideSeen(camera.transition ? camera.transition->to : camera.stand);
}

void chooseReferenceSide(EditorState& state, ReferenceSide side) {
  state.open.reference.side = side;
  showStandardView(state.view.tools.camera, kReferenceViews[static_cast<std::size_t>(side)]);
}

void showReferenceDialog(EditorState& state) {
  const fs::path now = state.open.reference.chosen().file;
  showPathDialog(state, DialogKind::kReference, now.empty() ? folderOfDocument(state.document) : now.parent_path(),
                 now.filename().string());
}

std::string takeReference(EditorState& state, const fs::path& file) {
  Result<Image> image = readReference(file);
  if (!image) return image.error().plainText();
  std::error_code ignored;
  ReferencePicture& picture = state.open.reference.chosen();
  picture.file = fs::absolute(file, ignored).lexically_normal();
  picture.pixels = std::make_shared<const Image>(std::move(image).value());
  picture.shown = true;
  return "";
}

void removeReference(EditorState& state) { state.open.reference.chosen() = {}; }

void dropReference(EditorState& state, const fs::path& file) {
  if (!state.open.reference.shown) toggleReferencePanel(state);
  if (const std::string error = takeReference(state, file); !error.empty()) {
    addMessage(state.session, MessageKind::kError, "The picture is not shown: " + error);
  }
}

}  // namespace sinew::app
