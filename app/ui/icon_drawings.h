// app/ui/icon_drawings.h: how icons are drawn: a function each, on a grid of 16 units.
#pragma once

#include <array>

#include "app/ui/icons.h"
#include "app/ui/pen.h"

namespace sinew::app {

using IconDrawing = void (*)(const Pen&);
using IconDrawings = std::array<IconDrawing, kIconCount>;  ///< By Icon; null: nothing is drawn.

[[nodiscard]] constexpr std::size_t at(Icon icon) { return static_cast<std::size_t>(icon); }

void addToolDrawings(IconDrawings& drawings);
void addMarkDrawings(IconDrawings& drawings);

}  // namespace sinew::app
