// tests/viewport/gpu/surface_on_card_test.cpp: choice between GPU and CPU in the editor; both give the same surface.
#include "app/window/surface_on_card.h"

#include <cstdio>
#include <filesystem>

#include "app/editor/commands.h"
#include "app/editor/open_file.h"
#include "app/viewport/gpu/card_tables.h"
#include "sinew/rig/rig_edit.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::SurfaceBy;

class GpuSurfaceInEditor : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    if (IsSkipped()) return;
    state_.session.preferences.surfaceBy = SurfaceBy::kCard;
    ASSERT_TRUE(app::openFile(state_, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
    state_.open.transport.playing = false;
  }
  /// The window's part of a frame.
  void frame() {
    state_.live->movePose(state_.open.transport);
    ASSERT_TRUE(state_.live->update(state_.document, app::surfaceView(state_)).ok());
    onCard_.follow(state_);
  }
  /// Largest distance between vertices of GPU and CPU, fraction of the height.
  double apart() {
    const Surface& expected = state_.live->surface();
    const std::vector<int>& drawVertex = expected.refinement->drawVertex;
    std::vector<app::card::Drawn> drawn(drawVertex.size());
    glGetNamedBufferSubData(onCard_.drawn()->vertices().buffer, 0,
                            static_cast<GLsizeiptr>(drawn.size() * sizeof(app::card::Drawn)), drawn.data());
    float most = 0.0f;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const auto& at = drawn[i].position;
      const glm::vec3 seen(at[0], at[1], at[2]);
      most = std::max(most, glm::distance(seen, expected.positions[static_cast<std::size_t>(drawVertex[i])]));
    }
    return static_cast<double>(most / state_.character().height);
  }
  void apply(const SmoothingSettings& settings) {
    state_.document.commands.apply("Smoothing", setSmoothing(state_.document.rig(), settings).value());
  }
  [[nodiscard]] const app::SurfaceMakerState& maker() const { return state_.session.surfaceMaker; }

  app::EditorState state_;
  app::SurfaceOnCard onCard_;
};

TEST_F(GpuSurfaceInEditor, FollowsTimeAndEdits) {
  frame();
  ASSERT_NE(onCard_.drawn(), nullptr) << maker().why;
  EXPECT_TRUE(maker().onCard);
  EXPECT_EQ(state_.live->report().refinedTriangles,
            static_cast<int>(onCard_.drawn()->surface().refinement->triangles.size()));
  EXPECT_LT(apart(), 1e-5);
  state_.open.transport.time = 0.4;
  frame();
  EXPECT_EQ(state_.live->report().seconds.total(), 0.0) << "the processor is not asked";
  EXPECT_LT(apart(), 1e-5);
  EXPECT_GT(state_.live->report().seconds.total(), 0.0) << "but by this test";
  state_.document.commands.apply("Delete", removePrimitives(state_.document.rig(), std::vector<int>{0, 1, 2, 3}));
  frame();
  EXPECT_LT(apart(), 1e-5);
  state_.document.commands.undo();
  frame();
  EXPECT_LT(apart(), 1e-5);
  EXPECT_TRUE(maker().onCardSeconds.has_value()) << "of a frame before";
  EXPECT_TRUE(state_.session.messages.empty());
}

TEST_F(GpuSurfaceInEditor, NewDocumentGetsItsOwnSurface) {
  frame();
  ASSERT_TRUE(app::openFile(state_, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "wrapped.rig.json"));
  frame();
  ASSERT_NE(onCard_.drawn(), nullptr) << maker().why;
  EXPECT_LT(apart(), 1e-5);
}

TEST_F(GpuSurfaceInEditor, FallsBackToTheProcessorWithOneMessage) {
  frame();
  SmoothingSettings settings = state_.document.rig().smoothing;
  settings.creaseAngle = 10.0f;
  apply(settings);
  for (int i = 0; i < 3; ++i) {
    state_.open.transport.time = 0.1 * i;
    frame();
    EXPECT_EQ(onCard_.drawn(), nullptr);
    EXPECT_FALSE(maker().onCard);
  }
  ASSERT_EQ(state_.session.messages.size(), 1u);
  EXPECT_NE(state_.session.messages[0].text.find("computed by the processor: the surface has creases"),
            std::string::npos)
      << state_.session.messages[0].text;
  EXPECT_EQ(state_.session.messages[0].count, 1);
  EXPECT_GT(state_.live->surface().report.seconds.total(), 0.0);
  state_.document.commands.undo();
  frame();
  EXPECT_NE(onCard_.drawn(), nullptr) << "the card goes on";
}

TEST_F(GpuSurfaceInEditor, FollowsThePreferences) {
  state_.session.preferences.surfaceBy = SurfaceBy::kProcessor;
  frame();
  EXPECT_EQ(onCard_.drawn(), nullptr);
  EXPECT_EQ(maker().why, "");
  EXPECT_GT(state_.live->report().seconds.total(), 0.0);
  state_.session.preferences.surfaceBy = SurfaceBy::kAutomatic;
  frame();
  EXPECT_NE(maker().why, "");
  if (app::isSoftwareRenderer()) {
    EXPECT_EQ(onCard_.drawn(), nullptr) << "the processor would do the card's work";
  }
  EXPECT_TRUE(state_.session.messages.empty());
}

/// The driver under another name, so that it is timed like a hardware GPU.
class NamedCard {
 public:
  NamedCard() {
    (void)glGetString(GL_RENDERER);  // From now on the driver's own function is in use.
    real_ = epoxy_glGetString;
    epoxy_glGetString = [](GLenum name) {
      return name == GL_RENDERER ? reinterpret_cast<const GLubyte*>("a card") : real_(name);
    };
  }
  ~NamedCard() { epoxy_glGetString = real_; }
  NamedCard(const NamedCard&) = delete;
  NamedCard& operator=(const NamedCard&) = delete;

 private:
  static inline decltype(epoxy_glGetString) real_ = nullptr;
};

TEST_F(GpuSurfaceInEditor, AutomaticKeepsTheFasterOne) {
  const NamedCard named;
  state_.session.preferences.surfaceBy = SurfaceBy::kAutomatic;
  SmoothingSettings settings = state_.document.rig().smoothing;
  settings.creaseAngle = 10.0f;
  apply(settings);
  frame();
  EXPECT_NE(maker().why.find("creases"), std::string::npos) << maker().why << ": it cannot be measured";
  EXPECT_EQ(onCard_.drawn(), nullptr);
  state_.document.commands.undo();
  frame();
  const std::string first = maker().why;
  double card = 0.0, processor = 0.0;
  ASSERT_EQ(std::sscanf(first.c_str(), "measured: %lf ms on the card, %lf ms", &card, &processor), 2) << first;
  EXPECT_GT(card, 0.0);
  EXPECT_GT(processor, 0.0);
  if (card != processor) {
    EXPECT_EQ(onCard_.drawn() != nullptr, card < processor) << first;
  }
  // Timed once for each document.
  state_.open.transport.time = 0.3;
  frame();
  EXPECT_EQ(maker().why, first);
  EXPECT_TRUE(state_.session.messages.empty()) << "nobody asked for the card";
}

}  // namespace
}  // namespace sinew::test
