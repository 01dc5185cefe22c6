// core/include/sinew/runtime/vertex_buffer.h: writes surfaces to a game's vertex and index buffers. docs/games.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/surface/surface.h"

namespace sinew {

enum class BufferVertices {
  kDrawn,    ///< One for each texture coordinate, color and creased normal, for drawing.
  kRefined,  ///< One for each point of the surface: fewer, without texture coordinates, for shadows and collisions.
};

enum class PositionFormat {
  kFloat,  ///< 3 floats, 12 bytes.
  kHalf,   ///< 4 halves, the last 1, 8 bytes: about 1/2000 of the distance from `origin`.
};
enum class NormalFormat {
  kFloat,    ///< 3 floats, 12 bytes.
  kSnorm10,  ///< x, y, z from the lowest bit in 10 bits each, signed and normalized, then 2 bits of 0: 4 bytes.
};

/// Members of a vertex in the caller's buffer. Bytes between them are not written.
struct VertexLayout {
  std::size_t stride = 24;      ///< Bytes from one vertex to the next.
  std::ptrdiff_t position = 0;  ///< Byte in the vertex; -1: none.
  std::ptrdiff_t normal = 12;   ///< Byte in the vertex; -1: none.
  PositionFormat positions = PositionFormat::kFloat;
  NormalFormat normals = NormalFormat::kFloat;
  BufferVertices vertices = BufferVertices::kDrawn;
  glm::vec3 origin{0.0f};  ///< World; subtracted from positions.
};

[[nodiscard]] std::size_t vertexCount(const Refinement& refinement, BufferVertices vertices);
[[nodiscard]] std::size_t indexCount(const Refinement& refinement);  ///< Three for each triangle.

/// Writes positions and normals, each frame. With origin 0, floats are those of Surface::positions and shadingNormal(),
/// to the bit. Allocates nothing.
/// Error: members do not fit the stride, or the buffer is too short; then nothing is written.
[[nodiscard]] Result<void> writeVertices(const Surface& surface, const VertexLayout& layout, std::span<std::byte> out);

/// Writes uvs of drawn vertices, once per preparation: 2 floats, as in glTF (v down). @param offset  byte in the vertex
[[nodiscard]] Result<void> writeUvs(const Refinement& refinement, std::size_t stride, std::size_t offset,
                                    std::span<std::byte> out);

/// Writes triangles by material, counter-clockwise from outside, once per preparation.
/// Error: the buffer is too short, or the vertices are too many for 16 bits.
[[nodiscard]] Result<void> writeIndices(const Refinement& refinement, const ControlMesh& mesh, BufferVertices vertices,
                                        std::span<std::uint32_t> out);
[[nodiscard]] Result<void> writeIndices(const Refinement& refinement, const ControlMesh& mesh, BufferVertices vertices,
                                        std::span<std::uint16_t> out);

/// Indices [first, first + count) of a material.
struct IndexRange {
  int material = 0;  ///< Index into Character::materials.
  std::size_t first = 0;
  std::size_t count = 0;
};
/// In the order of writeIndices(): materials ascending, without those that have no triangles.
[[nodiscard]] std::vector<IndexRange> indexRanges(const Refinement& refinement, const ControlMesh& mesh);

}  // namespace sinew
