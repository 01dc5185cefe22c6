// tests/ui/changed_tiles_test.cpp: every changed pixel lies in a reported rectangle, and few other pixels do.
#include "app/ui/changed_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include <imgui.h>

namespace sinew::test {
namespace {

using app::ChangedTiles;
using app::TextureRevision;

constexpr glm::ivec2 kSize{330, 200};  // Not a multiple of the tile size.
constexpr std::uintptr_t kKnown = 7, kUnknown = 8;

/// A filled box, as the interface draws it.
struct Box {
  glm::ivec4 at{0};
  ImU32 color = 0;
  std::uintptr_t texture = kKnown;
};

class TileChanges : public testing::Test {
 protected:
  TileChanges() { ImGui::CreateContext(); }
  ~TileChanges() override {
    for (ImDrawList* list : lists_) IM_DELETE(list);
    ImGui::DestroyContext();
  }

  /// Draw data of these boxes; valid until the test ends.
  ImDrawData dataOf(const std::vector<Box>& boxes) {
    auto* list = IM_NEW(ImDrawList)(ImGui::GetDrawListSharedData());
    lists_.push_back(list);
    list->_ResetForNewFrame();
    list->PushClipRect({0, 0}, {static_cast<float>(kSize.x), static_cast<float>(kSize.y)});
    for (const Box& box : boxes) {
      list->PushTextureID(reinterpret_cast<ImTextureID>(box.texture));
      list->PrimReserve(6, 4);
      list->PrimRect({static_cast<float>(box.at.x), static_cast<float>(box.at.y)},
                     {static_cast<float>(box.at.z), static_cast<float>(box.at.w)}, box.color);
      list->PopTextureID();
    }
    list->_PopUnusedDrawCmd();
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = &lists_.back();
    data.CmdListsCount = 1;
    data.DisplaySize = {static_cast<float>(kSize.x), static_cast<float>(kSize.y)};
    data.FramebufferScale = {1, 1};
    return data;
  }

  std::vector<glm::ivec4> update(ChangedTiles& tiles, const std::vector<Box>& boxes, std::uint64_t revision = 0) {
    lists_.reserve(1000);  // ImDrawData points into it.
    const std::array known{TextureRevision{kKnown, revision}};
    return tiles.update(dataOf(boxes), kSize, known);
  }

  std::vector<ImDrawList*> lists_;
};

/// Oracle: topmost color of each pixel by painter's algorithm.
std::vector<ImU32> painted(const std::vector<Box>& boxes) {
  std::vector<ImU32> pixels(static_cast<std::size_t>(kSize.x * kSize.y), 0);
  for (const Box& box : boxes) {
    for (int y = box.at.y; y < box.at.w; ++y) {
      for (int x = box.at.x; x < box.at.z; ++x) pixels[static_cast<std::size_t>(y * kSize.x + x)] = box.color;
    }
  }
  return pixels;
}

int holders(const std::vector<glm::ivec4>& rects, int x, int y) {
  return static_cast<int>(
      std::ranges::count_if(rects, [&](const glm::ivec4& r) { return x >= r.x && x < r.z && y >= r.y && y < r.w; }));
}

TEST_F(TileChanges, FirstFrameIsFullyChangedAndEqualFramesAreNot) {
  ChangedTiles tiles;
  const std::vector<Box> boxes{{{10, 10, 90, 50}, 5}, {{60, 30, 300, 190}, 6}};
  const std::vector<glm::ivec4> first = update(tiles, boxes);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0], glm::ivec4(0, 0, kSize.x, kSize.y));
  EXPECT_TRUE(update(tiles, boxes).empty());
}

TEST_F(TileChanges, EveryChangedPixelIsInOneRectangle) {
  std::mt19937 random(3);
  const auto below = [&](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
  const auto anyBox = [&] {
    const int x = below(kSize.x - 1), y = below(kSize.y - 1);
    return Box{{x, y, x + 1 + below(kSize.x - x - 1), y + 1 + below(kSize.y - y - 1)},
               1u + static_cast<ImU32>(below(3))};
  };
  ChangedTiles tiles;
  std::vector<Box> boxes;
  for (int i = 0; i < 6; ++i) boxes.push_back(anyBox());
  update(tiles, boxes);
  long long marked = 0;
  for (int round = 0; round < 300; ++round) {
    const std::vector<ImU32> before = painted(boxes);
    Box& changed = boxes[static_cast<std::size_t>(below(6))];
    if (round % 2 == 0) changed = anyBox();
    else std::swap(changed, boxes[static_cast<std::size_t>(below(6))]);
    const std::vector<ImU32> after = painted(boxes);
    const std::vector<glm::ivec4> rects = update(tiles, boxes);
    ASSERT_LE(rects.size(), ChangedTiles::kMostRects);
    for (int y = 0; y < kSize.y; ++y) {
      for (int x = 0; x < kSize.x; ++x) {
        const auto at = static_cast<std::size_t>(y * kSize.x + x);
        const int in = holders(rects, x, y);
        ASSERT_LE(in, 1) << "drawn twice where it is blended";
        if (before[at] != after[at]) {
          ASSERT_EQ(in, 1) << x << " " << y;
        }
        marked += in;
      }
    }
  }
  EXPECT_LT(marked, 300LL * kSize.x * kSize.y * 9 / 10);
}

TEST_F(TileChanges, SmallChangeGivesASmallRectangle) {
  ChangedTiles tiles;
  std::vector<Box> boxes{{{0, 0, 330, 200}, 5}, {{100, 100, 104, 104}, 6}};
  update(tiles, boxes);
  boxes[1].color = 9;
  const std::vector<glm::ivec4> rects = update(tiles, boxes);
  ASSERT_EQ(rects.size(), 1u);
  EXPECT_EQ(rects[0], glm::ivec4(96, 96, 128, 128));
}

TEST_F(TileChanges, TextureChangesWithItsRevisionAndUnknownTexturesAlways) {
  ChangedTiles tiles;
  const std::vector<Box> boxes{{{0, 0, 64, 64}, 5, kKnown}};
  update(tiles, boxes, 1);
  EXPECT_TRUE(update(tiles, boxes, 1).empty());
  EXPECT_EQ(update(tiles, boxes, 2).size(), 1u);
  const std::vector<Box> other{{{0, 0, 64, 64}, 5, kUnknown}};
  update(tiles, other, 2);
  EXPECT_EQ(update(tiles, other, 2).size(), 1u);
}

TEST_F(TileChanges, DrawingIsClippedToTheRectangles) {
  lists_.reserve(10);
  ImDrawData data = dataOf({{{0, 0, 330, 200}, 5}});
  const std::vector<glm::ivec4> rects{{32, 32, 64, 96}, {128, 0, 160, 32}};
  app::clipDrawing(data, rects);
  const ImVector<ImDrawCmd>& commands = data.CmdLists[0]->CmdBuffer;
  ASSERT_EQ(commands.Size, 2);
  for (int i = 0; i < 2; ++i) {
    const ImVec4& clip = commands[i].ClipRect;
    EXPECT_EQ(glm::ivec4(glm::vec4(clip.x, clip.y, clip.z, clip.w)), rects[static_cast<std::size_t>(i)]);
    EXPECT_EQ(commands[i].ElemCount, 6u);
  }
}

}  // namespace
}  // namespace sinew::test
