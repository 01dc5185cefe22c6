// app/viewport/tools/pick_cycle.h: repeated clicks on one place pick what lies there in turn.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/viewport/render/view.h"
#include "app/viewport/tools/select.h"

namespace sinew::app {

/// The things found by the first click on a place, and the one picked last; by identity, since clips may be playing.
struct PickCycle {
  std::vector<PickEntry> here;  ///< Empty: no cycle.
  std::size_t taken = 0;        ///< Index into `here`.
  glm::vec2 pixel{0.0f};        ///< The first click's.
  View view;
  std::vector<glm::mat4> boneInWorld;
  std::size_t step = 0;  ///< Document step of the last click.
};

/// "deltoid L", "bone spine"; "" for a muscle that the rig lacks.
[[nodiscard]] std::string nameOf(const PickEntry& entry, const Document& document);

/// Whether a click at the pixel continues: it is within a few pixels of the first one, camera, rig and pose (unless a
/// clip plays) are unchanged, and what the last click picked is still selected.
[[nodiscard]] bool goesOn(const PickCycle& cycle, const ViewportContext& context, const View& view,
                          const glm::vec2& pixel);

/// Sets `hover` to the next of the cycle, if that continues.
void aim(ViewportHover& hover, const PickCycle& cycle, const ViewportContext& context, const View& view,
         const glm::vec2& pixel);

/// Begins or continues the cycle after a click has picked `hover`, and aims at the next.
void advance(PickCycle& cycle, ViewportHover& hover, const ViewportContext& context, const View& view,
             const glm::vec2& pixel);

void aimAtSelected(ViewportHover& hover, const Document& document);  ///< Aims at what is selected, if that is here.

/// "2 of 5 here" in a cycle, "5 here" before the first click; "" for a single thing.
[[nodiscard]] std::string countHere(const ViewportHover& hover);
/// Name of the next pick in a cycle: a muscle's name, or "bone" and its name.
[[nodiscard]] std::string nextHere(const ViewportHover& hover, const Document& document);

}  // namespace sinew::app
