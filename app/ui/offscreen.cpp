// app/ui/offscreen.cpp: EGL without a display.
#include "app/ui/offscreen.h"

#include <array>
#include <cstring>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace sinew::app {
namespace {

struct EglContext {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  EGLSurface surface = EGL_NO_SURFACE;
};

bool listed(const char* extensions, const char* name) {
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

/// Makes a context on a display current; on failure terminates the display.
EglContext contextOn(EGLDisplay display) {
  EglContext made;
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return made;
  const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  const std::array<EGLint, 7> version{
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (eglBindAPI(EGL_OPENGL_API) == EGL_TRUE &&
      eglChooseConfig(display, wanted.data(), &config, 1, &found) == EGL_TRUE && found > 0) {
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
    if (context != EGL_NO_CONTEXT) {
      if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
        return {display, context, EGL_NO_SURFACE};
      }
      const std::array<EGLint, 5> small{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
      const EGLSurface surface = eglCreatePbufferSurface(display, config, small.data());
      if (surface != EGL_NO_SURFACE && eglMakeCurrent(display, surface, surface, context) == EGL_TRUE) {
        return {display, context, surface};
      }
      if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
      eglDestroyContext(display, context);
    }
  }
  eglTerminate(display);
  return made;
}

EglContext firstContext() {
  // By name: epoxy aborts on eglGetPlatformDisplay without a display.
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto platformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EglContext made;
  if (platformDisplay != nullptr && listed(extensions, "EGL_MESA_platform_surfaceless")) {
    made = contextOn(platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
  }
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  if (made.context == EGL_NO_CONTEXT && platformDisplay != nullptr && queryDevices != nullptr &&
      listed(extensions, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, 8> devices{};
    EGLint count = 0;
    if (queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE) count = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count) && made.context == EGL_NO_CONTEXT; ++i) {
      made = contextOn(platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
  }
  if (made.context == EGL_NO_CONTEXT) made = contextOn(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return made;
}

}  // namespace

Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create() {
  const EglContext made = firstContext();
  if (made.context == EGL_NO_CONTEXT) {
    return Error{"", "",
                 "no graphics driver offers OpenGL 4.5 through EGL (on Debian, libgl1-mesa-dri and libegl1 do)"};
  }
  std::unique_ptr<OffscreenContext> context(new OffscreenContext);
  context->display_ = made.display;
  context->context_ = made.context;
  context->surface_ = made.surface;
  return context;
}

OffscreenContext::~OffscreenContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (surface_ != nullptr) eglDestroySurface(display_, surface_);
  eglDestroyContext(display_, context_);
  // The process-wide display stays: others may use it, and initializing it again is slow.
}

}  // namespace sinew::app
