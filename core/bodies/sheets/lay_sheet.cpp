// core/bodies/sheets/lay_sheet.cpp: fibres over the skin, bellies along them, amounts that sum evenly.
#include "core/bodies/sheets/lay_sheet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/character/bone_segments.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/line_rest.h"

namespace sinew {
namespace {

constexpr int kFibrePoints = 41;
constexpr int kFibreRounds = 8;           ///< Of smoothing, after a fibre is drawn on the skin.
constexpr float kFibreNormal = 0.03f;     ///< Radius of the normals that a fibre follows, fraction of H.
constexpr float kBellyNormal = 0.025f;    ///< The same of a belly.
constexpr float kThinnest = 0.006f;       ///< Smallest half thickness of strips side by side, fraction of H.
constexpr float kMostOfBundle = 0.5f;     ///< Largest half thickness, of the width of all strips together.
constexpr float kWidestOverThick = 0.9f;  ///< Smallest half width over half thickness.
constexpr float kAnchorUnder = 0.012f;    ///< Depth of the ends of lines under the skin, fraction of H.
constexpr float kSheetTerritory = 0.04f;  ///< Smallest share of the skin's weights along the fibres.
constexpr float kTangent = 0.35f;         ///< The direction of a belly is taken over so much of its part of the strip.

/// A fibre in the middle of a strip. World.
struct Fibre {
  std::vector<glm::vec3> points;  ///< kFibrePoints, on the skin.
  std::vector<float> lengths;     ///< From the first point on.

  [[nodiscard]] float length() const { return lengths.back(); }
  /// @param share  of the length
  [[nodiscard]] glm::vec3 at(float share) const {
    const float wanted = std::clamp(share, 0.0f, 1.0f) * length();
    std::size_t i = 1;
    while (i + 1 < points.size() && lengths[i] < wanted) ++i;
    const float part = lengths[i] - lengths[i - 1];
    return glm::mix(points[i - 1], points[i], part > 0.0f ? (wanted - lengths[i - 1]) / part : 0.0f);
  }
};

std::vector<float> lengthsAlong(const std::vector<glm::vec3>& points) {
  std::vector<float> lengths{0.0f};
  for (std::size_t i = 1; i < points.size(); ++i) {
    lengths.push_back(lengths.back() + glm::distance(points[i - 1], points[i]));
  }
  return lengths;
}

/// A Catmull-Rom spline through points, at 0..1.
glm::vec3 splineAt(const std::vector<glm::vec3>& points, float place) {
  const auto parts = static_cast<float>(points.size() - 1);
  const float x = std::clamp(place, 0.0f, 1.0f) * parts;
  const std::size_t i = std::min(static_cast<std::size_t>(x), points.size() - 2);
  const float f = x - static_cast<float>(i);
  const glm::vec3& p1 = points[i];
  const glm::vec3& p2 = points[i + 1];
  const glm::vec3 p0 = i > 0 ? points[i - 1] : 2.0f * p1 - p2;
  const glm::vec3 p3 = i + 2 < points.size() ? points[i + 2] : 2.0f * p2 - p1;
  return 0.5f * (2.0f * p1 + (p2 - p0) * f + (2.0f * p0 - 5.0f * p1 + 4.0f * p2 - p3) * f * f +
                 (3.0f * p1 - p0 - 3.0f * p2 + p3) * f * f * f);
}

class SheetLayer {
 public:
  SheetLayer(const MuscleSheet& sheet, const SheetSkin& skin)
      : sheet_(sheet), skin_(skin), height_(skin.height()), skeleton_(skin.character().skeleton) {}

  Result<LaidSheet> lay() {
    if (auto edges = findEdges(); !edges) return edges.error();
    for (int strip = 0; strip < sheet_.strips; ++strip) fibres_.push_back(fibreOf(strip));
    for (const Fibre& fibre : fibres_) {
      if (!(fibre.length() > kShortestLine * height_)) return errorAt("", "its edges are at the same place");
    }
    findTerritory();
    for (int strip = 0; strip < sheet_.strips; ++strip) {
      if (sheet_.line) addLine(strip);
      for (int belly = 0; belly < sheet_.bellies; ++belly) {
        if (auto added = addBelly(strip, belly); !added) return added.error();
      }
    }
    setAmounts();
    return std::move(laid_);
  }

 private:
  Result<void> findEdges() {
    for (const SheetEdge& edge : sheet_.edges) {
      std::vector<glm::vec3>& points = edges_.emplace_back();
      for (const LineAnchor& anchor : edge.points) {
        const std::optional<BonePoint> found = findPoint(anchor, skeleton_);
        if (!found) return errorAt("", "this character has no bone \"" + anchor.bone + '"');
        points.emplace_back(found->inBind);
        allowed_.insert(found->bone);
      }
    }
    // Between the bones of the edges, its bellies may ride any.
    const std::set<int> named = allowed_;
    for (const int bone : named) {
      for (const int between : bonesBetween(skeleton_, *named.begin(), bone)) allowed_.insert(between);
    }
    return {};
  }

  /// Where strips cross an edge.
  [[nodiscard]] float shareOf(int strip) const {
    return (static_cast<float>(strip) + 0.5f) / static_cast<float>(sheet_.strips);
  }

  Fibre fibreOf(int strip) {
    std::vector<glm::vec3> through;
    for (const std::vector<glm::vec3>& edge : edges_) {
      through.push_back(spreadAlong(edge, sheet_.strips)[toIndex(strip)]);
    }
    const float radius = kFibreNormal * height_;
    Fibre fibre;
    for (int i = 0; i < kFibrePoints; ++i) {
      const glm::vec3 wanted = splineAt(through, static_cast<float>(i) / (kFibrePoints - 1));
      const glm::vec3 near = skin_.nearest(wanted);
      fibre.points.push_back(skin_.nearest(wanted, skin_.normalAround(near, radius)));
    }
    for (int round = 0; round < kFibreRounds; ++round) {
      std::vector<glm::vec3> smooth = fibre.points;
      for (std::size_t i = 1; i + 1 < smooth.size(); ++i) {
        smooth[i] = 0.25f * fibre.points[i - 1] + 0.5f * fibre.points[i] + 0.25f * fibre.points[i + 1];
      }
      fibre.points = std::move(smooth);
    }
    fibre.lengths = lengthsAlong(fibre.points);
    return fibre;
  }

  void findTerritory() {
    float sum = 0.0f;
    for (const Fibre& fibre : fibres_) {
      for (std::size_t i = 0; i < fibre.points.size(); i += 4) {
        for (const auto& [bone, weight] : skin_.weightsAt(fibre.points[i])) {
          weights_[bone] += weight;
          sum += weight;
        }
      }
    }
    for (const auto& [bone, weight] : weights_) {
      if (weight >= kSheetTerritory * sum && isNearAllowed(bone)) territory_.push_back(skeleton_.fileName(bone));
    }
  }

  /// One of the bones of the edges and between, or next to one: not another limb.
  [[nodiscard]] bool isNearAllowed(int bone) const {
    if (allowed_.contains(bone) || allowed_.contains(sinew::at(skeleton_.bones, bone).parent)) return true;
    return std::ranges::any_of(sinew::at(skeleton_.bones, bone).children,
                               [&](int child) { return allowed_.contains(child); });
  }

  /// The bone with the largest weight around a point, among those of the edges and between.
  [[nodiscard]] int boneAt(const glm::vec3& point, const glm::vec3& a, const glm::vec3& b) const {
    std::map<int, float> weights;
    for (const glm::vec3& near : {point, point + a, point - a, point + b, point - b}) {
      for (const auto& [bone, weight] : skin_.weightsAt(near)) weights[bone] += weight;
    }
    int best = *allowed_.begin();
    float most = 0.0f;
    for (const auto& [bone, weight] : weights) {
      if (weight <= most || !allowed_.contains(bone) || isFlatBone(bone)) continue;
      best = bone;
      most = weight;
    }
    return best;
  }

  [[nodiscard]] bool isFlatBone(int bone) const {
    return isFlat(glm::dmat3(glm::mat3(sinew::at(skeleton_.bones, bone).bindInWorld)));
  }

  /// The bone of the point of an edge that is nearest to a fibre's end.
  [[nodiscard]] int boneOfEdge(const SheetEdge& edge, const std::vector<glm::vec3>& points,
                               const glm::vec3& end) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (glm::distance(points[i], end) < glm::distance(points[nearest], end)) nearest = i;
    }
    return *skeleton_.findBone(edge.points[nearest].bone);
  }

  void addLine(int strip) {
    const Fibre& fibre = sinew::at(fibres_, strip);
    const auto under = [&](const glm::vec3& point) {
      return point - kAnchorUnder * height_ * skin_.normalAround(point, kBellyNormal * height_);
    };
    const glm::vec3 middle = fibre.at(0.5f);
    const float step = 0.01f * height_;
    const glm::vec3 along = step * glm::normalize(fibre.at(0.6f) - fibre.at(0.4f));
    const glm::vec3 across = glm::cross(along, skin_.normalAround(middle, kBellyNormal * height_));
    MuscleLine line;
    line.name = sheet_.name + ' ' + std::to_string(strip + 1);
    line.sheet = sheet_.name;
    line.settings = *sheet_.line;
    line.origin = anchorOn(skeleton_, boneOfEdge(sheet_.edges.front(), edges_.front(), fibre.points.front()),
                           under(fibre.points.front()));
    line.insertion = anchorOn(skeleton_, boneOfEdge(sheet_.edges.back(), edges_.back(), fibre.points.back()),
                              under(fibre.points.back()));
    line.via = anchorOn(skeleton_, boneAt(middle, along, across), under(middle));
    laid_.lines.push_back(std::move(line));
  }

  /// Mean distance to the neighbouring fibres across a fibre; 0 of a single one.
  [[nodiscard]] float distanceBeside(int strip, float share, const glm::vec3& point, const glm::vec3& across) const {
    float sum = 0.0f;
    int count = 0;
    for (const int beside : {strip - 1, strip + 1}) {
      if (beside < 0 || beside >= sheet_.strips) continue;
      sum += std::abs(glm::dot(sinew::at(fibres_, beside).at(share) - point, across));
      ++count;
    }
    return count > 0 ? sum / static_cast<float>(count) : 0.0f;
  }

  Result<void> addBelly(int strip, int belly) {
    const Fibre& fibre = sinew::at(fibres_, strip);
    const auto count = static_cast<float>(sheet_.bellies);
    const float share = (static_cast<float>(belly) + 0.5f) / count;
    const glm::vec3 top = fibre.at(share);
    const glm::vec3 direction = fibre.at(share + kTangent / count) - fibre.at(share - kTangent / count);
    const glm::vec3 around = skin_.normalAround(top, kBellyNormal * height_);
    const glm::vec3 along = normalizeOr(direction, {0.0f, 1.0f, 0.0f});
    const glm::vec3 out = normalizeOr(around - glm::dot(around, along) * along, around);
    const glm::vec3 across = glm::cross(along, out);
    const float shell = std::sqrt(sheet_.reach * sheet_.reach - 1.0f);
    const float beside = distanceBeside(strip, share, top, across);
    float thick = sheet_.thickness * height_;
    float wide = sheet_.width * height_;
    if (sheet_.width == 0.0f) {
      thick =
          std::max(std::min(thick, kMostOfBundle * static_cast<float>(sheet_.strips) * beside), kThinnest * height_);
      wide = std::max(beside / (sheet_.spacing * shell), kWidestOverThick * thick);
    }
    const float half = fibre.length() / count / (sheet_.spacing * shell);
    const float rise = sheet_.sunk + (sheet_.crest - sheet_.sunk) * profileAt(sheet_.across, shareOf(strip)) *
                                         profileAt(sheet_.along, share);
    const float step = 0.01f * height_;
    return place({top + (rise * height_ - thick) * out, {across, along, out}, {wide, half, thick}},
                 boneAt(top, step * along, step * across), strip, belly);
  }

  struct WorldBelly {
    glm::vec3 center;
    glm::mat3 axes;  ///< Unit columns: across, along, out.
    glm::vec3 radii;
  };

  Result<void> place(const WorldBelly& belly, int bone, int strip, int number) {
    if (isFlatBone(bone)) return errorAt("", "its bone has a scale of zero in the bind pose");
    const glm::dmat4 toBone(sinew::at(skeleton_.bones, bone).inverseBindInWorld);
    Placement placement;
    placement.center = belly.center;
    placement.rotation = glm::normalize(glm::quat_cast(belly.axes));
    placement.radii = belly.radii;
    Primitive& primitive = laid_.bellies.emplace_back();
    primitive.name = sheet_.name + ' ' + std::to_string(strip + 1) + '.' + std::to_string(number + 1);
    primitive.bone = skeleton_.fileName(bone);
    primitive.group = sheet_.group;
    primitive.sheet = sheet_.name;
    if (sheet_.line) primitive.line = laid_.lines.back().name;
    primitive.placement = imageOf(placement, {glm::dmat3(toBone), glm::dvec3(toBone[3])});
    primitive.reach = sheet_.reach;
    primitive.sign = sheet_.sign;
    primitive.territory = territory_;
    if (std::ranges::find(territory_, primitive.bone) == territory_.end()) {
      primitive.territory->push_back(primitive.bone);
    }
    centers_.push_back(belly.center);
    axes_.emplace_back(belly.axes[0] * belly.radii.x, belly.axes[1] * belly.radii.y, belly.axes[2] * belly.radii.z);
    return {};
  }

  void setAmounts() {
    const std::vector<float> even =
        sheet_.amount > 0.0f ? std::vector<float>() : evenAmounts(centers_, axes_, sheet_.reach);
    for (std::size_t i = 0; i < laid_.bellies.size(); ++i) {
      laid_.bellies[i].amount = even.empty() ? sheet_.amount : even[i];
    }
  }

  const MuscleSheet& sheet_;
  const SheetSkin& skin_;
  const float height_;
  const Skeleton& skeleton_;
  std::vector<std::vector<glm::vec3>> edges_;  ///< [edges] bind pose, world
  std::set<int> allowed_;                      ///< Bones that bellies may ride.
  std::vector<Fibre> fibres_;                  ///< [strips]
  std::map<int, float> weights_;
  std::vector<std::string> territory_;
  std::vector<glm::vec3> centers_;  ///< [bellies] world
  std::vector<glm::mat3> axes_;     ///< [bellies] columns: half axes
  LaidSheet laid_;
};

}  // namespace

std::vector<glm::vec3> spreadAlong(const std::vector<glm::vec3>& edge, int count) {
  const std::vector<float> lengths = lengthsAlong(edge);
  std::vector<glm::vec3> places;
  for (int i = 0; i < count; ++i) {
    const float wanted = (static_cast<float>(i) + 0.5f) / static_cast<float>(count) * lengths.back();
    std::size_t part = 1;
    while (part + 1 < edge.size() && lengths[part] < wanted) ++part;
    if (edge.size() == 1) {
      places.push_back(edge[0]);
      continue;
    }
    const float length = lengths[part] - lengths[part - 1];
    places.push_back(
        glm::mix(edge[part - 1], edge[part], length > 0.0f ? (wanted - lengths[part - 1]) / length : 0.0f));
  }
  return places;
}

std::vector<float> evenAmounts(const std::vector<glm::vec3>& centers, const std::vector<glm::mat3>& axes, float reach) {
  constexpr int kRounds = 10;
  constexpr float kLeastOfOwn = 0.7f;
  constexpr float kMostOfOwn = 1.35f;
  constexpr double kMostSums = 0.8;  // So that most tops do not stand higher than they are drawn.
  constexpr float kLeastEven = 0.03f;
  const std::size_t count = centers.size();
  std::vector<glm::mat3> toBall;
  for (const glm::mat3& one : axes) toBall.push_back(glm::inverse(one));
  const auto g = [&](float squared) {
    const float left = std::max(1.0f - squared / (reach * reach), 0.0f);
    return left * left;
  };
  // [top * count + belly], 1: as one belly at its own top.
  std::vector<float> shares(count * count);
  std::vector<float> sums(count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 top = centers[i] + axes[i][2];
    for (std::size_t j = 0; j < count; ++j) {
      const glm::vec3 in = toBall[j] * (top - centers[j]);
      shares[i * count + j] = g(glm::dot(in, in)) / g(1.0f);
      sums[i] += shares[i * count + j];
    }
  }
  std::vector<float> sorted = sums;
  std::ranges::sort(sorted);
  const float own = 1.0f / sorted[static_cast<std::size_t>(kMostSums * static_cast<double>(count - 1))];
  std::vector<float> amounts(count, own);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<float> next = amounts;
    for (std::size_t i = 0; i < count; ++i) {
      float sum = 0.0f;
      for (std::size_t j = 0; j < count; ++j) sum += shares[i * count + j] * amounts[j];
      const float step = std::sqrt(std::clamp(1.0f / sum, 0.7f, 1.4f));
      next[i] = std::clamp(amounts[i] * step, kLeastOfOwn * own, kMostOfOwn * own);
    }
    amounts = std::move(next);
  }
  for (float& amount : amounts) amount = std::clamp(amount, kLeastEven, kMostAmount);
  return amounts;
}

Result<LaidSheet> laySheet(const MuscleSheet& sheet, const SheetSkin& skin) { return SheetLayer(sheet, skin).lay(); }

}  // namespace sinew
