// tests/command/render_test.cpp: `sinew render` as people and scripts run it.
#include <stb_image.h>

#include "app/command/render_plan.h"
#include "app/ui/offscreen.h"
#include "sinew/files/rig_json.h"
#include "tests/command/program.h"

namespace sinew::test {
namespace {

class RenderVerb : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    const auto context = app::OffscreenContext::create();
    if (!context) GTEST_SKIP() << "left out: " << context.error().text();
  }

  struct Picture {
    int width = 0, height = 0, channels = 0;
    std::string bytes;
  };
  [[nodiscard]] Picture picture(const std::string& name) const {
    Picture read;
    const auto bytes = readWholeFile(folder_ / name, 1 << 26);
    if (!bytes) return read;
    read.bytes = bytes.value();
    stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(read.bytes.data()), static_cast<int>(read.bytes.size()),
                          &read.width, &read.height, &read.channels);
    return read;
  }
};

TEST_F(RenderVerb, WritesOnePictureAndPrintsItsPath) {
  const Outcome done = run({"render", demo("demo.rig.json"), "--size", "96x64", "--depth", "2", "-o", "one.png"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.out, "one.png\n");
  EXPECT_NE(done.error.find("1 picture, each: smooth"), std::string::npos);
  EXPECT_EQ(picture("one.png").width, 96);
  EXPECT_EQ(picture("one.png").height, 64);
  EXPECT_EQ(picture("one.png").channels, 3);
}

TEST_F(RenderVerb, NumbersTheFramesOfAClip) {
  const Outcome done =
      run({"render", demo("demo.rig.json"), "--frames", "9:11", "--size", "48x48", "--depth", "1", "-o", "f_%03d.png"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.out, "f_009.png\nf_010.png\nf_011.png\n");
  EXPECT_NE(picture("f_009.png").bytes, picture("f_011.png").bytes);
}

TEST_F(RenderVerb, SameCommandWritesTheSameBytes) {
  const std::vector<std::string> command{"render",
                                         demo("demo.rig.json"),
                                         "--view",
                                         "-30,12",
                                         "--show",
                                         "skeleton,primitives,wire",
                                         "--shading",
                                         "clay",
                                         "--transparent",
                                         "--size",
                                         "64x64",
                                         "--depth",
                                         "2",
                                         "-o",
                                         "a.png"};
  ASSERT_EQ(run(command).status, 0);
  const Picture first = picture("a.png");
  EXPECT_EQ(first.channels, 4);
  ASSERT_EQ(run(command).status, 0);
  EXPECT_EQ(picture("a.png").bytes, first.bytes);
}

TEST_F(RenderVerb, LightBackgroundAndOcclusionChangeThePicture) {
  const auto bytes = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command{"render", demo("demo.rig.json"), "--size", "96x96", "--depth", "2", "-o", "a.png"};
    command.insert(command.end(), more.begin(), more.end());
    EXPECT_EQ(run(command).status, 0) << more.front();
    return picture("a.png").bytes;
  };
  const std::string plain = bytes({"--samples", "4"});
  EXPECT_EQ(bytes({"--light", "studio", "--background", "studio"}), plain) << "which is what is drawn without a choice";
  EXPECT_EQ(bytes({"--show", "relief"}), plain) << "which is for clay";
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--light", "outdoor"},
                                               {"--light", "rim"},
                                               {"--light", "white"},
                                               {"--background", "dark"},
                                               {"--background", "checker"},
                                               {"--ao"}}) {
    EXPECT_NE(bytes(more), plain) << more.back();
  }
}

TEST_F(RenderVerb, MusclesAreShownUnderGlass) {
  const auto bytes = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command{"render", demo("demo.rig.json"), "--size", "96x96", "--depth", "2", "-o", "a.png"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome done = run(command);
    EXPECT_EQ(done.status, 0) << done.error;
    return picture("a.png").bytes;
  };
  const std::string muscles = bytes({"--show", "muscles"});
  EXPECT_NE(muscles, bytes({"--samples", "4"}));
  EXPECT_EQ(muscles, bytes({"--show", "muscles", "--glass", "0.8"}));
  EXPECT_NE(muscles, bytes({"--show", "muscles", "--glass", "0.3"}));
  EXPECT_NE(muscles, bytes({"--show", "muscles,skeleton"}));
}

TEST_F(RenderVerb, AutoDepthFollowsThePictureSize) {
  const auto bundled = loadRig(demo("demo.rig.json"));
  ASSERT_TRUE(bundled.ok());
  Rig rig = bundled.value();
  rig.character = demo("demo.glb");
  rig.smoothing.autoDepth = true;
  ASSERT_TRUE(saveRig(rig, folder_ / "auto.rig.json").ok());
  const Outcome small = run({"render", "auto.rig.json", "--size", "32x32", "-o", "a.png"});
  ASSERT_EQ(small.status, 0) << small.error;
  EXPECT_NE(small.error.find("depth 1 for"), std::string::npos) << small.error;
  const Outcome large = run({"render", "auto.rig.json", "--size", "1600x1200", "-o", "a.png"});
  EXPECT_EQ(large.error.find("depth 1 for"), std::string::npos) << large.error;
  const Outcome told = run({"render", "auto.rig.json", "--size", "32x32", "--depth", "2", "-o", "a.png"});
  EXPECT_EQ(told.error.find(" for the character"), std::string::npos) << told.error;
}

TEST_F(RenderVerb, BadInputIsOneLineAndNoPicture) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"render", "absent.glb"}, {"render", demo("demo.glb"), "--clip", "no such clip"}}) {
    std::vector<std::string> command = more;
    command.insert(command.end(), {"-o", "bad.png"});
    const Outcome refused = run(command);
    EXPECT_EQ(refused.status, 1);
    EXPECT_TRUE(refused.oneErrorLine()) << refused.error;
    EXPECT_EQ(refused.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "bad.png"));
  }
  EXPECT_EQ(run({"render", demo("demo.glb"), "--size", "32x32", "-o", "no/such/folder/a.png"}).status, 1);
}

TEST_F(RenderVerb, BadCommandLineIsStatus2) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--size", "5x5"},
                                                {"--size", "9000x100"},
                                                {"--size", "big"},
                                                {"--view", "behind"},
                                                {"--view", "10,95"},
                                                {"--shading", "shiny"},
                                                {"--light", "moon"},
                                                {"--glass", "1.5"},
                                                {"--background", "pink"},
                                                {"--show", "skeleton,nothing"},
                                                {"--frames", "3:1"},
                                                {"--frames", "0:3"},
                                                {"--depth", "17"},
                                                {"--samples", "0"},
                                                {"--time", "-1"},
                                                {"--patch", "round"}}) {
    std::vector<std::string> command{"render", demo("demo.glb"), "-o", "a.png"};
    command.insert(command.end(), wrong.begin(), wrong.end());
    const Outcome refused = run(command);
    EXPECT_EQ(refused.status, 2) << wrong[0] << ' ' << wrong[1] << ": " << refused.error;
    EXPECT_TRUE(refused.oneErrorLine()) << refused.error;
  }
  EXPECT_EQ(run({"render", demo("demo.glb"), "-o", "a.jpg"}).status, 2);
  EXPECT_EQ(run({"render", demo("demo.glb"), "-o", "a.webp"}).status, 2) << "nothing moves";
  for (const char* wrong : {"0x2", "3", "3x", "-1x2", "200x200"}) {
    EXPECT_EQ(run({"render", demo("demo.glb"), "-o", "a.png", "--sheet", wrong}).status, 2) << wrong;
  }
  EXPECT_EQ(run({"render", demo("demo.glb"), "-o", "a.webp", "--turntable", "8", "--sheet", "2x2"}).status, 2);
  EXPECT_EQ(run({"render", demo("demo.glb"), "-o", "a_%d.png", "--turntable", "1"}).status, 2);
  EXPECT_EQ(run({"render", demo("demo.glb")}).status, 2);
}

app::RenderOptions plannedAs(const std::string& frames, const std::string& output) {
  app::RenderOptions options;
  options.input = "a.glb";
  options.batch.frames = frames;
  options.output = output;
  return options;
}

TEST(RenderPlan, FrameNumbersFollowTheFormatInTheName) {
  const auto plain = app::planRender(plannedAs("8:10", "x%d.png"));
  ASSERT_TRUE(plain.ok());
  EXPECT_EQ(plain->batch.inputs[0].outputs[0], "x8.png");
  EXPECT_EQ(plain->batch.inputs[0].outputs[2], "x10.png");
  EXPECT_DOUBLE_EQ(plain->times[2], 10.0 / 30.0);
  const auto wide = app::planRender(plannedAs("8:8", "a/x%05d_y.png"));
  ASSERT_TRUE(wide.ok());
  EXPECT_EQ(wide->batch.inputs[0].outputs[0], "a/x00008_y.png");
}

TEST(RenderPlan, RefusesAmbiguousFrameNames) {
  for (const char* name : {"x.png", "x%s.png", "x%04d_%d.png", "x%.png", "x%n.png", "x%1000000d.png"}) {
    EXPECT_FALSE(app::planRender(plannedAs("0:3", name)).ok()) << name;
  }
}

TEST(RenderPlan, ViewsAreNamedOrGivenInDegrees) {
  app::RenderOptions options;
  options.input = "a.glb";
  options.output = "x.png";
  options.view = "left";
  EXPECT_NEAR(app::planRender(options)->yaw, 1.5707963f, 1e-5f);
  options.view = "-45,30";
  EXPECT_NEAR(app::planRender(options)->yaw, -0.7853982f, 1e-5f);
  EXPECT_NEAR(app::planRender(options)->pitch, 0.5235988f, 1e-5f);
  for (const char* wrong : {"nan,0", "0,nan", "inf,0", "1", "1,2,3", "1,", ""}) {
    options.view = wrong;
    EXPECT_FALSE(app::planRender(options).ok()) << wrong;
  }
}

}  // namespace
}  // namespace sinew::test
