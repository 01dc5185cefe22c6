// app/ui/imgui_layer.cpp: ImGui's platform backend. (The stock GLFW backend bypasses the input queue.)
#include "app/ui/imgui_layer.h"

#include <epoxy/gl.h>
#include <imgui.h>

#include <backends/imgui_impl_opengl3.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "app/ui/code_points.h"
#include "app/ui/keyboard_focus.h"
#include "app/ui/reading_order.h"
#include "app/ui/style.h"

namespace sinew::app {
namespace {

constexpr float kDoubleClickSeconds = 0.3f;

const char* readClipboard(void* window) {
  const char* const text = glfwGetClipboardString(static_cast<GLFWwindow*>(window));
  if (text != nullptr) noteShown(codePoints(text));
  return text;
}
void writeClipboard(void* window, const char* text) { glfwSetClipboardString(static_cast<GLFWwindow*>(window), text); }

int glfwShapeOf(int cursor) {
  switch (cursor) {
    case ImGuiMouseCursor_TextInput:
      return GLFW_IBEAM_CURSOR;
    case ImGuiMouseCursor_ResizeNS:
      return GLFW_VRESIZE_CURSOR;
    case ImGuiMouseCursor_ResizeEW:
      return GLFW_HRESIZE_CURSOR;
    case ImGuiMouseCursor_Hand:
      return GLFW_HAND_CURSOR;
    default:
      return GLFW_ARROW_CURSOR;
  }
}

}  // namespace

void mapKeys() {
  int* map = ImGui::GetIO().KeyMap;
  map[ImGuiKey_Tab] = GLFW_KEY_TAB;
  map[ImGuiKey_LeftArrow] = GLFW_KEY_LEFT;
  map[ImGuiKey_RightArrow] = GLFW_KEY_RIGHT;
  map[ImGuiKey_UpArrow] = GLFW_KEY_UP;
  map[ImGuiKey_DownArrow] = GLFW_KEY_DOWN;
  map[ImGuiKey_PageUp] = GLFW_KEY_PAGE_UP;
  map[ImGuiKey_PageDown] = GLFW_KEY_PAGE_DOWN;
  map[ImGuiKey_Home] = GLFW_KEY_HOME;
  map[ImGuiKey_End] = GLFW_KEY_END;
  map[ImGuiKey_Insert] = GLFW_KEY_INSERT;
  map[ImGuiKey_Delete] = GLFW_KEY_DELETE;
  map[ImGuiKey_Backspace] = GLFW_KEY_BACKSPACE;
  map[ImGuiKey_Space] = GLFW_KEY_SPACE;
  map[ImGuiKey_Enter] = GLFW_KEY_ENTER;
  map[ImGuiKey_Escape] = GLFW_KEY_ESCAPE;
  map[ImGuiKey_KeyPadEnter] = GLFW_KEY_KP_ENTER;
  map[ImGuiKey_A] = GLFW_KEY_A;
  map[ImGuiKey_C] = GLFW_KEY_C;
  map[ImGuiKey_V] = GLFW_KEY_V;
  map[ImGuiKey_X] = GLFW_KEY_X;
  map[ImGuiKey_Y] = GLFW_KEY_Y;
  map[ImGuiKey_Z] = GLFW_KEY_Z;
}

void feedImGui(const RawInput& input) {
  ImGuiIO& io = ImGui::GetIO();
  const bool dragging = std::ranges::find(input.buttons, true) != input.buttons.end();
  const bool known = input.mouseInside || dragging;
  io.MousePos = known ? ImVec2(input.mouse.x, input.mouse.y) : ImVec2(-FLT_MAX, -FLT_MAX);
  std::ranges::copy(input.buttons, io.MouseDown);
  io.MouseWheel += input.scroll.y;
  io.MouseWheelH += input.scroll.x;
  std::ranges::copy(input.keys, io.KeysDown);
  io.KeyCtrl = input.control;
  io.KeyShift = input.shift;
  io.KeyAlt = input.alt;
  io.KeySuper = input.super;
  for (const char32_t c : input.characters) {
    io.AddInputCharacter(c);
    noteShown({&c, 1});
  }
  feedFocusKeys(input);
}

ImGuiLayer::ImGuiLayer(GLFWwindow* window, float scale) : window_(window), scale_(scale) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.SetClipboardTextFn = writeClipboard;
  io.GetClipboardTextFn = readClipboard;
  io.ClipboardUserData = window;
  mapKeys();
  applyStyle(scale);
  makeFonts();
  setGlyphs([this](char32_t c) { return names_.has(c); });
  ImGui_ImplOpenGL3_Init("#version 450 core");
  for (int cursor = 0; cursor < ImGuiMouseCursor_COUNT; ++cursor) {
    cursors_[static_cast<std::size_t>(cursor)] = glfwCreateStandardCursor(glfwShapeOf(cursor));
  }
}

ImGuiLayer::~ImGuiLayer() {
  setGlyphs({});
  for (GLFWcursor* cursor : cursors_) {
    if (cursor != nullptr) glfwDestroyCursor(cursor);
  }
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void ImGuiLayer::makeFonts() {
  fonts_ = loadFonts(scale_);
  names_.build(fonts_);
}

bool ImGuiLayer::prepareFonts(float scale) {
  if (scale == scale_ && !names_.outdated()) return false;
  if (scale != scale_) applyStyle(scale);
  scale_ = scale;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui::GetIO().Fonts->Clear();
  makeFonts();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  return true;
}

void ImGuiLayer::beginFrame(const RawInput& input, double seconds, double drawing) {
  ImGuiIO& io = ImGui::GetIO();
  int width = 0;
  int height = 0;
  int pixelWidth = 0;
  int pixelHeight = 0;
  glfwGetWindowSize(window_, &width, &height);
  glfwGetFramebufferSize(window_, &pixelWidth, &pixelHeight);
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  if (width > 0 && height > 0) {
    io.DisplayFramebufferScale = {static_cast<float>(pixelWidth) / io.DisplaySize.x,
                                  static_cast<float>(pixelHeight) / io.DisplaySize.y};
  }
  io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 1.0));
  // A double click takes three frames, which may be slow.
  io.MouseDoubleClickTime = kDoubleClickSeconds + 2.0f * static_cast<float>(std::clamp(drawing, 0.0, 1.0));
  feedImGui(input);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

ImDrawData& ImGuiLayer::endFrame() {
  showCursor();
  ImGui::Render();
  names_.want(takeShown());
  return *ImGui::GetDrawData();
}

void ImGuiLayer::showCursor() {
  const int wanted = ImGui::GetMouseCursor();
  if (wanted == shownCursor_) return;
  shownCursor_ = wanted;
  glfwSetInputMode(window_, GLFW_CURSOR, wanted == ImGuiMouseCursor_None ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
  if (wanted != ImGuiMouseCursor_None) glfwSetCursor(window_, cursors_[static_cast<std::size_t>(wanted)]);
}

}  // namespace sinew::app
