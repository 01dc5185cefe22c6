// app/editor/keymaps.cpp: where a keymap differs from the keys in the action table, which are those of Maya's kind.

#include "app/editor/action_table.h"

namespace sinew::app {
namespace {

using namespace table;

constexpr KeyChange kBlender[] = {
    {"edit/duplicate", shift(GLFW_KEY_D), ctrl(GLFW_KEY_D)},
    {"edit/delete", key(GLFW_KEY_X), key(GLFW_KEY_DELETE)},
    {"edit/select-all", key(GLFW_KEY_A), ctrl(GLFW_KEY_A)},
    {"edit/select-none", alt(GLFW_KEY_A), key(GLFW_KEY_ESCAPE)},
    {"view/frame", key(GLFW_KEY_KP_DECIMAL), kNone},
    {"view/frame-all", key(GLFW_KEY_HOME), kNone},
    {"tool/select", key(GLFW_KEY_W), kNone},
    {"tool/move", kNone, kNone},
    {"tool/rotate", kNone, kNone},
    {"tool/scale", kNone, kNone},
    {"tool/grab", key(GLFW_KEY_G), kNone},
    {"tool/turn", key(GLFW_KEY_R), kNone},
    {"tool/size", key(GLFW_KEY_S), kNone},
    {"tool/add-muscle", shift(GLFW_KEY_A), key(GLFW_KEY_M)},
    {"tool/box-select", key(GLFW_KEY_B), kNone},
    {"tool/territory", shift(GLFW_KEY_B), kNone},
    {"tool/axes", key(GLFW_KEY_COMMA), kNone},
    {"play/previous", key(GLFW_KEY_LEFT), kNone},
    {"play/next", key(GLFW_KEY_RIGHT), kNone},
    {"play/start", shift(GLFW_KEY_LEFT), kNone},
    {"play/end", shift(GLFW_KEY_RIGHT), kNone},
    {"help/palette", key(GLFW_KEY_F3), ctrl(GLFW_KEY_P)},
};

}  // namespace

std::span<const KeyChange> changesOf(Keymap keymap) {
  if (keymap == Keymap::kBlender) return kBlender;
  return {};
}

const char* titleOf(Keymap keymap) { return keymap == Keymap::kBlender ? "Blender-like" : "Maya-like"; }

}  // namespace sinew::app
