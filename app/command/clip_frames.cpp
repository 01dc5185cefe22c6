// app/command/clip_frames.cpp: frames against the length of a clip.
#include "app/command/clip_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace sinew::app {
namespace {

constexpr double kSameFrame = 1e-3;  ///< Share of a frame: less is rounding.

std::string numberText(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

std::string endText(const AnimationClip& clip, double framesPerSecond, int last) {
  return "ends at frame " + std::to_string(last) + " (" + numberText(static_cast<double>(clip.duration)) + " s at " +
         numberText(framesPerSecond) + " a second)";
}

}  // namespace

Result<ClipFrames> framesInClip(const std::vector<int>& frames, const BatchOptions& options,
                                const std::vector<std::size_t>& wanted, const AnimationClip* clip,
                                const std::filesystem::path& file) {
  ClipFrames inside{std::max<std::size_t>(frames.size(), 1), wanted, {}};
  if (clip == nullptr || frames.empty()) return inside;
  const double end = static_cast<double>(clip->duration) * options.framesPerSecond + kSameFrame;
  const auto past = std::ranges::upper_bound(frames, end);
  if (past == frames.end()) return inside;
  const std::string place = "clip \"" + clip->name + '"';
  const std::string ends = endText(*clip, options.framesPerSecond, static_cast<int>(std::floor(end)));
  if (past == frames.begin()) {
    return Error{file.string(), place, ends + ", before the first of --frames " + options.frames};
  }
  inside.count = static_cast<std::size_t>(past - frames.begin());
  std::erase_if(inside.wanted, [&](std::size_t moment) { return moment >= inside.count; });
  const std::size_t left = frames.size() - inside.count;
  inside.left = file.string() + ": " + place + ": " + ends + "; " + std::to_string(left) +
                (left == 1 ? " frame past it is" : " frames past it are") + " left out";
  return inside;
}

}  // namespace sinew::app
