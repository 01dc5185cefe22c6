// app/command/error_map.cpp: little endian .ply with a number of its own for each vertex.
#include "app/command/error_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "app/viewport/render/color_scales.h"
#include "core/files/disk/atomic_file.h"

namespace sinew::app {
namespace {

void put(std::string& out, std::uint32_t bits) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>((bits >> shift) & 0xffU);
}
void put(std::string& out, float value) { put(out, std::bit_cast<std::uint32_t>(value)); }

char byteOf(float share) { return static_cast<char>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f))); }

}  // namespace

Result<void> writeErrorMap(const ExportedSurface& exported, const std::filesystem::path& file) {
  const float largest =
      exported.largest.empty() ? 0.0f : *std::max_element(exported.largest.begin(), exported.largest.end());
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment error: percent of the height\nelement vertex " +
                    std::to_string(exported.rest.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
                    "property uchar blue\nproperty float error\nelement face " +
                    std::to_string(exported.triangles.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < exported.rest.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) put(out, exported.rest[v][axis]);
    const float error = exported.largest[v];
    const glm::vec3 color = heatColor(largest > 0.0f ? error / largest : 0.0f);
    for (int channel = 0; channel < 3; ++channel) out += byteOf(color[channel]);
    put(out, error);
  }
  for (const auto& triangle : exported.triangles) {
    out += '\3';
    for (const int corner : triangle) put(out, static_cast<std::uint32_t>(corner));
  }
  return writeFileAtomically(file, out);
}

}  // namespace sinew::app
