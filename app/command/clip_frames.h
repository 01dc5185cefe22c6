// app/command/clip_frames.h: which of a job's frames a clip holds.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/command/batch.h"
#include "sinew/character/animation_clip.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

struct ClipFrames {
  std::size_t count = 1;            ///< The first so many of the job's moments.
  std::vector<std::size_t> wanted;  ///< Of the moments that were wanted, those.
  std::string left;                 ///< What is left out, in words; "" for nothing.
};

/// Frames past a clip's end would all show its last pose: they are left out.
/// @param frames  of the job; empty: one moment  @param wanted  BatchInput::wanted
/// @param clip  null: the bind pose  @param file  named in the error
/// Error: the clip ends before the first frame.
[[nodiscard]] Result<ClipFrames> framesInClip(const std::vector<int>& frames, const BatchOptions& options,
                                              const std::vector<std::size_t>& wanted, const AnimationClip* clip,
                                              const std::filesystem::path& file);

}  // namespace sinew::app
