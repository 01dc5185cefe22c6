// app/viewport/tools/pick_cycle.h: clicks on one place, one after the other, take what lies there in turn.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/viewport/render/view.h"
#include "app/viewport/tools/select.h"

namespace sinew::app {

/// What was found by the first click on a place, and which of it the last click took. Things are known by identity: a
/// clip that plays meanwhile does not mix them up.
struct PickCycle {
  std::vector<PickEntry> here;  ///< Empty: no cycle.
  std::size_t taken = 0;        ///< Index into `here`.
  glm::vec2 pixel{0.0f};        ///< The first click's.
  View view;
  std::vector<glm::mat4> boneInWorld;
  std::size_t step = 0;  ///< The document's, at the last click.
};

/// "deltoid L", "bone spine"; "" for a muscle that the rig lacks.
[[nodiscard]] std::string nameOf(const PickEntry& entry, const Document& document);

/// A click at the pixel would go on: it is within a few pixels of the first one, camera and rig have not changed, the
/// pose neither (unless a clip plays), and what the last click took is still selected.
[[nodiscard]] bool goesOn(const PickCycle& cycle, const ViewportContext& context, const View& view,
                          const glm::vec2& pixel);

/// `hover` as found at the pixel becomes what a click there takes: the next of the cycle, if that goes on.
void aim(ViewportHover& hover, const PickCycle& cycle, const ViewportContext& context, const View& view,
         const glm::vec2& pixel);

/// After a click has taken `hover`: begins the cycle or goes on, and aims at what the next click takes.
void advance(PickCycle& cycle, ViewportHover& hover, const ViewportContext& context, const View& view,
             const glm::vec2& pixel);

/// Takes what is selected already, if that is here; else it stays with the first.
void aimAtSelected(ViewportHover& hover, const Document& document);

/// "2 of 5 here" while a cycle goes on, "5 here" before the first click; "" for one thing alone.
[[nodiscard]] std::string countHere(const ViewportHover& hover);
/// What the next click takes while a cycle goes on: a muscle's name, or "bone" and its name.
[[nodiscard]] std::string nextHere(const ViewportHover& hover, const Document& document);

}  // namespace sinew::app
