// tests/bodies/sheets/sheet_fixture.h: the bundled humanoid with a chest sheet on it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/bodies/body_map.h"
#include "core/geometry/at.h"
#include "core/rig/line_rest.h"
#include "core/rig/mirror.h"
#include "core/rig/sheet_edit.h"
#include "sinew/files/gltf_import.h"
#include "sinew/rig/rig.h"

namespace sinew::test {

struct SheetBody {
  std::shared_ptr<const Character> character;
  MirrorPlan plan;

  [[nodiscard]] const Skeleton& skeleton() const { return character->skeleton; }
  [[nodiscard]] glm::vec3 inBind(const std::string& bone, const glm::vec3& point) const {
    return glm::vec3(at(skeleton().bones, *skeleton().findBone(bone)).bindInWorld * glm::vec4(point, 1.0f));
  }
};

inline SheetBody humanoidBody() {
  auto imported = importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb");
  EXPECT_TRUE(imported.ok());
  SheetBody body{imported.value(), {}};
  body.plan = makeMirrorPlan(*body.character);
  return body;
}

/// On the left side of the chest, from the breastbone to the upper arm.
inline MuscleSheet chestSheet(const SheetBody& body) {
  const MeasuredBody measured(*body.character, body.plan, {});
  const auto edge = [&](std::initializer_list<Mark> marks) {
    SheetEdge made;
    for (const Mark& mark : marks) {
      const auto flesh = measured.flesh.measure(mark, false);
      if (flesh) made.points.push_back(anchorOn(body.skeleton(), measured.frame.boneOf(mark), flesh->at(0.0f)));
    }
    return made;
  };
  MuscleSheet sheet;
  sheet.name = "pectoral L";
  sheet.group = "chest L";
  sheet.edges = {edge({{Slot::kSpine, 0.88f, 8.0f}, {Slot::kSpine, 0.66f, 8.0f}}),
                 edge({{Slot::kSpine, 0.82f, 34.0f}, {Slot::kSpine, 0.66f, 36.0f}}),
                 edge({{Slot::kUpperArm, 0.2f, 45.0f}, {Slot::kUpperArm, 0.2f, 15.0f}})};
  sheet.strips = 4;
  sheet.bellies = 3;
  return sheet;
}

}  // namespace sinew::test
