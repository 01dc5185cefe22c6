// app/viewport/render/surface_programs.cpp: each kind from the same files.
#include "app/viewport/render/surface_programs.h"

#include <array>

namespace sinew::app {
namespace {

constexpr std::array<const char*, 4> kShadingDefines{"SHADING_TEXTURED", "SHADING_CLAY", "SHADING_CLASSES",
                                                     "SHADING_HEAT"};

Result<GlProgram> loadSurface(const SurfaceKind& kind) {
  const char* const shading = kShadingDefines[static_cast<std::size_t>(kind.shading)];
  const char* const marks = kind.marked ? "MARKED" : "UNMARKED";
  const char* const colors = kind.colored ? "COLORED" : "UNCOLORED";
  const char* const look = kind.chosen ? "CHOSEN_LOOK" : "USUAL_LOOK";
  const char* const normals = (kind.maps & kNormalBit) != 0 ? "NORMAL_MAP" : "NO_NORMAL_MAP";
  const char* const roughness = (kind.maps & kRoughnessBit) != 0 ? "ROUGHNESS_MAP" : "NO_ROUGHNESS_MAP";
  const char* const occlusion = (kind.maps & kOcclusionBit) != 0 ? "OCCLUSION_MAP" : "NO_OCCLUSION_MAP";
  const char* const emissive = (kind.maps & kEmissiveBit) != 0 ? "EMISSIVE_MAP" : "NO_EMISSIVE_MAP";
  const char* const shared = (kind.maps & kSharedBit) != 0 ? "SHARED_MAP" : "NO_SHARED_MAP";
  if (!kind.wired) {
    return GlProgram::load({"shaders/surface.vert", "shaders/surface.frag"},
                           {shading, marks, colors, look, normals, roughness, occlusion, emissive, shared});
  }
  return GlProgram::load({"shaders/surface.vert", "shaders/surface_wire.geom", "shaders/surface.frag"},
                         {shading, "WIRE", marks, colors, look, normals, roughness, occlusion, emissive, shared});
}

}  // namespace

Result<SurfacePrograms> SurfacePrograms::create() {
  SurfacePrograms programs;
  for (const Shading shading : {Shading::kTextured, Shading::kClay, Shading::kClasses, Shading::kHeat}) {
    for (unsigned bits = 0; bits < 8; ++bits) {
      const SurfaceKind kind{
          .shading = shading, .wired = (bits & 1) != 0, .marked = (bits & 2) != 0, .colored = (bits & 4) != 0};
      if (kind.colored && shading != Shading::kTextured) continue;
      Result<GlProgram> made = loadSurface(kind);
      if (!made) return made.error();
      programs.made_[kind] = std::move(made).value();
    }
  }
  return programs;
}

const GlProgram& SurfacePrograms::of(const SurfaceKind& kind) const {
  const auto [found, isNew] = made_.try_emplace(kind);
  if (isNew) {
    // The files were good a moment ago; without them the usual picture is better than none.
    if (Result<GlProgram> made = loadSurface(kind)) found->second = std::move(made).value();
  }
  if (found->second.id() != 0) return found->second;
  SurfaceKind usual = kind;
  if (usual.maps != 0) usual.maps = 0;
  else usual.chosen = false;
  return of(usual);
}

}  // namespace sinew::app
