// app/command/scene.h: a character with muscles in one surface mode: what `sinew bench` measures.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/smoother.h"

namespace sinew::app {

struct BenchScene {
  std::string name;
  std::shared_ptr<const Character> character;
  Rig rig;
};

/// A rig, or a character, which gets 12 muscles by rule if it has none. "fox" of both fox.glb and fox.rig.json.
/// Error: as openDocument.
[[nodiscard]] Result<BenchScene> openScene(const std::filesystem::path& file);

/// The depth at which single figures are taken: the paper's highest in its second table.
inline constexpr int kBenchDepth = 5;

/// The scene's rig at a depth.
[[nodiscard]] Rig rigAt(const BenchScene& scene, int depth);

/// A smoother that has the rig. Error: the rig is refused.
[[nodiscard]] Result<Smoother> preparedSmoother(const BenchScene& scene, const Rig& rig,
                                                ProjectionKind projection = ProjectionKind::kNewton);

}  // namespace sinew::app
