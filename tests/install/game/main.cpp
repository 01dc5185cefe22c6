// tests/install/game/main.cpp: a game on Sinew::runtime: its own vertices, no allocation in a frame. game FILE.sinew
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include "sinew/runtime/runtime.h"

static thread_local long allocations = 0;
void* operator new(std::size_t size) {
  ++allocations;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

struct Vertex {  // As it lies in the vertex buffer.
  float position[3], normal[3], uv[2];
};

static int fail(const sinew::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

int main(int, char** argv) {
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> file{std::istreambuf_iterator<char>(in), {}};
  const auto game = sinew::readGameFile(std::as_bytes(std::span(file)));
  if (!game) return fail(game.error());
  const sinew::Character& character = *game->character;
  sinew::Smoother smoother(game->character);
  if (const auto prepared = smoother.prepare(game->rig); !prepared) return fail(prepared.error());

  std::vector<sinew::Pose> poses;
  for (int frame = 0; frame < 8; ++frame) poses.push_back(samplePose(character, character.clips[0], 0.1f * frame));
  sinew::Surface surface;
  for (const sinew::Pose& pose : poses) smoother.smooth(pose, surface);
  std::vector<Vertex> buffer(vertexCount(*surface.refinement, sinew::BufferVertices::kDrawn));
  const auto bytes = std::as_writable_bytes(std::span(buffer));
  if (!writeUvs(*surface.refinement, sizeof(Vertex), offsetof(Vertex, uv), bytes)) return 1;
  const sinew::VertexLayout layout{.stride = sizeof(Vertex), .normal = offsetof(Vertex, normal)};
  const long before = allocations;
  for (const sinew::Pose& pose : poses) {
    if (!smoother.smooth(pose, surface) || !writeVertices(surface, layout, bytes)) return 1;
  }
  const long inFrames = allocations - before;
  bool same = true;
  forEachDrawVertex(*surface.refinement, [&](std::size_t i, std::size_t v) {
    const glm::vec3 normal = shadingNormal(surface, i);
    same = same && std::memcmp(buffer[i].position, &surface.positions[v], 12) == 0 &&
           std::memcmp(buffer[i].normal, &normal, 12) == 0;
  });
  poses[0].boneInWorld.pop_back();
  const bool refused = !smoother.smooth(poses[0], surface) && !checkPose(character, poses[0]);
  std::printf("%zu vertices, %ld allocations, %s, %s\n", buffer.size(), inFrames, same ? "the same bits" : "other bits",
              refused ? checkPose(character, poses[0]).error().text().c_str() : "a wrong pose is taken");
  return same && refused && inFrames == 0 ? 0 : 1;
}
