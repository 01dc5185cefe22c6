// core/character/clip_names.cpp: ranks clips by words in their names; lists clips in an error.
#include "core/character/clip_names.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/character/bone_names.h"
#include "core/geometry/nearest_name.h"

namespace sinew {

namespace {

enum class ClipKind { kWalk, kIdle, kRun, kOther, kViolent };  ///< In order of preference.

template <std::size_t kCount>
bool isOneOf(const std::string& word, const std::array<std::string_view, kCount>& list) {
  return std::ranges::find(list, word) != list.end();
}

bool isViolent(const std::string& word) {
  constexpr std::array<std::string_view, 8> kDying{"die", "dies", "died", "dying", "dead", "kill", "killed", "defeat"};
  return word.find("attack") != std::string::npos || word.find("death") != std::string::npos || isOneOf(word, kDying);
}

bool isWalk(const std::string& word) {
  return word.starts_with("walk") || word.ends_with("walk") || word.ends_with("walking");
}

bool isIdle(const std::string& word) {
  return word.starts_with("idle") || word.starts_with("idling") || word.ends_with("idle");
}

/// Not "rune" or "runway".
bool isRun(const std::string& word) {
  return word == "run" || word == "runs" || word.starts_with("running") || word.starts_with("runcycle") ||
         word.starts_with("runloop");
}

/// Does not name a movement.
bool isPlain(const std::string& word) {
  constexpr std::array<std::string_view, 10> kPlain{"cycle",  "loop",    "looped", "anim",  "animation",
                                                    "action", "forward", "fwd",    "place", "in"};
  return isOneOf(word, kPlain);
}

ClipKind kindOf(const std::vector<std::string>& words) {
  const auto says = [&](bool (*test)(const std::string&)) { return std::ranges::any_of(words, test); };
  if (says(isViolent)) return ClipKind::kViolent;
  if (says(isWalk)) return ClipKind::kWalk;
  if (says(isIdle)) return ClipKind::kIdle;
  return says(isRun) ? ClipKind::kRun : ClipKind::kOther;
}

/// Less is better.
std::pair<ClipKind, std::ptrdiff_t> rankOf(const AnimationClip& clip) {
  const std::vector<std::string> words = wordsOf(clip.name);
  const ClipKind kind = kindOf(words);
  const bool named = kind == ClipKind::kWalk || kind == ClipKind::kIdle || kind == ClipKind::kRun;
  return {kind, named ? std::ranges::count_if(words, [](const auto& word) { return !isPlain(word); }) : 0};
}

}  // namespace

int firstClip(std::span<const AnimationClip> clips) {
  const bool anyMoves = std::ranges::any_of(clips, [](const AnimationClip& clip) { return clip.duration > 0.0f; });
  int best = -1;
  std::optional<std::pair<ClipKind, std::ptrdiff_t>> least;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (anyMoves && !(clips[i].duration > 0.0f)) continue;
    const auto rank = rankOf(clips[i]);
    if (least && rank >= *least) continue;
    least = rank;
    best = static_cast<int>(i);
  }
  return best;
}

std::string noSuchClip(const std::string& name, const std::vector<AnimationClip>& clips,
                       const std::vector<std::string>& made) {
  std::vector<std::string> names;
  std::string known;
  for (const AnimationClip& clip : clips) {
    known += (known.empty() ? "\"" : ", \"") + clip.name + '"';
    names.push_back(clip.name);
  }
  names.insert(names.end(), made.begin(), made.end());
  const std::string expected =
      clips.empty() ? std::string(kNoClips) : "expected " + (clips.size() > 1 ? "one of " + known : known);
  return expected + didYouMean(name, names);
}

}  // namespace sinew
