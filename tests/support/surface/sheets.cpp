// tests/support/surface/sheets.cpp: grids and spheres through the same welding as files.

#include "tests/support/surface/sheets.h"

#include <cmath>
#include <numbers>

#include "core/geometry/weld.h"

namespace sinew::test {

ControlMesh meshOf(const std::vector<glm::vec3>& positions, const std::vector<std::array<int, 3>>& triangles) {
  TriangleSoup soup;
  soup.positions = positions;
  soup.uvs.assign(positions.size(), glm::vec2(0.0f));
  soup.influenceBegin.push_back(0);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    soup.influences.push_back({0, 1.0f});
    soup.influenceBegin.push_back(static_cast<int>(soup.influences.size()));
  }
  for (const auto& [a, b, c] : triangles) {
    soup.triangles.push_back(
        {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  }
  soup.materials.assign(triangles.size(), 0);
  return weld(soup, 1e-6f);
}

Sheet sheetOf(int cells, const std::function<float(float, float)>& height) {
  Sheet out;
  const auto at = [&](int i) { return static_cast<float>(2 * i - cells) / static_cast<float>(cells); };
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      out.positions.push_back({at(column), at(row), height(at(column), at(row))});
    }
  }
  const auto index = [&](int column, int row) { return row * (cells + 1) + column; };
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const int a = index(column, row);
      const int b = index(column + 1, row);
      const int c = index(column + 1, row + 1);
      const int d = index(column, row + 1);
      if (2 * column < cells) {
        out.triangles.push_back({a, b, c});
        out.triangles.push_back({a, c, d});
      } else {
        out.triangles.push_back({a, b, d});
        out.triangles.push_back({b, c, d});
      }
    }
  }
  return out;
}

ControlMesh sphere(int columns, int rings) {
  std::vector<glm::vec3> positions{{0.0f, 1.0f, 0.0f}};
  for (int ring = 1; ring <= rings; ++ring) {
    const float polar = std::numbers::pi_v<float> * static_cast<float>(ring) / static_cast<float>(rings + 1);
    for (int column = 0; column < columns; ++column) {
      const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(column) / static_cast<float>(columns);
      positions.push_back({std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn)});
    }
  }
  positions.push_back({0.0f, -1.0f, 0.0f});
  const int last = static_cast<int>(positions.size()) - 1;
  const auto index = [&](int ring, int column) { return 1 + ring * columns + column % columns; };
  std::vector<std::array<int, 3>> triangles;
  for (int column = 0; column < columns; ++column) {
    triangles.push_back({0, index(0, column), index(0, column + 1)});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      triangles.push_back({index(ring, column), index(ring + 1, column), index(ring + 1, column + 1)});
      triangles.push_back({index(ring, column), index(ring + 1, column + 1), index(ring, column + 1)});
    }
    triangles.push_back({last, index(rings - 1, column + 1), index(rings - 1, column)});
  }
  return meshOf(positions, triangles);
}

}  // namespace sinew::test
