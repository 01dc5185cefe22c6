// app/document/group_colors.cpp: colors of groups and territories.
#include "app/document/group_colors.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>

#include "core/geometry/at.h"

namespace sinew::app {
namespace {

// Found by search: largest distance in Oklab, as seen by all and with red-green deficiencies (Machado 2009).
constexpr std::array<glm::vec3, kGroupColors> kColors{glm::vec3{0.32f, 0.67f, 0.96f}, glm::vec3{0.95f, 0.83f, 0.30f},
                                                      glm::vec3{0.80f, 0.23f, 0.42f}, glm::vec3{0.27f, 0.77f, 0.47f},
                                                      glm::vec3{0.86f, 0.71f, 0.79f}, glm::vec3{0.34f, 0.42f, 0.92f},
                                                      glm::vec3{0.63f, 0.54f, 0.14f}, glm::vec3{0.68f, 0.96f, 0.82f}};
constexpr glm::vec3 kNoGroup{0.58f, 0.61f, 0.66f};

}  // namespace

glm::vec3 groupColor(int slot) {
  assert(slot >= 0);
  const auto index = static_cast<std::size_t>(slot);
  const glm::vec3 base = kColors[index % kColors.size()];
  constexpr std::array kPale{0.0f, 0.38f, -0.34f, 0.6f, -0.52f};
  const float pale = kPale[(index / kColors.size()) % kPale.size()];
  return pale >= 0.0f ? glm::mix(base, glm::vec3(0.93f), pale) : base * (1.0f + pale);
}

int colorSlot(const Rig& rig, int group) {
  const GroupId id = at(rig.groups, group).id();
  return id ? static_cast<int>(id.value - 1) : group;
}

glm::vec3 groupColor(const Rig& rig, const std::string& group) {
  const int index = findGroup(rig, group);
  return index < 0 ? kNoGroup : groupColor(colorSlot(rig, index));
}

glm::vec3 toLinear(const glm::vec3& srgb) {
  const auto decode = [](float s) { return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f); };
  return {decode(srgb.r), decode(srgb.g), decode(srgb.b)};
}

}  // namespace sinew::app
