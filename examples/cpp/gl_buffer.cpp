// examples/cpp/gl_buffer.cpp: a clip in a vertex buffer as OpenGL, Vulkan and others take it. gl_buffer FILE.sinew
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "sinew/runtime/runtime.h"

namespace {

/// 24 bytes: glVertexAttribFormat(0, 3, GL_FLOAT, false, 0), (1, 4, GL_INT_2_10_10_10_REV, true, 12), (2, 2, GL_FLOAT,
/// false, 16).
struct Vertex {
  float position[3];
  std::uint32_t normal;
  float uv[2];
};

int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

/// Once: the triangles by material, in 16 bits where they do. A draw call for each material.
template <class Index>
sinew::Result<void> upload(const sinew::Refinement& refinement, const sinew::Character& character) {
  std::vector<Index> indices(sinew::indexCount(refinement));
  const auto written = sinew::writeIndices(refinement, character.mesh, sinew::BufferVertices::kDrawn, indices);
  if (!written) return written;
  for (const sinew::IndexRange& range : sinew::indexRanges(refinement, character.mesh)) {
    const char* material = character.materials[static_cast<std::size_t>(range.material)].name.c_str();
    std::printf("material \"%s\": %zu indices of %zu bytes\n", material, range.count, sizeof(Index));
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: gl_buffer FILE.sinew\n");
    return 2;
  }
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> file{std::istreambuf_iterator<char>(in), {}};
  const auto game = sinew::readGameFile(std::as_bytes(std::span(file)));
  if (!game) return fail(game.error());
  const sinew::Character& character = *game->character;
  if (character.clips.empty()) return fail(sinew::errorAt(argv[1], "the character has no clip"));
  sinew::Smoother smoother(game->character);
  if (const auto prepared = smoother.prepare(game->rig); !prepared) return fail(prepared.error());

  sinew::Surface surface;
  smoother.smooth(sinew::bindPose(character.skeleton), surface);
  const sinew::Refinement& refinement = *surface.refinement;
  std::vector<Vertex> buffer(sinew::vertexCount(refinement, sinew::BufferVertices::kDrawn));  // Or what is mapped.
  const auto bytes = std::as_writable_bytes(std::span(buffer));
  const auto made = buffer.size() < 65536 ? upload<std::uint16_t>(refinement, character)
                                          : upload<std::uint32_t>(refinement, character);
  if (!made) return fail(made.error());
  if (const auto uvs = sinew::writeUvs(refinement, sizeof(Vertex), offsetof(Vertex, uv), bytes); !uvs) {
    return fail(uvs.error());
  }
  const sinew::VertexLayout layout{
      .stride = sizeof(Vertex), .normal = offsetof(Vertex, normal), .normals = sinew::NormalFormat::kSnorm10};
  for (float seconds = 0.0f; seconds < character.clips[0].duration; seconds += 1.0f / 30.0f) {
    smoother.smooth(sinew::samplePose(character, character.clips[0], seconds), surface);
    if (const auto frame = sinew::writeVertices(surface, layout, bytes); !frame) return fail(frame.error());
  }
  std::printf("%zu vertices of %zu bytes\n", buffer.size(), sizeof(Vertex));
  return 0;
}
