// core/runtime/c_handles.h: the structs behind the handles of the C interface, and its errors.
#pragma once

#include <memory>
#include <new>
#include <string>
#include <vector>

#include "sinew/c/sinew_runtime.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/runtime/vertex_buffer.h"
#include "sinew/surface/smoother.h"

struct sinew_character {
  std::shared_ptr<const sinew::Character> character;
  sinew::Rig rig;
};

struct sinew_smoother {
  sinew_character of;
  sinew::Smoother smoother;
  sinew::Surface surface;
  sinew::Pose pose{};                       ///< Reused from frame to frame.
  std::vector<sinew::IndexRange> ranges{};  ///< Of materials.
};

namespace sinew::capi {

/// Keeps the reason for sinew_error(), truncated if very long; does not allocate.
sinew_code fail(sinew_code code, const char* reason);
sinew_code fail(sinew_code code, const Error& error);

/// No exception leaves the interface.
template <class Work>
sinew_code guarded(Work work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(SINEW_NO_MEMORY, "out of memory");
  } catch (...) {
    return fail(SINEW_NO_MEMORY, "the call could not be finished");
  }
}

}  // namespace sinew::capi
