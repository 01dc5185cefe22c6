// tests/command/render_movie_test.cpp: `sinew render`: views around a character, contact sheets and animated pictures.

#include <cstdint>

#include <stb_image.h>

#include "app/command/render_plan.h"
#include "app/ui/offscreen.h"
#include "tests/command/program.h"

namespace sinew::test {
namespace {

class RenderMovie : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    const auto context = app::OffscreenContext::create();
    if (!context) GTEST_SKIP() << "left out: " << context.error().text();
  }

  [[nodiscard]] Outcome render(std::vector<std::string> more, const std::string& before = "") const {
    std::vector<std::string> command{"render", demo("demo.rig.json"), "--size", "64x48", "--depth", "1"};
    command.insert(command.end(), more.begin(), more.end());
    return run(command, SINEW_PROGRAM, before);
  }
  [[nodiscard]] std::string bytes(const std::string& name) const {
    const auto read = readWholeFile(folder_ / name, 1 << 26);
    return read ? read.value() : "";
  }

  struct Pixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    [[nodiscard]] std::vector<std::uint8_t> part(int x, int y, int w, int h) const {
      std::vector<std::uint8_t> cut;
      for (int row = y; row < y + h; ++row) {
        const auto begin = rgba.begin() + 4 * (row * width + x);
        cut.insert(cut.end(), begin, begin + 4 * w);
      }
      return cut;
    }
  };
  [[nodiscard]] Pixels picture(const std::string& name) const {
    const std::string file = bytes(name);
    Pixels read;
    int channels = 0;
    stbi_uc* data = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()), static_cast<int>(file.size()),
                                          &read.width, &read.height, &channels, 4);
    if (data != nullptr) read.rgba.assign(data, data + 4 * read.width * read.height);
    stbi_image_free(data);
    return read;
  }
};

/// Header fields of an animated .webp, parsed without its library.
struct MovingWebp {
  int width = 0, height = 0;
  int loops = -1;
  std::vector<int> milliseconds;
};

MovingWebp readWebp(const std::string& file) {
  MovingWebp movie;
  const auto number = [&](std::size_t at, int count) {
    int value = 0;
    for (int i = count - 1; i >= 0; --i)
      value = value << 8 | static_cast<unsigned char>(file[at + static_cast<std::size_t>(i)]);
    return value;
  };
  EXPECT_EQ(file.substr(0, 4), "RIFF");
  EXPECT_EQ(file.substr(8, 4), "WEBP");
  EXPECT_EQ(static_cast<std::size_t>(number(4, 4)) + 8, file.size());
  for (std::size_t at = 12; at + 8 <= file.size();) {
    const std::string kind = file.substr(at, 4);
    const auto size = static_cast<std::size_t>(number(at + 4, 4));
    if (kind == "VP8X") movie.width = number(at + 12, 3) + 1, movie.height = number(at + 15, 3) + 1;
    if (kind == "ANIM") movie.loops = number(at + 12, 2);
    if (kind == "ANMF") movie.milliseconds.push_back(number(at + 20, 3));
    at += 8 + size + size % 2;
  }
  return movie;
}

TEST_F(RenderMovie, TurntableGoesOnceAround) {
  const Outcome done =
      render({"--turntable", "4", "--orthographic", "--no-ground", "--view", "front", "-o", "t_%d.png"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.out, "t_0.png\nt_1.png\nt_2.png\nt_3.png\n");
  EXPECT_NE(bytes("t_0.png"), bytes("t_1.png"));
  EXPECT_NE(bytes("t_0.png"), bytes("t_2.png"));
  // Nothing is cut off at any side: the picture's border shows only background.
  for (const char* name : {"t_0.png", "t_1.png", "t_2.png", "t_3.png"}) {
    const Pixels seen = picture(name);
    const auto corner = seen.part(0, 0, 1, 1);
    const auto top = seen.part(0, 0, seen.width, 1);
    for (int x = 0; x < seen.width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(top[4 * static_cast<std::size_t>(x) + c], corner[c], 24) << name << ' ' << x;
      }
    }
  }
}

TEST_F(RenderMovie, TurntableCanPlayTheClip) {
  const Outcome done = render({"--turntable", "2", "--frames", "0:3", "-o", "t_%d.png"});
  EXPECT_EQ(done.out, "t_0.png\nt_1.png\nt_2.png\nt_3.png\n") << done.error;
  ASSERT_EQ(render({"--turntable", "2", "--frames", "0:3", "-o", "again_%d.png"}).status, 0);
  EXPECT_NE(bytes("t_0.png"), bytes("t_2.png")) << "the same side, another frame";
  EXPECT_EQ(bytes("t_3.png"), bytes("again_3.png"));
}

TEST_F(RenderMovie, SheetHoldsThePicturesInRows) {
  ASSERT_EQ(render({"--frames", "0:3", "-o", "f_%d.png"}).status, 0);
  const Outcome done = render({"--frames", "0:3", "--sheet", "3x2", "-o", "sheet.png"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.out, "sheet.png\n");
  const Pixels sheet = picture("sheet.png");
  ASSERT_EQ(sheet.width, 3 * 64);
  ASSERT_EQ(sheet.height, 2 * 48);
  for (int i = 0; i < 4; ++i) {
    const Pixels alone = picture("f_" + std::to_string(i) + ".png");
    EXPECT_EQ(sheet.part(64 * (i % 3), 48 * (i / 3), 64, 48), alone.rgba) << i;
  }
  EXPECT_EQ(sheet.part(64, 48, 64, 48), std::vector<std::uint8_t>(4 * 64 * 48, 0)) << "no fifth frame";
}

TEST_F(RenderMovie, SheetWithoutFramesShowsAllSidesOrTheWholeClip) {
  ASSERT_EQ(render({"--sheet", "2x2", "-o", "sides.png"}).status, 0);
  const Pixels sides = picture("sides.png");
  EXPECT_NE(sides.part(0, 0, 64, 48), sides.part(64, 48, 64, 48));
  ASSERT_EQ(render({"--sheet", "2x2", "--clip", "Walk", "-o", "clip.png"}).status, 0);
  ASSERT_EQ(render({"--frames", "0:36:12", "--sheet", "2x2", "--clip", "Walk", "-o", "frames.png"}).status, 0);
  EXPECT_EQ(picture("clip.png").rgba, picture("frames.png").rgba) << "its beginning, two thirds, its end";
}

TEST_F(RenderMovie, FramesBecomeAnAnimatedWebp) {
  const Outcome done = render({"--frames", "0:8:2", "--fps", "20", "-o", "m.webp"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.out, "m.webp\n");
  const MovingWebp movie = readWebp(bytes("m.webp"));
  EXPECT_EQ(movie.width, 64);
  EXPECT_EQ(movie.height, 48);
  EXPECT_EQ(movie.loops, 0) << "for ever";
  EXPECT_EQ(movie.milliseconds, (std::vector<int>{100, 100, 100, 100, 100})) << "every second of twenty a second";
  ASSERT_EQ(render({"--frames", "0:8:2", "--fps", "20", "-o", "again.webp"}).status, 0);
  EXPECT_EQ(bytes("again.webp"), bytes("m.webp"));
  EXPECT_EQ(render({"--frames", "0:2", "-o", "gone/m.webp"}).status, 1);
}

TEST_F(RenderMovie, OtherMovieFormatsUseFfmpeg) {
  std::filesystem::create_directory(folder_ / "none");
  std::filesystem::create_symlink("/usr/bin/env", folder_ / "none" / "env");
  const Outcome absent = render({"--turntable", "3", "-o", "m.mp4"}, "PATH=none");
  EXPECT_EQ(absent.status, 1);
  EXPECT_TRUE(absent.oneErrorLine()) << absent.error;
  EXPECT_NE(absent.error.find(".mp4 needs the program ffmpeg"), std::string::npos) << absent.error;
  // A fake encoder that writes its arguments, then its input.
  ASSERT_TRUE(
      writeFileAtomically(folder_ / "ffmpeg", "#!/bin/sh\nfor last; do :; done\n{ echo \"$@\"; cat; } > \"$last\"\n")
          .ok());
  std::filesystem::permissions(folder_ / "ffmpeg", std::filesystem::perms::owner_all);
  const std::string path = "PATH=" + quoted(folder_.string()) + ":\"$PATH\"";
  for (const char* name : {"m.mp4", "it's.gif"}) {
    const Outcome done = render({"--turntable", "3", "--fps", "12", "-o", name}, path);
    EXPECT_EQ(done.status, 0) << done.error;
    EXPECT_EQ(done.out, std::string(name) + '\n');
    const std::string written = bytes(name);
    const std::size_t line = written.find('\n');
    EXPECT_EQ(written.size() - line - 1, std::size_t{3 * 4 * 64 * 48}) << "three pictures";
    EXPECT_NE(written.find("-s 64x48 -r 12.000000 "), std::string::npos) << written.substr(0, line);
  }
  ASSERT_TRUE(writeFileAtomically(folder_ / "ffmpeg", "#!/bin/sh\nexit 1\n").ok());
  std::filesystem::permissions(folder_ / "ffmpeg", std::filesystem::perms::owner_all);
  const Outcome failed = render({"--turntable", "3", "-o", "bad.mp4"}, path);
  EXPECT_EQ(failed.status, 1);
  EXPECT_NE(failed.error.find("bad.mp4: ffmpeg could not write it"), std::string::npos) << failed.error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "bad.mp4"));
}

TEST(Evenly, IncludesTheEndsAndSpreadsTheRest) {
  EXPECT_EQ(app::evenly(3, 5), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(app::evenly(9, 3), (std::vector<std::size_t>{0, 4, 8}));
  EXPECT_EQ(app::evenly(100, 1), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(app::evenly(0, 4).empty());
}

}  // namespace
}  // namespace sinew::test
