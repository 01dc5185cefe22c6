// app/viewport/render/surface_programs.h: shaders/surface.frag in its many kinds.
#pragma once

#include <map>

#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/material_textures.h"

namespace sinew::app {

struct SurfaceKind {
  Shading shading = Shading::kTextured;
  bool wired = false;
  bool marked = false;
  bool colored = false;  ///< By the vertices: kTextured alone.
  bool chosen = false;   ///< A light that was chosen, or with occlusion.
  MapSet maps = 0;

  friend auto operator<=>(const SurfaceKind&, const SurfaceKind&) = default;
};

class SurfacePrograms {
 public:
  /// Makes those that are used most; the others are made when first used.
  [[nodiscard]] static Result<SurfacePrograms> create();

  /// Of a kind that cannot be made: without maps, and in the usual light.
  [[nodiscard]] const GlProgram& of(const SurfaceKind& kind) const;

 private:
  mutable std::map<SurfaceKind, GlProgram> made_;  ///< Those that cannot be made own nothing.
};

}  // namespace sinew::app
