// core/runtime/vertex_buffer.cpp: writes members of vertices at strides, and indices by material.
#include "sinew/runtime/vertex_buffer.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include <glm/gtc/packing.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew {
namespace {

constexpr std::size_t kLeastVertices = 16384;  ///< For one thread.

Result<void> checkMember(const char* name, std::ptrdiff_t offset, std::size_t size, std::size_t stride) {
  if (offset >= 0 && static_cast<std::size_t>(offset) <= stride && size <= stride - static_cast<std::size_t>(offset)) {
    return {};
  }
  return errorAt(name, "byte " + std::to_string(offset) + " and " + std::to_string(size) +
                           " bytes from there do not fit vertices of " + std::to_string(stride) + " bytes");
}

/// The buffer must hold the last vertex's whole stride, wherever its members lie.
Result<void> checkBuffer(std::size_t vertices, std::size_t stride, std::size_t bytes) {
  if (stride > 0 && bytes / stride >= vertices) return {};
  return errorAt("buffer", "expected " + std::to_string(vertices) + " vertices of " + std::to_string(stride) +
                               " bytes, got " + std::to_string(bytes) + " bytes");
}

template <class ValueAt>
void writeMember(std::size_t count, std::size_t stride, std::size_t offset, std::span<std::byte> out, ValueAt valueAt) {
  forRanges(count, kLeastVertices, [&](std::size_t begin, std::size_t end) {
    std::byte* to = out.data() + begin * stride + offset;
    for (std::size_t i = begin; i < end; ++i, to += stride) {
      const auto value = valueAt(i);
      std::memcpy(to, &value, sizeof value);
    }
  });
}

/// Calls visit(triangle, material, place) with the place of each refined triangle by material and mesh order.
template <class Visit>
void byMaterial(const Refinement& refinement, const ControlMesh& mesh, Visit visit) {
  int last = 0;
  for (const ControlTriangle& triangle : mesh.triangles) last = std::max(last, triangle.material);
  std::vector<std::size_t> next(toIndex(last) + 2, 0);
  for (const int control : refinement.controlOf) ++next[toIndex(at(mesh.triangles, control).material) + 1];
  for (std::size_t m = 1; m < next.size(); ++m) next[m] += next[m - 1];
  for (std::size_t t = 0; t < refinement.controlOf.size(); ++t) {
    const int material = at(mesh.triangles, refinement.controlOf[t]).material;
    visit(t, material, next[toIndex(material)]++);
  }
}

template <class Index>
Result<void> writeIndicesAs(const Refinement& refinement, const ControlMesh& mesh, BufferVertices vertices,
                            std::span<Index> out) {
  if (out.size() < indexCount(refinement)) {
    return errorAt(
        "buffer", "expected " + std::to_string(indexCount(refinement)) + " indices, got " + std::to_string(out.size()));
  }
  // In some graphics APIs the largest index restarts strips.
  if (vertexCount(refinement, vertices) > std::size_t{std::numeric_limits<Index>::max()}) {
    return errorAt("indices",
                   std::to_string(vertexCount(refinement, vertices)) + " vertices are too many for indices of 16 bits");
  }
  byMaterial(refinement, mesh, [&](std::size_t triangle, int /*material*/, std::size_t place) {
    for (std::size_t i = 0; i < 3; ++i) {
      out[3 * place + i] = vertices == BufferVertices::kDrawn
                               ? static_cast<Index>(refinement.drawTriangles[triangle][i])
                               : static_cast<Index>(refinement.triangles[triangle][i]);
    }
  });
  return {};
}

}  // namespace

std::size_t vertexCount(const Refinement& refinement, BufferVertices vertices) {
  return vertices == BufferVertices::kDrawn ? refinement.drawVertex.size() : toIndex(refinement.vertexCount);
}

std::size_t indexCount(const Refinement& refinement) { return 3 * refinement.triangles.size(); }

Result<void> writeVertices(const Surface& surface, const VertexLayout& layout, std::span<std::byte> out) {
  if (!surface.refinement) return errorAt("surface", "it is empty: smooth a pose first");
  const bool drawn = layout.vertices == BufferVertices::kDrawn;
  const std::size_t count = vertexCount(*surface.refinement, layout.vertices);
  const std::size_t positionBytes = layout.positions == PositionFormat::kFloat ? 12 : 8;
  const std::size_t normalBytes = layout.normals == NormalFormat::kFloat ? 12 : 4;
  if (Result<void> fits = checkBuffer(count, layout.stride, out.size()); !fits) return fits;
  for (const auto& [name, offset, size] :
       {std::tuple{"position", layout.position, positionBytes}, std::tuple{"normal", layout.normal, normalBytes}}) {
    if (offset == -1) continue;
    if (Result<void> fits = checkMember(name, offset, size, layout.stride); !fits) return fits;
  }
  const auto positionAt = [&](std::size_t i) {
    const glm::vec3& p = surface.positions[drawn ? toIndex(surface.refinement->drawVertex[i]) : i];
    return layout.origin == glm::vec3(0.0f) ? p : p - layout.origin;
  };
  const auto normalAt = [&](std::size_t i) { return drawn ? shadingNormal(surface, i) : surface.normals[i]; };
  const auto write = [&](std::ptrdiff_t offset, auto valueAt) {
    if (offset >= 0) writeMember(count, layout.stride, static_cast<std::size_t>(offset), out, valueAt);
  };
  if (layout.positions == PositionFormat::kFloat) write(layout.position, positionAt);
  else write(layout.position, [&](std::size_t i) { return glm::packHalf4x16(glm::vec4(positionAt(i), 1.0f)); });
  if (layout.normals == NormalFormat::kFloat) write(layout.normal, normalAt);
  else write(layout.normal, [&](std::size_t i) { return glm::packSnorm3x10_1x2(glm::vec4(normalAt(i), 0.0f)); });
  return {};
}

Result<void> writeUvs(const Refinement& refinement, std::size_t stride, std::size_t offset, std::span<std::byte> out) {
  if (Result<void> fits = checkBuffer(refinement.drawVertex.size(), stride, out.size()); !fits) return fits;
  if (Result<void> fits = checkMember("uv", static_cast<std::ptrdiff_t>(offset), sizeof(glm::vec2), stride); !fits) {
    return fits;
  }
  writeMember(refinement.drawVertex.size(), stride, offset, out, [&](std::size_t i) { return refinement.drawUv[i]; });
  return {};
}

Result<void> writeIndices(const Refinement& refinement, const ControlMesh& mesh, BufferVertices vertices,
                          std::span<std::uint32_t> out) {
  return writeIndicesAs(refinement, mesh, vertices, out);
}

Result<void> writeIndices(const Refinement& refinement, const ControlMesh& mesh, BufferVertices vertices,
                          std::span<std::uint16_t> out) {
  return writeIndicesAs(refinement, mesh, vertices, out);
}

std::vector<IndexRange> indexRanges(const Refinement& refinement, const ControlMesh& mesh) {
  std::vector<IndexRange> ranges;
  byMaterial(refinement, mesh, [&](std::size_t /*triangle*/, int material, std::size_t place) {
    auto found = std::ranges::find(ranges, material, &IndexRange::material);
    if (found == ranges.end()) found = ranges.insert(ranges.end(), {material, 3 * place, 0});
    found->count += 3;
  });
  std::ranges::sort(ranges, {}, &IndexRange::material);
  return ranges;
}

}  // namespace sinew
