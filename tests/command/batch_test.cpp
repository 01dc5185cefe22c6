// tests/command/batch_test.cpp: splitting a job into items, and refused jobs.

#include "app/command/batch.h"

#include <set>

#include "tests/command/program.h"

namespace sinew::test {
namespace {

using app::Batch;
using app::BatchOptions;

class Jobs : public Program {
 protected:
  [[nodiscard]] std::filesystem::path listOf(const std::string& text) const {
    const std::filesystem::path file = folder_ / "list.txt";
    EXPECT_TRUE(writeFileAtomically(file, text).ok());
    return file;
  }
};

TEST_F(Jobs, FrameRangesHaveStepsAndIncludeBothEnds) {
  BatchOptions options;
  for (const auto& [text, frames] : {std::pair{"3:3", std::vector{3}}, std::pair{"0:4:2", std::vector{0, 2, 4}},
                                     std::pair{"1:9:5", std::vector{1, 6}}}) {
    options.frames = text;
    const auto batch = app::planBatch(options, "a.glb", "x%d.png");
    ASSERT_TRUE(batch.ok()) << text;
    EXPECT_EQ(batch->frames, frames);
    EXPECT_EQ(batch->inputs.at(0).outputs.size(), frames.size());
  }
  options.framesPerSecond = 20.0;
  options.frames = "5:10:5";
  EXPECT_DOUBLE_EQ(secondsAt(app::planBatch(options, "a.glb", "x%d.png").value(), options, 1), 0.5);
  for (const char* wrong : {"1", "1:", ":1", "2:1", "-1:2", "0:5:0", "0:5:-1", "0:5:1:1", "a:b", "0:100000", "0:1 "}) {
    options.frames = wrong;
    EXPECT_FALSE(app::planBatch(options, "a.glb", "x%d.png").ok()) << wrong;
  }
}

TEST_F(Jobs, ShardsDivideTheItemsOfAllInputs) {
  BatchOptions options;
  options.frames = "0:4";
  options.list = listOf(
      "\xef\xbb\xbf"
      "a/fox.rig.json\r\n  horse.glb \n\n# no\nb.x\n");
  for (const int count : {1, 2, 4, 15, 40}) {
    std::set<std::string> names;
    std::size_t items = 0;
    for (int index = 0; index < count; ++index) {
      options.shard = std::to_string(index) + '/' + std::to_string(count);
      const auto batch = app::planBatch(options, {}, "{name}/{name}_%02d.png");
      ASSERT_TRUE(batch.ok()) << batch.error().text();
      ASSERT_EQ(batch->inputs.size(), 3u);
      for (const app::BatchInput& input : batch->inputs) {
        EXPECT_EQ(input.outputs.size(), 5u) << "the whole job's, for what all of it decides";
        for (const std::size_t moment : input.wanted) names.insert(input.outputs[moment].string());
        items += input.wanted.size();
      }
    }
    EXPECT_EQ(items, 15u);
    EXPECT_EQ(names.size(), 15u);
    EXPECT_TRUE(names.contains("fox/fox_00.png") && names.contains("horse/horse_04.png") &&
                names.contains("b/b_02.png"));
  }
}

TEST_F(Jobs, ExistingOutputsAreSkippedOnlyWithResume) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "x1.png", "whole").ok());
  std::filesystem::create_directory(folder_ / "x2.png");
  BatchOptions options;
  options.frames = "0:3";
  const auto wanted = [&] { return app::planBatch(options, "a.glb", folder_ / "x%d.png")->inputs.at(0).wanted; };
  EXPECT_EQ(wanted(), (std::vector<std::size_t>{0, 1, 2, 3}));
  options.resume = true;
  EXPECT_EQ(wanted(), (std::vector<std::size_t>{0, 2, 3})) << "a folder is no picture";
}

TEST_F(Jobs, OutputsThatCollideAreRefused) {
  BatchOptions options;
  options.list = listOf("a/fox.glb\nb/fox.rig.json\n");
  const auto same = app::planBatch(options, {}, "{name}.png");
  ASSERT_FALSE(same.ok());
  EXPECT_NE(same.error().text().find("two items of the job write fox.png"), std::string::npos);
  EXPECT_FALSE(app::planBatch(options, {}, "x.png").ok()) << "no {name}";
  EXPECT_FALSE(app::planBatch(options, "a.glb", "{name}.png").ok()) << "a list and a file";
  options.list = listOf("# nothing\n");
  EXPECT_FALSE(app::planBatch(options, {}, "{name}.png").ok());
  EXPECT_FALSE(app::planBatch({}, {}, "x.png").ok()) << "neither";
}

TEST_F(Jobs, InputIsNeverTreatedAsFinishedOutput) {
  for (const char* name : {"demo.glb", "demo.rig.json"}) {
    std::filesystem::copy_file(demo(name), folder_ / name);
  }
  for (const char* input : {"demo.glb", "demo.rig.json"}) {
    const Outcome refused = run({"export", input, "--as", "skinned", "-o", "./demo.glb", "--resume"});
    EXPECT_EQ(refused.status, 2) << refused.error;
    EXPECT_TRUE(refused.oneErrorLine()) << refused.error;
  }
}

TEST(Shard, IsParsedStrictly) {
  EXPECT_EQ(app::shardOf("")->count, 1);
  EXPECT_EQ(app::shardOf("3/7")->index, 3);
  for (const char* wrong : {"7/7", "-1/7", "0/0", "1", "1/", "/2", "1/2/3", "a/2", "1/2 ", "0/99999999"}) {
    EXPECT_FALSE(app::shardOf(wrong).ok()) << wrong;
  }
}

TEST_F(Jobs, RefusalsAreOneLine) {
  const std::string rig = demo("demo.rig.json");
  const std::vector<std::vector<std::string>> wrong{
      {"smooth", rig, "--frames", "0:3", "-o", "a_%d.ply"},
      {"smooth", rig, "--clip", "Walk", "--frames", "0:3", "-o", "a.ply"},
      {"smooth", rig, "--clip", "Walk", "--frames", "0:3", "--time", "1", "-o", "a_%d.ply"},
      {"smooth", rig, "--clip", "Walk", "--frames", "0:3", "-o", "a_%d.ply", "--report", "r.json"},
      {"smooth", rig, "--list", "l.txt", "-o", "{name}.ply"},
      {"smooth", rig, "--shard", "2/2", "-o", "a.ply"},
      {"farm", "smooth", rig, "-o", "a.ply"},
      {"farm", "inspect", rig, "--to", "slurm"},
      {"farm", "smooth", rig, "-o", "a.ply", "--shard", "0/2", "--to", "slurm"},
      {"farm", "smooth", rig, "--to", "slurm"},
      {"farm", "smooth", rig, "-o", "a\nb.ply", "--to", "commands"},
      {"farm", "smooth", rig, "-o", "{{a}}.ply", "--to", "openjd"}};
  for (const std::vector<std::string>& arguments : wrong) {
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.status, 2) << arguments[0] << ": " << refused.error;
    EXPECT_TRUE(refused.oneErrorLine()) << refused.error;
    EXPECT_EQ(refused.out, "");
  }
  EXPECT_EQ(run({"smooth", "--list", "absent.txt", "-o", "{name}.ply"}).status, 1);
  EXPECT_EQ(run({"farm", "smooth", rig, "-o", "a.ply", "--to", "slurm", "--job", "no folder/job"}).status, 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Jobs, ListIsReadFromAPipe) {
  const std::vector<std::string> job{"smooth", "--list", "-", "--depth", "1", "-o", "{name}.ply"};
  const Outcome done =
      run(job, SINEW_PROGRAM, "printf '%s\\n' '" + demo("demo.glb") + "' '# no' '" + demo("tangle.glb") + "' |");
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.out, "demo.ply\ntangle.ply\n");
  const Outcome nothing = run(job);
  EXPECT_EQ(nothing.status, 1);
  EXPECT_EQ(nothing.error, "sinew: standard input: names no input: expected a file name a line\n");
}

TEST_F(Jobs, FramesPastTheEndAreSkippedWithANote) {
  std::vector<std::string> job{
      "smooth", demo("demo.rig.json"), "--clip", "Walk", "--frames", "34:9999", "--depth", "1", "-o", "f_%d.ply"};
  for (const bool dry : {true, false}) {
    if (dry) job.emplace_back("--dry-run");
    const Outcome done = run(job);
    if (dry) job.pop_back();
    EXPECT_EQ(done.status, 0) << done.error;
    EXPECT_EQ(done.out, "f_34.ply\nf_35.ply\nf_36.ply\n");
    EXPECT_TRUE(done.oneErrorLine()) << done.error;
    EXPECT_NE(
        done.error.find("clip \"Walk\": ends at frame 36 (1.2 s at 30 a second); 9963 frames past it are left out"),
        std::string::npos)
        << done.error;
    EXPECT_EQ(std::filesystem::exists(folder_ / "f_34.ply"), !dry);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "f_37.ply"));
  job[5] = "37:40";
  const Outcome none = run(job);
  EXPECT_EQ(none.status, 1);
  EXPECT_TRUE(none.oneErrorLine()) << none.error;
  EXPECT_NE(none.error.find("before the first of --frames 37:40"), std::string::npos) << none.error;
  job[5] = "36:36";
  EXPECT_EQ(run(job).error, "") << "the end itself is a frame";
}

class FarmChecks : public Jobs {
 protected:
  void expectRefused(std::vector<std::string> arguments, int status, const std::string& words) const {
    arguments.insert(arguments.begin(), "farm");
    arguments.insert(arguments.end(), {"--to", "slurm"});
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.status, status) << refused.error;
    EXPECT_TRUE(refused.oneErrorLine()) << refused.error;
    EXPECT_NE(refused.error.find(words), std::string::npos) << refused.error;
    EXPECT_EQ(refused.out, "");
  }
};

TEST_F(FarmChecks, JobsThatCannotRunAreRefused) {
  const std::string rig = demo("demo.rig.json");
  const std::vector<std::string> frames{"--clip", "Walk", "--frames", "0:9", "-o", "f_%d.ply"};
  const auto with = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expectRefused(with({"smooth"}, frames), 2, "expected a file, or --list");
  expectRefused(with({"smooth", "absent.rig.json"}, frames), 1, "absent.rig.json");
  expectRefused({"smooth", rig, "--clip", "Walk", "-o", "f_%04d.ply"}, 2, "--frames: expected");
  expectRefused({"smooth", rig, "--clip", "Walk", "--frames", "90:99", "-o", "f_%d.ply"}, 1, "ends at frame 36");
  expectRefused({"smooth", rig, "--clip", "Wlk", "--frames", "0:9", "-o", "f_%d.ply"}, 1, "did you mean \"Walk\"?");
  expectRefused({"smooth", rig, "--clip", "Walk", "--frames", "0:9", "-o", "gone/f_%d.ply"}, 1, "no such folder");
  expectRefused({"render", "--list", "absent.txt", "-o", "{name}.png"}, 1, "absent.txt");
  expectRefused({"render", "--list", listOf(rig + "\nabsent.glb\n").string(), "-o", "{name}.png"}, 1, "absent.glb");
  expectRefused({"export", "--list", "-", "-o", "{name}.glb"}, 2, "standard input");
  expectRefused({"export", rig, "--clip", "Wlk", "-o", "x.glb"}, 1, "did you mean \"Walk\"?");
  expectRefused({"export", rig, "--as", "baked", "-o", "x.glb"}, 2, "one clip to bake");
}

TEST_F(FarmChecks, SlurmRequestsTheResourcesOfOneTask) {
  const auto job = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"farm",   "smooth", demo("demo.rig.json"),
                                   "--clip", "Walk",   "--frames",
                                   "0:9",    "-o",     "f_%d.ply",
                                   "--to",   "slurm",  "--tasks",
                                   "4"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome done = run(words);
    EXPECT_EQ(done.status, 0) << done.error;
    return done.out;
  };
  const auto megabytes = [](const std::string& text) {
    const std::size_t at = text.find("\n#SBATCH --mem=");
    return at == std::string::npos ? 0 : std::atoi(text.c_str() + at + 15);
  };
  const std::string plain = job({});
  EXPECT_NE(plain.find("\n#SBATCH --cpus-per-task=1\n"), std::string::npos) << plain;
  EXPECT_NE(plain.find("\n#SBATCH --array=0-3\n"), std::string::npos) << plain;
  EXPECT_GE(megabytes(plain), 100);
  EXPECT_GT(megabytes(job({"--depth", "16"})), megabytes(plain)) << "more vertices, more memory";
  EXPECT_NE(job({"--threads", "3"}).find("\n#SBATCH --cpus-per-task=3\n"), std::string::npos);
}

TEST_F(FarmChecks, TasksDoNotExceedFiles) {
  const Outcome done = run({"farm", "smooth", demo("demo.rig.json"), "--clip", "Walk", "--frames", "34:99", "-o",
                            "f_%d.ply", "--to", "slurm", "--tasks", "9"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_NE(done.out.find("\n#SBATCH --array=0-2\n"), std::string::npos) << done.out;
  EXPECT_NE(done.error.find("farm: 3 files: 3 tasks\n"), std::string::npos) << done.error;
}

TEST_F(Jobs, FrameSequenceHasOneReportPerFrame) {
  const Outcome done = run({"smooth", demo("demo.rig.json"), "--clip", "Walk", "--frames", "0:1", "--depth", "1", "-o",
                            "a_%d.ply", "--report", "r_%02d.json"});
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.out, "a_0.ply\na_1.ply\n");
  for (const char* name : {"a_0.ply", "a_1.ply", "r_00.json", "r_01.json"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
  }
  ASSERT_EQ(run({"smooth", demo("demo.rig.json"), "--clip", "Walk", "--time", "0.0333333333333333", "--depth", "1",
                 "-o", "alone.ply"})
                .status,
            0);
  EXPECT_EQ(readWholeFile(folder_ / "alone.ply", 1 << 26).value(), readWholeFile(folder_ / "a_1.ply", 1 << 26).value());
}

}  // namespace
}  // namespace sinew::test
