// tests/support/rigs/keyed_links.cpp: five keys a link, of few different values.
#include "tests/support/rigs/keyed_links.h"

#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {

Rig withKeyedLinks(Rig rig, const AnimationClip& clip, std::uint64_t seed) {
  constexpr int kKeys = 5;
  Random random(seed);
  for (std::size_t i = 0; i < rig.links.size(); ++i) {
    if (i % 4 == 3) continue;
    KeyTrack track{clip.name, {{}, CurveKind::kLinear}, {}};
    for (int k = 0; k < kKeys; ++k) {
      const float time = clip.duration * static_cast<float>(k) / static_cast<float>(kKeys - 1);
      track.curve.points.push_back({time, 0.25f * static_cast<float>(random.below(5))});
    }
    rig.links[i].animated = {{Parameter::kLinkAmount, {track}, {}, {}}};
  }
  return rig;
}

Rig withoutKeys(Rig rig) {
  for (Link& link : rig.links) link.animated.clear();
  return rig;
}

}  // namespace sinew::test
