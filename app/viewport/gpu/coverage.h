// app/viewport/gpu/coverage.h: which surfaces the graphics card computes. docs/performance.md.
#pragma once

#include <optional>
#include <string>

#include "core/surface/preparation.h"

namespace sinew::app {

/// What holds in every pose; poseMuscles (card_pose.h) tells what only some poses ask for.
///
/// Why the whole surface is left to the processor, in the user's words, one line; nullopt: the card computes it.
/// @param bodies  of a crowd, each in a pose of its own
[[nodiscard]] std::optional<std::string> leftToProcessor(const Preparation& preparation, int bodies = 1);

}  // namespace sinew::app
