// app/ui/key_meaning.cpp: keys by what is printed on them.

#include "app/ui/key_meaning.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string_view>

namespace sinew::app {
namespace {

/// GLFW's codes of these keys are their ASCII characters; codes of keypad and function keys lie above.
constexpr std::string_view kPunctuation = "',-./;=[\\]`";

}  // namespace

int keyMeaning(int key, const char* printed) {
  const bool printable = key > GLFW_KEY_SPACE && key < GLFW_KEY_ESCAPE;
  const bool digit = key >= GLFW_KEY_0 && key <= GLFW_KEY_9;
  if (!printable || digit || printed == nullptr) return key;
  const std::string_view sign = printed;
  if (sign.size() != 1) return key;  // Longer ones are not ASCII.
  if (sign[0] >= 'a' && sign[0] <= 'z') return GLFW_KEY_A + (sign[0] - 'a');
  if (sign[0] >= 'A' && sign[0] <= 'Z') return GLFW_KEY_A + (sign[0] - 'A');
  return kPunctuation.find(sign[0]) != std::string_view::npos ? static_cast<int>(sign[0]) : key;
}

}  // namespace sinew::app
