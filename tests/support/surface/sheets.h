// tests/support/surface/sheets.h: small control meshes without bones, for stages that are tested on their own.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sinew/geometry/control_mesh.h"

namespace sinew::test {

/// Welded, with normals; all vertices on one binding. @param triangles counter-clockwise seen from outside.
[[nodiscard]] ControlMesh meshOf(const std::vector<glm::vec3>& positions,
                                 const std::vector<std::array<int, 3>>& triangles);

/// Grid over x and y in -1..1, cells of one size, facing +z. Mirror-symmetric about x = 0, its diagonals too.
/// @param cells  along each side; even.  @param height  z at (x, y).
struct Sheet {
  std::vector<glm::vec3> positions;
  std::vector<std::array<int, 3>> triangles;
};
[[nodiscard]] Sheet sheetOf(int cells, const std::function<float(float, float)>& height);

/// Unit sphere by columns and rings, poles at the ends of y.
[[nodiscard]] ControlMesh sphere(int columns, int rings);

}  // namespace sinew::test
