// tests/support/oracle/field.h: F of docs/design.md by brute force in double.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"
#include "tests/support/oracle/grooves.h"
#include "tests/support/oracle/math.h"
#include "tests/support/oracle/shape.h"

namespace sinew::oracle {

/// g and its derivative by r (paper 3.1).
double g(double r);
double gSlope(double r);

/// All attached primitives of a rig, their groups' cliques and, once posed, their places in the world. F is the mean
/// over all thresholds of 0..1 of that of the graph which has the links with at least such an amount.
/// Weights everywhere are m_i, one per attached primitive, as docs/design.md wants them at the asking vertex.
class Field {
 public:
  Field(const Character& character, const Rig& rig);

  void pose(const Pose& pose);

  [[nodiscard]] int count() const { return static_cast<int>(primitives_.size()); }
  [[nodiscard]] double iso() const { return iso_; }
  /// m_i(v) of a control vertex.
  [[nodiscard]] std::vector<double> territoryWeights(int vertex) const;
  [[nodiscard]] double value(const Vec& point, std::span<const double> weights) const;
  /// Gradient of the clique that is the maximum at the point; with grooves, of the mean of cliques that is.
  [[nodiscard]] Vec gradient(const Vec& point, std::span<const double> weights) const;
  /// By how much the best clique's positive part leads the best clique with another one, the least for any threshold;
  /// 0 on a crease. Grooves leave no crease: 1e300.
  [[nodiscard]] double lead(const Vec& point, std::span<const double> weights) const;
  /// Groups of which only a part counts at a point: more than 0 in a soft groove.
  [[nodiscard]] int groupsInPart(const Vec& point, std::span<const double> weights) const;
  /// Smallest r = q / k of any primitive with weight > 0: 1 and more means that none reaches the point.
  [[nodiscard]] double nearest(const Vec& point, std::span<const double> weights) const;
  /// h of docs/design.md: the mean over the primitives that reach the point of their mean radius, at most `most` each,
  /// weighted by |m_i f_i|; `most` where none does.
  [[nodiscard]] double blendWidth(const Vec& point, std::span<const double> weights, double most) const;
  /// Some m_i f_i != 0.
  [[nodiscard]] bool inRegion(const Vec& point, std::span<const double> weights) const;

  /// What primitives and carves add along origin + t direction: value(t) is Field::value there, asked often.
  class Ray {
   public:
    [[nodiscard]] double value(double t) const;
    /// Largest t at which a primitive still reaches the ray; 0 if none does from t = 0 on.
    [[nodiscard]] double end() const { return end_; }
    [[nodiscard]] bool isEmpty() const { return terms_.empty(); }

   private:
    friend class Field;
    struct Term {
      Vec start;  ///< Unit-ball space.
      Vec along;
      double strength = 0.0;  ///< sign m s
      std::size_t group = 0;
      double kappa = 0.0;
      Shape shape;
      double reach = 1.0;
    };
    std::vector<Term> terms_;
    const Field* field_ = nullptr;
    double end_ = 0.0;
  };
  /// The Field must outlive the ray and keep its pose.
  [[nodiscard]] Ray along(const Vec& origin, const Vec& direction, std::span<const double> weights) const;

 private:
  /// What primitives add at a point.
  struct Sums {
    PerGroup x{};  ///< Of positive potentials.
    PerGroup y{};  ///< The same, each times its muscle's kappa.
    double carved = 0.0;

    void add(double amount, std::size_t group, double kappa);
  };

  /// Thresholds with the same links, and their share of 0..1.
  struct Level {
    double width = 1.0;
    std::vector<Clique> cliques;  ///< All maximal ones.
  };

  struct Item {
    int bone = 0;
    std::size_t group = 0;
    Vec centerInBone;
    Mat unitToBone;  ///< Unit ball -> influence ellipsoid about its center, bone space.
    Shape shape;
    double reach = 1.0;
    double strength = 1.0;
    int sign = 1;
    std::vector<bool> territory;  ///< [bones]
    // Posed:
    Vec center;
    Mat toUnit;
    double meanRadius = 0.0;  ///< Radius of the ball with the visible ellipsoid's volume.
    double kappa = 0.0;       ///< min(2, 2 w / (R (reach^2 - 1))), w the width of grooves.
    bool flat = false;
  };

  [[nodiscard]] Sums sumsAt(const Vec& point, std::span<const double> weights) const;
  /// Where each group counts by its share.
  [[nodiscard]] Vec gradientOf(const PerGroup& shares, const Vec& point, std::span<const double> weights) const;
  [[nodiscard]] double radius(const Item& item, const Vec& point) const;
  /// F of what was added up.
  [[nodiscard]] double valueOf(const Sums& sums) const;
  [[nodiscard]] Vec gradientOf(const Level& level, const Sums& sums, const Vec& point,
                               std::span<const double> weights) const;

  const Character& character_;
  double iso_ = 0.25;
  double grooves_ = 0.0;  ///< w, world units; 0: the maximum of the cliques.
  std::vector<Item> primitives_;
  std::vector<Level> levels_;
};

/// Bone by path, or by name if that is unique; -1 otherwise (docs/formats.md).
int boneNamed(const Skeleton& skeleton, const std::string& name);

}  // namespace sinew::oracle
