// tests/panels/export_error_test.cpp: the last export's error in the viewport, opened from the status line and the
// menu.

#include <algorithm>
#include <chrono>
#include <thread>

#include <glm/geometric.hpp>

#include "app/editor/edit.h"
#include "app/editor/export_commands.h"
#include "app/editor/export_error.h"
#include "core/rig/motion_clip.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSkinnedKind = 1;  // Index into exportKinds(): the fastest.

class ExportErrorView : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    for (const char* name : {"demo.glb", "demo.rig.json"}) {
      fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / name, folder / name);
    }
    open("demo.rig.json");
  }
  void open(const std::string& name) {
    ASSERT_TRUE(openFile(state, folder / name));
    state.open.transport.playing = false;
    settle();
  }
  void exportNow(ExportMesh mesh = ExportMesh::kRefined) {
    run(action("file/export-character"), state);
    chooseKind(state.dialogs, kSkinnedKind);
    state.dialogs.exporting.settings.mesh = mesh;
    state.dialogs.exporting.settings.detail.depth = 2;
    state.dialogs.exporting.settings.weights = ExportWeights::kTransferred;
    state.dialogs.exporting.overwriteAsked = true;
    ASSERT_TRUE(confirmExport(state)) << state.dialogs.exporting.error;
    while (!state.session.exports.empty()) {
      frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    settle();
  }
  [[nodiscard]] const ExportErrorState& error() const { return state.session.exportError; }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(ExportErrorView, ClickOnTheErrorShowsItsTimeAndVertex) {
  EXPECT_FALSE(shown("status/export-error"));
  exportNow();
  ASSERT_TRUE(hasExportError(state));
  EXPECT_FALSE(showsExportError(state)) << "nobody has asked for it";
  click("status/export-error");
  ASSERT_TRUE(showsExportError(state));
  const ErrorFigures& largest = error().last->largest;
  const Transport& transport = state.open.transport;
  EXPECT_EQ(state.character().clips.at(static_cast<std::size_t>(transport.clip)).name, largest.farthest.clip);
  EXPECT_FLOAT_EQ(static_cast<float>(transport.time), largest.farthest.time);
  EXPECT_FALSE(transport.playing);
  // At the time of the largest error, the picture's maximum is that error, at its vertex.
  const std::vector<float>& shownError = shownSurface(state).displacement;
  const auto most = std::ranges::max_element(shownError);
  EXPECT_EQ(most - shownError.begin(), largest.farthest.vertex);
  EXPECT_NEAR(100.0f * *most / state.character().height, largest.largest, 1e-3 * largest.largest);
  EXPECT_NEAR(error().largestNow, largest.largest, 1e-3 * largest.largest);
  for (int i = 0; i < 60; ++i) frame();  // The camera moves there.
  const glm::vec3 place = shownSurface(state).positions.at(static_cast<std::size_t>(largest.farthest.vertex));
  EXPECT_LT(glm::distance(state.view.tools.camera.stand.target, place), 0.1f * state.character().height);
  EXPECT_NE(state.session.messages.back().text.find("\" at "), std::string::npos) << "the message says where, too";
}

TEST_F(ExportErrorView, ExportedMeshReplacesTheLiveMesh) {
  exportNow();
  run(action("view/export-error"), state);
  settle();
  ASSERT_TRUE(shown("legend/export-error"));
  state.open.transport.time = 0.4;
  settle();
  const std::vector<glm::vec3> live = shownSurface(state).positions;
  const std::vector<float> distances = shownSurface(state).displacement;
  const std::uint64_t before = shownRevision(state);
  click("export-error/mesh/exported");
  ASSERT_EQ(error().view, ExportedView::kExported);
  EXPECT_EQ(besideSurface(state), nullptr);
  EXPECT_NE(shownRevision(state), before) << "another picture";
  const Surface& exported = shownSurface(state);
  ASSERT_EQ(exported.positions.size(), live.size());
  EXPECT_EQ(exported.displacement, distances) << "the same colors";
  for (std::size_t v = 0; v < live.size(); ++v) {
    EXPECT_FLOAT_EQ(glm::distance(exported.positions[v], live[v]), distances[v]);
    EXPECT_NEAR(glm::length(exported.normals[v]), 1.0f, 1e-4f);
  }
  EXPECT_GT(error().largestNow, 0.0f);
  click("export-error/close");
  EXPECT_FALSE(showsExportError(state));
  EXPECT_EQ(&shownSurface(state), &state.live->surface());
  EXPECT_FALSE(shown("legend/export-error"));
}

TEST_F(ExportErrorView, ExportedMeshStandsBesideTheLiveMesh) {
  exportNow();
  state.open.transport.time = 0.4;
  run(action("view/export-error"), state);
  settle();
  EXPECT_FALSE(action("view/export-beside").checked(state));
  const std::vector<glm::vec3> live = shownSurface(state).positions;
  click("export-error/mesh/exported");
  const Surface exported = shownSurface(state);
  click("export-error/mesh/side by side");
  ASSERT_TRUE(showsExportBeside(state));
  EXPECT_TRUE(action("view/export-beside").checked(state));
  EXPECT_EQ(shownSurface(state).positions, live) << "the live one stays where muscles are picked";
  const Surface* const beside = besideSurface(state);
  ASSERT_NE(beside, nullptr);
  EXPECT_EQ(beside->refinement, shownSurface(state).refinement);
  EXPECT_EQ(beside->displacement, exported.displacement) << "the same colors";
  EXPECT_EQ(beside->normals, exported.normals);
  ASSERT_EQ(beside->positions.size(), exported.positions.size());
  for (std::size_t v = 0; v < live.size(); ++v) {
    EXPECT_LT(glm::distance(beside->positions[v], exported.positions[v] + error().aside), 1e-5f);
  }
  EXPECT_FLOAT_EQ(error().aside.y, 0.0f) << "both stand on the floor";
  run(action("view/export-beside"), state);
  settle();
  EXPECT_EQ(besideSurface(state), nullptr);
  EXPECT_TRUE(showsExportError(state)) << "the live one alone is left";
}

TEST_F(ExportErrorView, MeshesDoNotOverlapInAnyStandardView) {
  exportNow();
  run(action("view/export-beside"), state);
  for (const char* from : {"view/front", "view/left", "view/back", "view/right", "view/top", "view/frame-all"}) {
    if (std::string(from) == "view/frame-all") state.view.tools.camera.stand.yaw = 2.3f;  // As a drag would.
    run(action(from), state);
    for (int i = 0; i < 60; ++i) frame();  // The camera moves there.
    const View& view = state.frame.route.view;
    glm::vec2 size(view.size);
    float liveRight = 0.0f, besideLeft = size.x;
    const auto inPicture = [&](const glm::vec3& point) {
      const glm::vec2 pixel(view.toPixel(point));
      EXPECT_TRUE(pixel.x > 0.0f && pixel.y > 0.0f && pixel.x < size.x && pixel.y < size.y) << from;
      return pixel.x;
    };
    for (const glm::vec3& p : shownSurface(state).positions) liveRight = std::max(liveRight, inPicture(p));
    for (const glm::vec3& p : besideSurface(state)->positions) besideLeft = std::min(besideLeft, inPicture(p));
    EXPECT_LT(liveRight, besideLeft) << from;
  }
}

TEST_F(ExportErrorView, LargestErrorIsInViewOnBothMeshes) {
  exportNow();
  run(action("view/export-beside"), state);
  settle();
  click("export-error/largest");
  for (int i = 0; i < 60; ++i) frame();
  const auto vertex = static_cast<std::size_t>(error().last->largest.farthest.vertex);
  const View& view = state.frame.route.view;
  for (const Surface* surface : {&shownSurface(state), besideSurface(state)}) {
    const glm::vec3 pixel = view.toPixel(surface->positions.at(vertex));
    EXPECT_TRUE(pixel.x > 0.0f && pixel.x < static_cast<float>(view.size.x));
    EXPECT_TRUE(pixel.y > 0.0f && pixel.y < static_cast<float>(view.size.y));
  }
}

TEST_F(ExportErrorView, ToastDoesNotCoverTheLegendInASmallWindow) {
  ImGui::GetIO().DisplaySize = {900.0f, 600.0f};
  settle();
  exportNow();
  click("status/export-error");
  ASSERT_TRUE(shown("legend/export-error"));
  say(state, "Exported demo_muscled.glb: RMS 0.073 % of the height, largest 0.88 % in \"Walk\" at 0.30 s");
  settle();
  ASSERT_TRUE(shown("toast"));
  const glm::vec4 toast = widgets().rectangles().at("toast"), plate = widgets().rectangles().at("legend/export-error");
  EXPECT_TRUE(toast.y + toast.w <= plate.y || toast.x >= plate.x + plate.z) << toast.y << " " << plate.y;
  EXPECT_GE(toast.y, state.frame.viewport.y);
}

TEST_F(ExportErrorView, FollowsTheClipTime) {
  exportNow();
  run(action("view/export-error"), state);
  std::vector<float> largest;
  for (const double time : {0.0, 0.2, 0.4}) {
    state.open.transport.time = time;
    settle();
    largest.push_back(error().largestNow);
  }
  EXPECT_NE(largest[0], largest[1]);
  EXPECT_NE(largest[1], largest[2]);
  for (const float one : largest) EXPECT_LE(one, exportErrorRange(state) * 1.5f);
}

TEST_F(ExportErrorView, ErrorAtOriginalVerticesIsInterpolatedToRefinedVertices) {
  exportNow(ExportMesh::kOriginal);
  run(action("view/export-error"), state);
  state.open.transport.time = 0.4;
  settle();
  ASSERT_TRUE(showsExportError(state));
  const Surface& surface = shownSurface(state);
  EXPECT_EQ(surface.displacement.size(), surface.positions.size());
  EXPECT_GT(surface.positions.size(), state.character().mesh.positions.size());
}

TEST_F(ExportErrorView, BelongsToTheExportedCharacter) {
  EXPECT_STREQ(action("view/export-error").enabled(state).reason(), "Export the character first");
  exportNow();
  EXPECT_TRUE(action("view/export-error").enabled(state));
  run(action("view/export-error"), state);
  settle();
  ASSERT_TRUE(showsExportError(state));
  open("demo.rig.json");
  EXPECT_FALSE(showsExportError(state));
  EXPECT_FALSE(action("view/export-error").enabled(state));
  EXPECT_FALSE(shown("status/export-error"));
}

}  // namespace
}  // namespace sinew::app
