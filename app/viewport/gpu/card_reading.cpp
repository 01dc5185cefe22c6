// app/viewport/gpu/card_reading.cpp: what tests and measurements read back from the card.
#include "app/viewport/gpu/card_surface.h"

namespace sinew::app {

template <class T>
std::vector<T> CardSurface::read(Buffer buffer, std::size_t count) const {
  std::vector<T> values(count);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(of(buffer).id(), 0, static_cast<GLsizeiptr>(count * sizeof(T)), values.data());
  return values;
}

std::vector<card::Root> CardSurface::readRoots() const {
  return read<card::Root>(Buffer::kRoots, static_cast<std::size_t>(options_.bodies * making_.refinedVertices));
}

std::vector<card::Vertex> CardSurface::readPatches() const {
  return read<card::Vertex>(Buffer::kPatches, static_cast<std::size_t>(options_.bodies * making_.refinedVertices));
}

std::vector<card::Vertex> CardSurface::readSurface() const {
  return read<card::Vertex>(Buffer::kSurface, static_cast<std::size_t>(options_.bodies * making_.refinedVertices));
}

std::uint32_t CardSurface::readUnsure() const { return read<card::ListHead>(Buffer::kUnsure, 1).front().count; }

bool CardSurface::readSlopesRest() const {
  return read<card::Round>(Buffer::kRoundsAsked, kRounds)[kFirstSlope + kSlopeRounds].vertexGroups[0] == 0;
}

}  // namespace sinew::app
