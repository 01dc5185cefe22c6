// tests/viewport/gpu/on_card.h: an OpenGL context with the compute shaders, and rigs prepared for it.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/ui/offscreen.h"
#include "app/viewport/gpu/card_figures.h"
#include "app/viewport/gpu/card_surface.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {

/// Tests that compute on the GPU: one context for each test; skipped without one.
class OnCard : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = app::OffscreenContext::create();
    if (!made) GTEST_SKIP() << "left out: " << made.error().text();
    context_ = std::move(made).value();
    auto programs = app::StagePrograms::create();
    ASSERT_TRUE(programs.ok()) << programs.error().text();
    programs_ = std::move(programs).value();
  }

  void TearDown() override {
    if (context_ != nullptr) {
      EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
  }

  [[nodiscard]] const app::StagePrograms& programs() const { return *programs_; }

  static std::shared_ptr<const Preparation> prepared(const std::shared_ptr<const Character>& character,
                                                     const Rig& rig) {
    BlendingGraphMemo graphs;
    auto preparation = prepare(characterTables(character), rig, {}, nullptr, graphs);
    EXPECT_TRUE(preparation.ok());
    return preparation ? preparation.value() : nullptr;
  }

  /// Surface on the GPU; fails if it is left to the CPU.
  [[nodiscard]] app::CardSurface surfaceFor(const std::shared_ptr<const Preparation>& preparation,
                                            const app::CardSurface::Options& options = {}) const {
    auto made = app::CardSurface::create(programs(), preparation, options);
    if (!made) throw std::runtime_error(made.error().text());
    return std::move(made).value();
  }

  /// Drawn vertices, [bodies * D]. Waits for the GPU.
  static std::vector<app::card::Drawn> readDrawn(const app::CardSurface& card, std::size_t bodies = 1) {
    std::vector<app::card::Drawn> drawn(bodies * card.preparation().refinement().drawVertex.size());
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(card.drawnVertices(), 0, static_cast<GLsizeiptr>(drawn.size() * sizeof(app::card::Drawn)),
                            drawn.data());
    return drawn;
  }

  /// The tolerances of docs/performance.md.
  static void expectClose(const app::CardDifference& difference, const std::string& what) {
    EXPECT_LE(difference.roots, 1e-5) << what;
    EXPECT_LE(difference.farVertices, difference.vertices / 1000) << what << ", worst " << difference.surface;
    EXPECT_LE(difference.farNormals, difference.vertices / 1000) << what << ", worst " << difference.normals;
    EXPECT_EQ(difference.notNumbers, 0) << what;
    EXPECT_LE(difference.turned, difference.turnedOnProcessor) << what << ", triangles turned over";
  }

 private:
  std::unique_ptr<app::OffscreenContext> context_;
  std::optional<app::StagePrograms> programs_;
};

}  // namespace sinew::test
