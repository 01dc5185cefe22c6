// app/viewport/gpu/part_timers.cpp: OpenGL's time stamps.
#include "app/viewport/gpu/part_timers.h"

namespace sinew::app {

PartTimers::PartTimers() {
  for (std::size_t i = 0; i <= kSurfaceParts; ++i) stamps_.push_back(makeQuery(GL_TIMESTAMP));
}

void PartTimers::begin() {
  glQueryCounter(stamps_.front().id(), GL_TIMESTAMP);
  begun_ = true;
}

void PartTimers::end(SurfacePart part) {
  glQueryCounter(stamps_[static_cast<std::size_t>(part) + 1].id(), GL_TIMESTAMP);
}

PartSeconds PartTimers::seconds() const {
  std::array<GLuint64, kSurfaceParts + 1> at{};
  for (std::size_t i = 0; i <= kSurfaceParts; ++i) glGetQueryObjectui64v(stamps_[i].id(), GL_QUERY_RESULT, &at[i]);
  PartSeconds seconds{};
  for (std::size_t i = 0; i < kSurfaceParts; ++i) seconds[i] = static_cast<double>(at[i + 1] - at[i]) * 1e-9;
  return seconds;
}

std::optional<PartSeconds> PartTimers::secondsIfDone() const {
  if (!begun_) return std::nullopt;
  GLint done = GL_FALSE;
  glGetQueryObjectiv(stamps_.back().id(), GL_QUERY_RESULT_AVAILABLE, &done);
  if (done == GL_FALSE) return std::nullopt;
  return seconds();
}

}  // namespace sinew::app
