// app/platform/window.cpp: GLFW behind the Window.

#include "app/platform/window.h"

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace sinew::app {
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
  // The viewport has its own framebuffer and samples; the window's only gets copies.
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
}

Window& self(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const glm::ivec2& size, const std::string& title) {
  if (glfwInit() != GLFW_TRUE) return Error{"", "window", "no display can be opened: " + lastGlfwError()};
  setContextHints();
  std::unique_ptr<Window> window(new Window);
  window->window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (window->window_ == nullptr) return Error{"", "window", "OpenGL 4.5 is needed: " + lastGlfwError()};
  window->title_ = title;
  glfwMakeContextCurrent(window->window_);
  glfwSwapInterval(1);
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view rendererName = renderer != nullptr ? renderer : "";
  window->software_ = rendererName.find("llvmpipe") != std::string_view::npos ||
                      rendererName.find("softpipe") != std::string_view::npos;
  window->installCallbacks();
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
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
    if (action == GLFW_REPEAT) {
      self(w).input_.keyRepeat(key);
    } else {
      self(w).input_.key(key, action == GLFW_PRESS);
    }
  });
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
  // Window coordinates may already be scaled (as elsewhere than X11): what is left is the interface's own factor.
  const glm::ivec2 window = size();
  const float ratio = window.x > 0 ? static_cast<float>(framebufferSize().x) / static_cast<float>(window.x) : 1.0f;
  return std::clamp(std::max(x, y) / std::max(ratio, 0.1f), 1.0f, 4.0f);
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
