// core/character/clip_names.cpp: the clips of a character as a refusal lists them.
#include "core/character/clip_names.h"

#include "core/geometry/nearest_name.h"

namespace sinew {

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
