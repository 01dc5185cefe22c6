// app/viewport/render/occlusion.h: how much of the surroundings each place of the body sees, as values over a refined
// mesh.
#pragma once

#include <span>
#include <vector>

#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew::app {

/// How open each control vertex is in the bind pose: 1 sees everything around it, towards 0 it sits in a crevice
/// between other parts of the body. Cosine-weighted; what is further off than a third of the body's size does not
/// count. Coarse on purpose (the body as voxels of 1/56 of its size): it shades arm pits, not pores. Work is bounded,
/// about 20 ms for 10,000 vertices. @return [V] 0..1; same mesh, same values.
[[nodiscard]] std::vector<float> bakeOpenness(const ControlMesh& mesh);

/// Values at control vertices, barycentrically at all refined ones.
/// @param values [V]  @return [V'] of the refinement, which must come from this mesh.
[[nodiscard]] std::vector<float> spreadOverRefinement(std::span<const float> values, const ControlMesh& mesh,
                                                      const Refinement& refinement);

}  // namespace sinew::app
