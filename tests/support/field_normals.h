#pragma once  // tests/support/field_normals.h: what `swell` gives before guard and shading: the field's exact normals.

#include <memory>

#include "core/character/character.h"
#include "core/rig/rig.h"
#include "core/skeleton/pose.h"
#include "core/smoothing/surface.h"

namespace sinew::test {

/// The stages of core/smoothing up to swell(), put together by hand.
class FieldNormals {
 public:
  FieldNormals(const Character& character, const Rig& rig);
  ~FieldNormals();
  FieldNormals(const FieldNormals&) = delete;
  FieldNormals& operator=(const FieldNormals&) = delete;
  /// Positions, displacement and normals; the patch's where nothing has moved. Valid until the next call.
  [[nodiscard]] const Surface& at(const Pose& pose);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::test
