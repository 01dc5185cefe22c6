// tests/panels/layers_test.cpp: the list of mesh parts: its contents, and clicks that change rig and surface.

#include "app/editor/visibility_commands.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/editor/actions.h"
#include "app/ui/code_points.h"
#include "core/rig/mesh_layers.h"
#include "sinew/rig/rig_edit.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

class LayersPanel : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    file_ = test::writeDressedHumanoid(folder_.path());
    state.view.layout.folded = {"surface", "smoothing"};
    open(file_);
  }
  void open(const std::filesystem::path& file) {
    ASSERT_TRUE(openFile(state, file));
    state.open.transport.playing = false;
    settle();
  }
  /// Opens a rig for the dressed body with these layers.
  void openWith(const std::string& layers) {
    const std::filesystem::path rig = folder_.path() / "dressed.rig.json";
    std::ofstream(rig)
        << R"({"format": "sinew-rig", "version": 2, "character": "dressed.glb", "groups": [], "links": [],
      "primitives": [], "layers": )"
        << layers << "}";
    open(rig);
  }
  [[nodiscard]] int part(const std::string& name) const {
    const auto& parts = state.character().parts;
    const auto found = std::ranges::find(parts, name, &MeshPart::name);
    EXPECT_NE(found, parts.end()) << name;
    return static_cast<int>(found - parts.begin());
  }
  [[nodiscard]] SkinLayer layer(const std::string& name) const {
    return partLayers(state)[static_cast<std::size_t>(part(name))];
  }
  /// Adds a ball in the chest, so that skin and cloth differ.
  void addBall() {
    addMuscle(state, state.character().skeleton.findBone("chest").value());
    Placement placement = muscle().placement;
    placement.radii = glm::vec3(0.16f * state.character().height);
    state.document.commands.apply("ball", setPlacementOf(placement));
    state.document.selection.clear();
    settle();
  }
  /// Surface of the document's rig in the shown pose, computed from scratch.
  [[nodiscard]] std::vector<glm::vec3> madeAnew() const {
    Rig rig = state.document.rig();
    Smoother smoother(state.document.character);
    rig.smoothing.autoDepth = false;
    rig.smoothing.depth = state.live->depth();
    rig.smoothing.tolerance = state.live->tolerance();
    EXPECT_TRUE(smoother.prepare(rig).ok());
    Surface surface;
    EXPECT_TRUE(smoother.smooth(state.live->pose(), surface));
    return surface.positions;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_;
};

TEST_F(LayersPanel, ListsEveryPartWithItsGuessedLayer) {
  ASSERT_EQ(state.character().parts.size(), 5u);
  for (const MeshPart& each : state.character().parts) {
    EXPECT_TRUE(shown("layers/part/" + each.name)) << each.name;
    EXPECT_FALSE(shown("layers/guess/" + each.name)) << each.name << " is guessed";
    for (const char* word : {"skin", "cloth", "rigid"}) EXPECT_TRUE(shown("layers/set/" + each.name + "/" + word));
  }
  EXPECT_EQ(partLayers(state), guessLayers(state.character()));
  EXPECT_EQ(layer("Shirt"), SkinLayer::kCloth);
  EXPECT_EQ(layer("Eyes"), SkinLayer::kRigid);
  EXPECT_EQ(steps(), 0u);
}

TEST_F(LayersPanel, IsShownOnlyForSeveralParts) {
  EXPECT_TRUE(shown("layers/header"));
  open(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb");
  EXPECT_FALSE(shown("layers/header"));
  EXPECT_TRUE(shown("smoothing/header"));
}

TEST_F(LayersPanel, ClickIsOneUndoableStep) {
  click("layers/set/Shirt/rigid");
  EXPECT_EQ(layer("Shirt"), SkinLayer::kRigid);
  EXPECT_EQ(steps(), 1u);
  EXPECT_EQ(state.document.commands.label(1), "Layer of Shirt: rigid");
  click("layers/set/Trousers/skin");
  EXPECT_EQ(steps(), 2u);
  ASSERT_EQ(state.document.rig().layers.size(), 2u);
  click("layers/set/Trousers/skin");
  EXPECT_EQ(steps(), 2u) << "it is that already";
  run(action("edit/undo"), state);
  settle();
  EXPECT_EQ(layer("Trousers"), SkinLayer::kCloth);
  EXPECT_FALSE(shown("layers/guess/Trousers"));
  EXPECT_EQ(layer("Shirt"), SkinLayer::kRigid);
  run(action("edit/undo"), state);
  EXPECT_TRUE(state.document.rig().layers.empty());
  run(action("edit/redo"), state);
  settle();
  EXPECT_EQ(layer("Shirt"), SkinLayer::kRigid);
  EXPECT_TRUE(shown("layers/guess/Shirt"));
}

TEST_F(LayersPanel, SurfaceUpdatesImmediatelyEvenDuringPlayback) {
  addBall();
  ASSERT_EQ(state.live->surface().positions, madeAnew());
  const auto cloth = state.live->surface().positions;
  click("layers/set/Shirt/rigid");
  EXPECT_EQ(state.live->surface().positions, madeAnew());
  EXPECT_NE(state.live->surface().positions, cloth) << "the shirt lies still";
  ASSERT_FALSE(state.character().clips.empty());
  chooseClip(state.open.transport, 0, state.character());
  state.open.transport.playing = true;
  settle();
  const double before = state.open.transport.time;
  click("layers/set/Shirt/skin");
  EXPECT_NE(state.open.transport.time, before);
  EXPECT_EQ(layer("Shirt"), SkinLayer::kSkin);
  EXPECT_EQ(state.live->surface().positions, madeAnew());
}

TEST_F(LayersPanel, GuessedLayerCanBePinnedAndUnpinned) {
  addBall();
  const auto before = state.live->surface().positions;
  const std::size_t first = steps();
  click("layers/set/Shirt/cloth");
  EXPECT_EQ(steps(), first + 1);
  ASSERT_EQ(state.document.rig().layers.size(), 1u);
  EXPECT_EQ(state.document.rig().layers[0], (LayerChoice{"Shirt", SkinLayer::kCloth}));
  EXPECT_EQ(state.live->surface().positions, before);
  click("layers/guess/Shirt");
  EXPECT_EQ(steps(), first + 2);
  EXPECT_TRUE(state.document.rig().layers.empty());
  EXPECT_FALSE(shown("layers/guess/Shirt"));
}

TEST_F(LayersPanel, GuessAllClearsAllChoicesInOneStep) {
  click("layers/guess-all");
  EXPECT_EQ(steps(), 0u) << "there is nothing to forget";
  click("layers/set/Shirt/skin");
  click("layers/set/Eyes/cloth");
  click("layers/guess-all");
  EXPECT_EQ(steps(), 3u);
  EXPECT_EQ(partLayers(state), guessLayers(state.character()));
  run(action("edit/undo"), state);
  EXPECT_EQ(layer("Eyes"), SkinLayer::kCloth);
  EXPECT_EQ(layer("Shirt"), SkinLayer::kSkin);
}

TEST_F(LayersPanel, PartsMissingFromTheCharacterAreKeptAndListed) {
  openWith(R"({"Cape": "cloth", "Shirt": "rigid"})");
  EXPECT_EQ(layer("Shirt"), SkinLayer::kRigid);
  EXPECT_TRUE(shown("layers/missing"));
  EXPECT_TRUE(shown("layers/forget/Cape"));
  EXPECT_FALSE(shown("layers/part/Cape"));
  EXPECT_FALSE(shown("layers/forget/Shirt"));
  click("layers/guess/Shirt");
  click("layers/set/Hair/skin");
  ASSERT_GE(findLayer(state.document.rig(), "Cape"), 0);
  ASSERT_EQ(saveTo(state, folder_.path() / "kept.rig.json"), "");
  std::stringstream saved;
  saved << std::ifstream(folder_.path() / "kept.rig.json").rdbuf();
  EXPECT_NE(saved.str().find("\"Cape\""), std::string::npos);
  const std::size_t before = steps();
  click("layers/forget/Cape");
  EXPECT_EQ(steps(), before + 1);
  EXPECT_LT(findLayer(state.document.rig(), "Cape"), 0);
  EXPECT_FALSE(shown("layers/missing"));
  EXPECT_EQ(layer("Hair"), SkinLayer::kSkin);
}

TEST_F(LayersPanel, HoveredRowHighlightsItsPart) {
  queue.move(center("layers/part/Shirt"));
  settle();
  EXPECT_EQ(state.frame.hoveredPart, part("Shirt"));
  EXPECT_EQ(litParts(state), (std::vector<LitPart>{{part("Shirt"), SkinLayer::kCloth, true}}));
  queue.move(center("layers/set/Eyes/skin"));
  settle();
  EXPECT_EQ(litParts(state), (std::vector<LitPart>{{part("Eyes"), SkinLayer::kRigid, true}}));
  queue.move({640.0f, 400.0f});
  settle();
  EXPECT_TRUE(litParts(state).empty());
  EXPECT_EQ(steps(), 0u);
}

TEST_F(LayersPanel, ClickedPartStaysHighlightedUntilClickedAgainOrEscape) {
  click("layers/part/Hair");
  queue.move({640.0f, 400.0f});
  settle();
  EXPECT_EQ(litParts(state), (std::vector<LitPart>{{part("Hair"), SkinLayer::kCloth, false}}));
  click("layers/part/Hair");
  EXPECT_EQ(state.open.layers.chosen, -1);
  click("layers/part/Hair");
  run(action("muscles/body-parts"), state);
  settle();
  press(kEscape);
  EXPECT_EQ(state.open.layers.chosen, -1);
  EXPECT_TRUE(state.open.bodyParts.shown) << "Esc takes one step back at a time";
  press(kEscape);
  EXPECT_FALSE(state.open.bodyParts.shown);
  EXPECT_EQ(steps(), 0u);
  click("layers/part/Hair");
  open(file_);
  EXPECT_EQ(state.open.layers.chosen, -1);
}

TEST_F(LayersPanel, HiddenColumnHighlightsNothing) {
  queue.move(center("layers/part/Shirt"));
  settle();
  ASSERT_GE(state.frame.hoveredPart, 0);
  state.view.layout.rightShown = false;
  settle();
  EXPECT_EQ(state.frame.hoveredPart, -1);
}

TEST_F(LayersPanel, RowsAreNotCutOffAtAnyPanelWidth) {
  click("layers/set/Shirt/rigid");
  for (const float width : {180.0f, 304.0f, 520.0f}) {
    state.view.layout.right = width;
    settle();
    for (const MeshPart& each : state.character().parts) {
      float right = 0.0f;
      for (const char* word : {"skin", "cloth", "rigid"}) {
        const std::string id = "layers/set/" + each.name + "/" + word;
        ASSERT_TRUE(shown(id)) << id << " at " << width;
        const glm::vec4 box = widgets().rectangles().at(id);
        EXPECT_GE(box.x, right - 1.0f) << id;
        EXPECT_GT(box.z, 30.0f) << id;
        right = box.x + box.z;
      }
      EXPECT_LT(right, 1280.0f);
    }
    const glm::vec4 guess = widgets().rectangles().at("layers/guess/Shirt");
    EXPECT_GT(guess.z, 15.0f);
    EXPECT_LE(guess.x + guess.z, 1280.0f);
  }
}

TEST_F(LayersPanel, PaletteFindsPartsAndSetsTheirLayers) {
  state.view.layout.folded.emplace_back("layers");
  state.view.layout.rightShown = false;
  run(action("help/palette"), state);
  settle();
  type("trousers");
  ASSERT_TRUE(shown("palette/part/Trousers"));
  press(kEnter);
  for (int i = 0; i < 40 && !shown("layers/part/Trousers"); ++i) frame();
  EXPECT_TRUE(shown("layers/part/Trousers"));
  EXPECT_EQ(state.open.layers.chosen, part("Trousers"));
  EXPECT_EQ(steps(), 0u);
  run(action("help/palette"), state);
  settle();
  type("part rigid");
  ASSERT_TRUE(shown("palette/panel/layer-rigid"));
  click("palette/panel/layer-rigid");
  EXPECT_EQ(layer("Trousers"), SkinLayer::kRigid);
  EXPECT_EQ(steps(), 1u);
  run(action("help/palette"), state);
  settle();
  type("guess the part");
  click("palette/panel/layer-guess");
  EXPECT_EQ(layer("Trousers"), SkinLayer::kCloth);
}

TEST_F(LayersPanel, UndisplayableNamesAreShownByNumberAndKeptInTheRig) {
  auto renamed = std::make_shared<Character>(state.character());
  renamed->parts[1].name = "\xe3\x82\xb7\xe3\x83\xa3\xe3\x83\x84";  // "Shirt" in Japanese.
  const std::string name = renamed->parts[1].name;
  state.document.character = renamed;
  state.open.layers = {};
  setGlyphs([](char32_t c) { return c < 0x250; });
  settle();
  click("layers/set/" + name + "/rigid");
  setGlyphs({});
  ASSERT_EQ(state.document.rig().layers.size(), 1u);
  EXPECT_EQ(state.document.rig().layers[0].part, name);
  EXPECT_EQ(state.document.commands.label(1), "Layer of part 2: rigid");
}

}  // namespace
}  // namespace sinew::app
