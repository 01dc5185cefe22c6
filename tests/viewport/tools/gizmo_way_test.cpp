// tests/viewport/tools/gizmo_way_test.cpp: constraints of handles, and the handles they belong to.

#include "app/viewport/tools/gizmo.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace sinew::app {
namespace {

TEST(GizmoConstraint, IsAnAxisAPlaneOrNone) {
  for (const Way way : kAllWays) {
    EXPECT_EQ(int{isAxis(way)} + int{isPlane(way)} + int{way == Way::kWhole}, 1) << nameOf(way);
  }
  EXPECT_FALSE(isAxis(Way::kNone));
  EXPECT_FALSE(isPlane(Way::kNone));
}

TEST(GizmoConstraint, PlaneIsNamedAfterItsAxesWithTheThirdAsNormal) {
  for (const Way plane : kPlaneWays) {
    std::string name;
    for (const int axis : planeAxes(plane)) name += nameOf(kAxisWays[static_cast<std::size_t>(axis)]);
    EXPECT_EQ(name, nameOf(plane));
    const std::set<int> axes{planeAxes(plane)[0], planeAxes(plane)[1], normalAxisOf(plane)};
    EXPECT_EQ(axes, (std::set<int>{0, 1, 2})) << nameOf(plane);
  }
}

TEST(GizmoConstraint, EachHasItsOwnTrack) {
  for (std::size_t i = 0; i < kAllWays.size(); ++i) EXPECT_EQ(trackOf(kAllWays[i]), i);
}

TEST(GizmoConstraint, HandleIsFoundByItsParts) {
  for (int i = 0; i < kGizmoHandleCount; ++i) {
    const auto handle = static_cast<GizmoHandle>(i);
    EXPECT_EQ(handleOf(partsOf(handle)), handle) << nameOf(handle);
  }
  EXPECT_EQ(handleOf({HandleKind::kScale, Way::kXY}), GizmoHandle::kNone);
  EXPECT_EQ(handleOf({HandleKind::kMove, Way::kZX}), GizmoHandle::kMoveZX);
  EXPECT_EQ(handleOf({HandleKind::kPole, Way::kY, -1.0f}), GizmoHandle::kPoleMinusY);
}

TEST(GizmoConstraint, LockOverridesTheHandle) {
  GizmoDrag drag;
  drag.handle = GizmoHandle::kMoveYZ;
  EXPECT_EQ(wayOf(drag), Way::kYZ);
  drag.lock = Way::kX;
  EXPECT_EQ(wayOf(drag), Way::kX);
}

}  // namespace
}  // namespace sinew::app
