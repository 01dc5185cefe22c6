// tests/character/planted_feet_test.cpp: planted feet of the bundled characters do not slide or sink.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <ranges>

#include <gtest/gtest.h>

#include "core/character/bindings.h"
#include "core/character/skinning.h"
#include "core/geometry/nearest_name.h"
#include "sinew/files/gltf_import.h"

namespace sinew {
namespace {

constexpr double kSamplesPerSecond = 240.0;  // Most fall between two keys.
constexpr float kBand = 0.002f;              // H; a foot no higher than this is planted: the gap is invisible.
constexpr float kMaxSlide = 0.010f;          // H
constexpr float kMaxSink = 0.005f;           // H
constexpr float kSole = 0.012f;              // H; bind pose, part of the foot that may touch the ground.

/// The lowest vertices in the bind pose whose main influence is the foot or its toes.
struct Foot {
  std::string name;
  std::vector<std::size_t> sole;
};

struct Walked {
  std::string file;
  std::string clip;
  double minPlanted;  ///< Least fraction of the clip during which every foot is planted.
  double maxPlanted;
  double minSpeed;  ///< H per second.
  double maxSpeed;
};

/// Motion of one foot in one clip, sampled evenly around the loop: the first sample follows the last. Lengths in H.
struct Track {
  std::vector<std::vector<glm::vec3>> soles;  ///< [samples][sole]
  std::vector<std::size_t> lowest;            ///< [samples] index into the sole.
  std::vector<bool> planted;                  ///< [samples]

  [[nodiscard]] std::size_t next(std::size_t sample) const { return sample + 1 < planted.size() ? sample + 1 : 0; }
};

/// The nearest bone at or above whose name denotes a foot's or hoof's root; -1 if there is none.
int footOf(const Skeleton& skeleton, int bone) {
  for (int b = bone; b >= 0; b = skeleton.bones[static_cast<std::size_t>(b)].parent) {
    const std::string name = lowerCase(skeleton.bones[static_cast<std::size_t>(b)].name);
    if (name.starts_with("foot") || name.starts_with("hoof")) return b;
  }
  return -1;
}

std::vector<Foot> feetOf(const Character& character) {
  std::vector<Foot> byBone(character.skeleton.bones.size());
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    if (character.mesh.positions[v].y > kSole * character.height) continue;
    std::vector<float> shares(byBone.size(), 0.0f);
    for (const WeightedBinding& follows : bindingsOf(character, static_cast<int>(v))) {
      const int foot = footOf(character.skeleton, follows.bone());
      if (foot >= 0) shares[static_cast<std::size_t>(foot)] += follows.weight;
    }
    const auto most = std::ranges::max_element(shares);
    if (*most > 0.5f) byBone[static_cast<std::size_t>(most - shares.begin())].sole.push_back(v);
  }
  for (std::size_t b = 0; b < byBone.size(); ++b) byBone[b].name = character.skeleton.bones[b].name;
  std::erase_if(byBone, [](const Foot& foot) { return foot.sole.empty(); });
  return byBone;
}

std::vector<Track> play(const Character& character, const AnimationClip& clip, const std::vector<Foot>& feet) {
  const int samples = static_cast<int>(std::lround(clip.duration * kSamplesPerSecond));
  std::vector<Track> tracks(feet.size());
  SkinnedMesh skinned;
  for (int s = 0; s < samples; ++s) {
    const float time = clip.duration * static_cast<float>(s) / static_cast<float>(samples);
    skin(character, samplePose(character.skeleton, clip, time), skinned);
    for (std::size_t f = 0; f < feet.size(); ++f) {
      std::vector<glm::vec3> sole;
      for (const std::size_t v : feet[f].sole) sole.push_back(skinned.positions[v] / character.height);
      const auto lowest = std::ranges::min_element(sole, {}, &glm::vec3::y);
      tracks[f].lowest.push_back(static_cast<std::size_t>(lowest - sole.begin()));
      tracks[f].planted.push_back(lowest->y < kBand);
      tracks[f].soles.push_back(std::move(sole));
    }
  }
  return tracks;
}

/// Motion of the sole's lowest point over the ground between consecutive samples.
glm::vec2 contactStep(const Track& track, std::size_t sample) {
  const std::size_t point = track.lowest[sample];
  const glm::vec3 step = track.soles[track.next(sample)][point] - track.soles[sample][point];
  return {step.x, step.z};
}

bool stands(const Track& track, std::size_t sample) {
  return track.planted[sample] && track.planted[track.next(sample)];
}

/// The ground's step between samples, for all feet of a clip: median step of planted points, by axis.
glm::vec2 groundStep(const std::vector<Track>& tracks) {
  std::vector<float> x, z;
  for (const Track& track : tracks) {
    for (std::size_t s = 0; s < track.planted.size(); ++s) {
      if (!stands(track, s)) continue;
      x.push_back(contactStep(track, s).x);
      z.push_back(contactStep(track, s).y);
    }
  }
  const auto median = [](std::vector<float>& values) {
    if (values.empty()) return 0.0f;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
  };
  return {median(x), median(z)};
}

struct Worst {
  float slide = 0.0f;    ///< Largest distance on the ground between two places of one planted phase.
  float sink = 0.0f;     ///< Deepest below the ground.
  double planted = 0.0;  ///< Fraction of the samples.
  int standings = 0;
  float highest = 0.0f;  ///< Height of the lowest point: how clearly the foot lifts off.
};

/// Accumulates the motion of the contact point over the ground while the foot is planted, also when contact moves from
/// heel to toe. A phase that spans the clip's end continues at its start.
Worst follow(const Track& track, const glm::vec2& ground) {
  Worst worst;
  const std::size_t samples = track.planted.size();
  for (std::size_t s = 0; s < samples; ++s) {
    const float y = track.soles[s][track.lowest[s]].y;
    worst.sink = std::max(worst.sink, -y);
    worst.highest = std::max(worst.highest, y);
    worst.planted += track.planted[s] ? 1.0 / static_cast<double>(samples) : 0.0;
  }
  std::vector<glm::vec2> places;
  for (std::size_t round = 0; round < 2 * samples; ++round) {
    const std::size_t s = round % samples;
    if (!stands(track, s)) {
      places.clear();
      continue;
    }
    if (places.empty()) {
      places.assign(1, glm::vec2{0.0f});
      worst.standings += round < samples ? 1 : 0;
    }
    places.push_back(places.back() + contactStep(track, s) - ground);
    for (const glm::vec2& place : places) worst.slide = std::max(worst.slide, glm::distance(place, places.back()));
    if (places.size() > samples) break;  // Always planted.
  }
  return worst;
}

std::filesystem::path asset(const std::string& file) {
  return std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / file;
}

class PlantedFeet : public testing::TestWithParam<Walked> {};

TEST_P(PlantedFeet, NeitherSlideNorSink) {
  const Walked& walked = GetParam();
  const auto imported = importGltf(asset(walked.file));
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& character = *imported.value();
  const auto clip = std::ranges::find(character.clips, walked.clip, &AnimationClip::name);
  ASSERT_NE(clip, character.clips.end()) << "no such clip";
  const std::vector<Foot> feet = feetOf(character);
  ASSERT_EQ(feet.size(), walked.file == "horse.glb" ? 4u : 2u);

  const std::vector<Track> tracks = play(character, *clip, feet);
  const glm::vec2 ground = groundStep(tracks);
  const double speed = glm::length(ground) * static_cast<double>(tracks[0].planted.size()) / clip->duration;
  EXPECT_GE(speed, walked.minSpeed);
  EXPECT_LE(speed, walked.maxSpeed);
  EXPECT_LE(ground.y, 1e-5f) << "the ground goes backwards, so that the character goes ahead";
  for (std::size_t f = 0; f < feet.size(); ++f) {
    const Worst worst = follow(tracks[f], ground);
    std::printf(
        "%s %-6s %-14s ground %.2f H/s  stands %2.0f %% in %d  slides %.2f %% H  "
        "sinks %.2f %% H  lifts %.1f %% H\n",
        walked.file.c_str(), walked.clip.c_str(), feet[f].name.c_str(), speed, 100.0 * worst.planted, worst.standings,
        100.0f * worst.slide, 100.0f * worst.sink, 100.0f * worst.highest);
    EXPECT_GE(feet[f].sole.size(), 3u) << feet[f].name;
    EXPECT_LT(worst.slide, kMaxSlide) << feet[f].name;
    EXPECT_LT(worst.sink, kMaxSink) << feet[f].name;
    EXPECT_GE(worst.planted, walked.minPlanted) << feet[f].name;
    EXPECT_LE(worst.planted, walked.maxPlanted) << feet[f].name;
    EXPECT_GE(worst.standings, 1) << feet[f].name;
    EXPECT_GT(worst.highest, 0.01f) << feet[f].name << " never leaves the ground";
  }
}

INSTANTIATE_TEST_SUITE_P(Clips, PlantedFeet,
                         testing::Values(Walked{"humanoid.glb", "Walk", 0.50, 0.75, 0.4, 1.2},
                                         Walked{"humanoid.glb", "Dance", 0.50, 0.97, 0.0, 1e-3},
                                         Walked{"horse.glb", "Walk", 0.45, 0.80, 0.3, 1.5},
                                         Walked{"horse.glb", "Gallop", 0.12, 0.50, 1.0, 8.0}),
                         [](const auto& instance) {
                           return instance.param.file.substr(0, instance.param.file.find('.')) + instance.param.clip;
                         });

/// The same measure on broken clips: the hips drift, or are too low.
TEST(PlantedFeetMeasure, DetectsSlidingAndSinking) {
  const auto imported = importGltf(asset("humanoid.glb"));
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& character = *imported.value();
  const std::vector<Foot> feet = feetOf(character);
  for (const char* name : {"Walk", "Dance"}) {
    const auto clip = std::ranges::find(character.clips, name, &AnimationClip::name);
    ASSERT_NE(clip, character.clips.end());
    AnimationClip drifting = *clip, deep = *clip;
    for (std::size_t c = 0; c < clip->channels.size(); ++c) {
      if (clip->channels[c].path != ChannelPath::kTranslation) continue;
      for (std::size_t k = 0; k < clip->channels[c].times.size(); ++k) {
        const float wave = std::sin(6.2831853f * clip->channels[c].times[k] / clip->duration);
        drifting.channels[c].values[k].x += 0.012f * character.height * wave;
        deep.channels[c].values[k].y -= 0.006f * character.height;
      }
    }
    const std::vector<Track> slid = play(character, drifting, feet);
    const std::vector<Track> sunk = play(character, deep, feet);
    for (std::size_t f = 0; f < feet.size(); ++f) {
      EXPECT_GT(follow(slid[f], groundStep(slid)).slide, kMaxSlide) << name << ' ' << feet[f].name;
      EXPECT_GT(follow(sunk[f], groundStep(sunk)).sink, kMaxSink) << name << ' ' << feet[f].name;
    }
  }
}

}  // namespace
}  // namespace sinew
