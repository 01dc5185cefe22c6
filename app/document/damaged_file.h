// app/document/damaged_file.h: why a file could not be opened, in the words of who made it.
#pragma once

#include <string>

#include "sinew/geometry/result.h"

namespace sinew::app {

/// Error::plainText(); but of a file that is no JSON: "limb.rig.json is damaged or not a rig: line 12, column 3: the
/// file ends too early". The command line says what the reader of the file says (Error::text()).
[[nodiscard]] std::string openErrorText(const Error& error);

}  // namespace sinew::app
