// app/ui/window.cpp: GLFW behind the Window.
#include "app/ui/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include <glm/common.hpp>

namespace sinew::app {

namespace {

constexpr std::string_view kPunctuation = "',-./;=[\\]`";  ///< GLFW's codes of these keys are their ASCII characters.

}  // namespace

int keyMeaning(int key, const char* printed) {
  const bool printable = key > GLFW_KEY_SPACE && key < GLFW_KEY_ESCAPE;
  const bool digit = key >= GLFW_KEY_0 && key <= GLFW_KEY_9;
  if (!printable || digit || printed == nullptr) return key;
  const std::string_view sign = printed;
  if (sign.size() != 1) return key;  // Not ASCII.
  if (sign[0] >= 'a' && sign[0] <= 'z') return GLFW_KEY_A + (sign[0] - 'a');
  if (sign[0] >= 'A' && sign[0] <= 'Z') return GLFW_KEY_A + (sign[0] - 'A');
  return kPunctuation.find(sign[0]) != std::string_view::npos ? static_cast<int>(sign[0]) : key;
}

namespace {

std::string lastGlfwError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

void setContextHints() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);  // The viewport has its own framebuffer with samples.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "sinew");  // As in the desktop entry, for name and icon.
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "sinew");
}

/// Enough of it is on a screen to be grabbed.
bool isOnScreen(const WindowPlace& place) {
  constexpr int kSeen = 100;
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  return std::any_of(monitors, monitors + count, [&](GLFWmonitor* monitor) {
    glm::ivec2 corner{0};
    glm::ivec2 size{0};
    glfwGetMonitorWorkarea(monitor, &corner.x, &corner.y, &size.x, &size.y);
    const glm::ivec2 low = glm::max(corner, glm::ivec2(place.x, place.y));
    const glm::ivec2 high = glm::min(corner + size, glm::ivec2(place.x + place.width, place.y + place.height));
    return high.x - low.x >= kSeen && high.y - low.y >= kSeen;
  });
}

/// At most as large as the primary screen, in units that grow with the content scale.
glm::ivec2 fittedToScreen(const glm::ivec2& size) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return size;
  glm::ivec2 corner{0};
  glm::ivec2 area{0};
  glfwGetMonitorWorkarea(monitor, &corner.x, &corner.y, &area.x, &area.y);
  glm::vec2 scale{1.0f};
  glfwGetMonitorContentScale(monitor, &scale.x, &scale.y);
  return area.x > 0 && area.y > 0 ? glm::min(size, glm::ivec2(glm::vec2(area) / scale)) : size;
}

void restore(GLFWwindow* window, const WindowPlace& place) {
  glfwSetWindowPos(window, place.x, place.y);
  if (place.maximized) glfwMaximizeWindow(window);
  glfwShowWindow(window);
}

Window& self(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const glm::ivec2& size, const std::string& title,
                                             const WindowPlace& before) {
  if (glfwInit() != GLFW_TRUE) return Error{"", "window", "no display can be opened: " + lastGlfwError()};
  setContextHints();
  std::unique_ptr<Window> window(new Window);
  const bool known = isOnScreen(before);
  // Its former size is in pixels; it is shown after it is placed.
  if (known) glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_FALSE);
  if (known) glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  const glm::ivec2 wanted = known ? glm::ivec2(before.width, before.height) : fittedToScreen(size);
  window->window_ = glfwCreateWindow(wanted.x, wanted.y, title.c_str(), nullptr, nullptr);
  if (window->window_ == nullptr) return Error{"", "window", "OpenGL 4.5 is needed: " + lastGlfwError()};
  window->title_ = title;
  glfwMakeContextCurrent(window->window_);
  glfwSwapInterval(1);
  window->installCallbacks();
  if (known) {
    window->place_ = before;
    restore(window->window_, before);
  }
  return window;
}

Window::~Window() {
  if (window_ != nullptr) glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::installCallbacks() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetWindowSizeLimits(window_, 800, 500, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    self(w).input_.move({static_cast<float>(x), static_cast<float>(y)});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) { self(w).input_.enter(entered == GLFW_TRUE); });
  glfwSetMouseButtonCallback(
      window_, [](GLFWwindow* w, int button, int action, int) { self(w).input_.button(button, action == GLFW_PRESS); });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    self(w).input_.scroll({static_cast<float>(x), static_cast<float>(y)});
  });
  glfwSetKeyCallback(
      window_, [](GLFWwindow* w, int key, int scancode, int action, int) { self(w).takeKey(key, scancode, action); });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned codepoint) { self(w).input_.character(codepoint); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    if (focused != GLFW_TRUE) self(w).input_.releaseAll();
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w).refresh_ = true; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w).refresh_ = true; });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    for (int i = 0; i < count; ++i) self(w).drops_.emplace_back(paths[i]);
  });
}

void Window::takeKey(int key, int scancode, int action) {
  if (key < 0 || key >= kKeyCodes) return;
  // The layout may change while a key is held: its release means the same as its press.
  int& meaning = meanings_[static_cast<std::size_t>(key)];
  if (action == GLFW_PRESS || meaning == 0) meaning = keyMeaning(key, glfwGetKeyName(key, scancode));
  if (action == GLFW_REPEAT) input_.keyRepeat(meaning);
  else input_.key(meaning, action == GLFW_PRESS);
  if (action == GLFW_RELEASE) meaning = 0;
}

glm::ivec2 Window::size() const {
  glm::ivec2 size{0};
  glfwGetWindowSize(window_, &size.x, &size.y);
  return size;
}

glm::ivec2 Window::framebufferSize() const {
  glm::ivec2 size{0};
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

float Window::contentScale() const {
  float x = 1.0f;
  float y = 1.0f;
  glfwGetWindowContentScale(window_, &x, &y);
  // Window coordinates may already be scaled (not on X11); the interface scales by the rest.
  const glm::ivec2 window = size();
  const float ratio = window.x > 0 ? static_cast<float>(framebufferSize().x) / static_cast<float>(window.x) : 1.0f;
  return std::clamp(std::max(x, y) / std::max(ratio, 0.1f), 1.0f, 4.0f);
}

WindowPlace Window::place() const {
  const bool maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
  const bool away = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
  if (!maximized && !away) {
    glfwGetWindowPos(window_, &place_.x, &place_.y);
    glfwGetWindowSize(window_, &place_.width, &place_.height);
  }
  if (!away) place_.maximized = maximized;
  return place_;
}

void Window::setTitle(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_, title.c_str());
}

bool Window::closeRequested() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

void Window::clearCloseRequest() { glfwSetWindowShouldClose(window_, GLFW_FALSE); }

void Window::poll() { glfwPollEvents(); }

void Window::wait(double seconds) { glfwWaitEventsTimeout(seconds); }

void Window::swap() { glfwSwapBuffers(window_); }

std::vector<std::filesystem::path> Window::takeDrops() { return std::exchange(drops_, {}); }

bool Window::takeRefresh() { return std::exchange(refresh_, false); }

}  // namespace sinew::app
