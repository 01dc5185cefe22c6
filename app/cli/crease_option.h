// app/cli/crease_option.h: --crease, which `smooth` and `render` share.
#pragma once

#include <optional>

namespace CLI {
class App;
}

namespace sinew::app {

/// --crease DEGREES, 0 to 180, in place of the rig's crease angle. `degrees` must outlive the parse.
void addCreaseOption(CLI::App& verb, std::optional<float>& degrees);

}  // namespace sinew::app
