#pragma once

#include <span>

#include "core/library/store/normalization.hpp"

namespace abrazo {

/// Features in single precision on their principal axes, widest first, in units of their extent. They narrow
/// a search down before distances in double precision decide.
class FeatureAxes {
 public:
  static constexpr int dimensions = 16;  ///< 15 and a zero: fills whole registers
  using Point = Eigen::Array<float, dimensions, 1>;

  FeatureAxes() = default;
  /// @param features  finite
  explicit FeatureAxes(std::span<const Features> features);

  Point of(const Features& features) const;

  /// False if the features are not plausible lengths, such as 1e200.
  bool can_tell_apart() const { return is_usable_; }
  /// False also if a query is so far from all features that single precision cannot rank them.
  bool can_tell(const Features& query) const;

  /// Upper bound of the rounding error of a distance from this query, in units of the extent.
  double slack_for(const Features& query) const;

  /// Units of the extent per metre; a power of two.
  double scale() const { return scale_; }

 private:
  Eigen::Matrix<double, 15, 15> axes_ = Eigen::Matrix<double, 15, 15>::Identity();  ///< one per row
  Features centre_ = Features::Zero();
  double scale_ = 1;
  bool is_usable_ = false;
};

/// Radius of a search: rows farther away on the axes need not be examined. Shrinks during the search.
class SearchReach {
 public:
  /// @param relative_error of summation of squared distances on the axes
  SearchReach(const FeatureAxes& axes, const Features& query, double relative_error);

  /// Squared radius on the axes.
  float limit() const { return limit_; }
  /// @param distance_m between features; never enlarges the radius
  void shrink_to(double distance_m);

 private:
  double scale_, slack_, factor_;
  float limit_;
};

/// Decides, in double precision, about the places that a search visits.
class PlaceJudge {
 public:
  virtual ~PlaceJudge() = default;
  /// Examines a place; may shrink the reach.
  virtual void look_at(std::size_t place, SearchReach& reach) = 0;
  /// All places will be visited again, within the same reach.
  virtual void start_again() = 0;
};

}  // namespace abrazo
