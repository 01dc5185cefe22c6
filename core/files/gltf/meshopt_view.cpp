// core/files/gltf/meshopt_view.cpp: meshoptimizer's decoders behind the rules of EXT_meshopt_compression.

#include "core/files/gltf/meshopt_view.h"

#include <meshoptimizer.h>

namespace sinew::gltf {
namespace {

/// Bytes of vertices shrink at most this much: two bits for sixteen of them.
constexpr std::uint64_t kMostRatio = 64;
constexpr std::uint64_t kMostStride = 256;

/// The library asserts what it is told; this is all of that, and what EXT_meshopt_compression asks besides.
const char* faultOf(const MeshoptView& view) {
  if (view.count == 0) return "has no elements";
  if (view.mode != MeshoptMode::kAttributes) {
    if (view.stride != 2 && view.stride != 4) return "is of indices; 2 or 4 bytes are expected for each";
    if (view.filter != MeshoptFilter::kNone) return "is of indices, which have no filter";
    const bool whole = view.mode == MeshoptMode::kIndices || view.count % 3 == 0;
    return whole ? nullptr : "is of triangles; a multiple of 3 indices is expected";
  }
  if (view.stride == 0 || view.stride > kMostStride || view.stride % 4 != 0) {
    return "has a byteStride that is no multiple of 4 up to 256";
  }
  if (view.filter == MeshoptFilter::kOctahedral && view.stride != 4 && view.stride != 8) {
    return "has the filter OCTAHEDRAL, for 4 or 8 bytes";
  }
  return view.filter == MeshoptFilter::kQuaternion && view.stride != 8 ? "has the filter QUATERNION, for 8 bytes"
                                                                       : nullptr;
}

/// Whether so few bytes can hold so many elements.
bool holdsElements(std::uint64_t bytes, const MeshoptView& view) {
  if (view.mode == MeshoptMode::kAttributes) return view.count * view.stride / kMostRatio <= bytes;
  return (view.mode == MeshoptMode::kTriangles ? view.count / 3 : view.count) <= bytes;
}

bool decodeInto(std::vector<std::uint8_t>& to, std::span<const std::uint8_t> bytes, const MeshoptView& view) {
  switch (view.mode) {
    case MeshoptMode::kAttributes:
      return meshopt_decodeVertexBuffer(to.data(), view.count, view.stride, bytes.data(), bytes.size()) == 0;
    case MeshoptMode::kTriangles:
      return meshopt_decodeIndexBuffer(to.data(), view.count, view.stride, bytes.data(), bytes.size()) == 0;
    case MeshoptMode::kIndices:
      return meshopt_decodeIndexSequence(to.data(), view.count, view.stride, bytes.data(), bytes.size()) == 0;
  }
  return false;
}

void undoFilter(std::vector<std::uint8_t>& values, const MeshoptView& view) {
  switch (view.filter) {
    case MeshoptFilter::kNone:
      return;
    case MeshoptFilter::kOctahedral:
      return meshopt_decodeFilterOct(values.data(), view.count, view.stride);
    case MeshoptFilter::kQuaternion:
      return meshopt_decodeFilterQuat(values.data(), view.count, view.stride);
    case MeshoptFilter::kExponential:
      return meshopt_decodeFilterExp(values.data(), view.count, view.stride);
  }
}

}  // namespace

Result<std::vector<std::uint8_t>> decodeMeshopt(std::span<const std::uint8_t> bytes, const MeshoptView& view) {
  if (const char* const fault = faultOf(view)) return errorAt("", std::string("the compressed view ") + fault);
  if (!holdsElements(bytes.size(), view)) {
    return errorAt(
        "", std::to_string(bytes.size()) + " compressed bytes cannot hold " + std::to_string(view.count) + " elements");
  }
  std::vector<std::uint8_t> result(view.count * view.stride);
  if (!decodeInto(result, bytes, view)) return errorAt("", "the compressed view is damaged");
  undoFilter(result, view);
  return result;
}

}  // namespace sinew::gltf
