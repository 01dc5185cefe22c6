// app/ui/key_meaning.h: the letter printed on a key, not its place on a US keyboard.
#pragma once

namespace sinew::app {

/// GLFW names keys by their place on a US keyboard; what shortcuts mean is the letter that the user's layout gives.
/// Letters and punctuation follow the layout. The row of digits keeps its place, as some layouts (AZERTY) give
/// punctuation there and digits with Shift only; so do keys whose sign is no ASCII character (a Cyrillic layout, say).
/// @param key  GLFW's code; @param printed  what glfwGetKeyName says of it, null if nothing.
[[nodiscard]] int keyMeaning(int key, const char* printed);

}  // namespace sinew::app
