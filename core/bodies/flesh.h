// core/bodies/flesh.h: how thick a character's flesh is round the axes of its parts, in the bind pose.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/bodies/body_frame.h"
#include "sinew/character/character.h"

namespace sinew {

/// Where a ray leaves the skin of a part.
struct SkinExit {
  float distance = 0.0f;   ///< Along the ray.
  glm::vec3 normal{0.0f};  ///< Of the triangle, unit, outwards.
  int triangle = -1;
  glm::vec3 barycentric{0.0f};
};

/// A place on the skin as a mark finds it. World.
struct FleshPoint {
  glm::vec3 axis{0.0f};    ///< The point of the axis.
  glm::vec3 radial{0.0f};  ///< Unit, from there to the skin.
  float thickness = 0.0f;  ///< From axis to skin, the local flesh t.
  float size = 0.0f;       ///< The same within 0.6 to 1.5 of the part's median: what sizes are measured by.
  glm::vec3 normal{0.0f};  ///< Of the skin round about, unit.
  float edge = 0.0f;       ///< Mean length of the mesh's edges there.

  [[nodiscard]] glm::vec3 at(float depth) const { return axis + (1.0f - depth) * thickness * radial; }
};

/// The skin of a character, to measure a frame's parts in.
class Flesh {
 public:
  /// Moves the frame's trunk half way between front and back.
  Flesh(const Character& character, BodyFrame& frame);

  /// nullopt: the part is missing or has no skin there.
  /// @param onSkin  false: for a place inside, where the part's median does as well
  [[nodiscard]] std::optional<FleshPoint> measure(const Mark& mark, bool onSkin = true) const;
  /// The last exit of a ray from the skin of these zones: cloth is over skin.
  /// @param usual  what comes out farther away than this belongs to another limb, unless it is the first exit
  [[nodiscard]] std::optional<SkinExit> leave(const glm::vec3& from, const glm::vec3& direction,
                                              const std::vector<Zone>& zones,
                                              float usual = std::numeric_limits<float>::max()) const;
  /// The skin goes round the point: between the parts of a body that is made of parts it does not.
  [[nodiscard]] bool isInside(const glm::vec3& point) const;

 private:
  [[nodiscard]] std::optional<float> thicknessAt(const PartAxis& axis, float u, float angle,
                                                 const std::vector<Zone>& zones, float usual) const;
  /// Of the neighbours' skin: nothing beyond what is usual.
  [[nodiscard]] std::optional<SkinExit> usualExit(const FleshPoint& place, const std::vector<Zone>& zones,
                                                  float usual) const;
  void centerTrunk(PartAxis& trunk) const;
  void measureMedians();

  /// A triangle with its corners beside each other in memory: rays and solid angles look at very many.
  struct Piece {
    std::array<glm::vec3, 3> corners;
    int triangle = -1;
  };

  const Character& character_;
  BodyFrame& frame_;
  std::vector<Piece> skin_;
  std::vector<std::vector<Piece>> skinOfZone_;  ///< [zones]
  std::array<float, kSlotCount> medians_{};     ///< By Slot; 0: not known.
};

}  // namespace sinew
