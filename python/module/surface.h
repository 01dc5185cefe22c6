// python/module/surface.h: a surface as Python holds it, and memory that is used again when nobody holds it any more.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <pybind11/pybind11.h>

#include "sinew/character/character.h"
#include "sinew/surface/surface.h"

namespace sinew::python {

/// What arrays of Python look into. Never written to again while anything holds it.
struct SurfaceMemory {
  std::shared_ptr<const Character> character;
  Surface surface;
};

/// Memory of surfaces that nobody holds any more, for the next ones. From any thread.
class SurfacePool {
 public:
  /// Its memory comes back here when the last that holds it lets go, if the pool is still there.
  [[nodiscard]] static std::shared_ptr<SurfaceMemory> take(const std::shared_ptr<SurfacePool>& pool,
                                                           const std::shared_ptr<const Character>& character);

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<SurfaceMemory>> idle_;
};

/// An object of Python over a surface; arrays keep it.
struct SurfaceHandle {
  std::shared_ptr<SurfaceMemory> memory;

  [[nodiscard]] Surface& surface() const { return memory->surface; }
};

void defineSurface(pybind11::module_& module);

}  // namespace sinew::python
