#pragma once

#include <span>

#include "core/library/store/normalization.hpp"

namespace abrazo {

/// Features in single precision along the axes on which they lie widest apart, the widest first, in units of
/// their extent: what narrows a search down before distances in double precision decide.
class FeatureAxes {
 public:
  static constexpr int dimensions = 16;  ///< 15 and a zero, a whole number of registers
  using Point = Eigen::Array<float, dimensions, 1>;

  FeatureAxes() = default;
  /// @param features  finite
  explicit FeatureAxes(std::span<const Features> features);

  Point of(const Features& features) const;

  /// False where the features are no lengths of a body, such as 1e200.
  bool can_tell_apart() const { return is_usable_; }
  /// False as well when a query is so far from all features that single precision tells nothing about who is
  /// near.
  bool can_tell(const Features& query) const;

  /// What rounding may add to a distance from this query, in units of the extent.
  double slack_for(const Features& query) const;

  /// Units of the extent in a metre; a power of two.
  double scale() const { return scale_; }

 private:
  Eigen::Matrix<double, 15, 15> axes_ = Eigen::Matrix<double, 15, 15>::Identity();  ///< one per row
  Features centre_ = Features::Zero();
  double scale_ = 1;
  bool is_usable_ = false;
};

/// How far a search goes: what is farther on the axes need not be looked at. Shrinks while the search goes
/// on.
class SearchReach {
 public:
  /// @param relative_error  of squared distances on the axes, as they are summed up
  SearchReach(const FeatureAxes& axes, const Features& query, double relative_error);

  /// A squared distance on the axes.
  float limit() const { return limit_; }
  /// @param distance_m  of the features; never lengthens
  void shrink_to(double distance_m);

 private:
  double scale_, slack_, factor_;
  float limit_;
};

/// Who decides, in double precision, about the places that a search comes by.
class PlaceJudge {
 public:
  virtual ~PlaceJudge() = default;
  /// May shrink the reach.
  virtual void look_at(std::size_t place, SearchReach& reach) = 0;
  /// All places will be looked at again, within the same reach.
  virtual void start_again() = 0;
};

}  // namespace abrazo
