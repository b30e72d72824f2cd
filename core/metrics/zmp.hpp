#pragma once

#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/body_segments.hpp"

namespace abrazo {

/// Parameters of the zero-moment-point error. Reports must state them, because the figure depends on them.
struct ZmpSettings {
  using Segments = SegmentTable;
  Segments segments = Segments::Mean;
  double floor_m = 0;              ///< height of the floor
  double contact_height_m = 0.10;  ///< a foot supports while its lower toe joint is lower than this above the
                                   ///< floor
  double smoothing_s = 4.0 / 60;   ///< half width of the triangular window over accelerations; 0 = none
  double sole_margin_m = 0;        ///< margin added to the support polygon
};

/// Distance of the zero moment point from the support polygon, frame by frame.
struct ZmpError {
  std::vector<double> error_m;  ///< per counted frame, in order; 0 inside the polygon
  std::vector<int> frames;      ///< indices of the counted frames
  int skipped_no_support = 0;   ///< no foot on the floor
  int skipped_free_fall = 0;    ///< vertical force below 0.2 of the weight: the point is not defined
  int skipped_ends = 0;         ///< first and last frames, without acceleration
  double mean_m() const;        ///< 0 if no frame counts
  int skipped() const { return skipped_no_support + skipped_free_fall + skipped_ends; }
  /// Appends the frames of another motion, so that the mean is over both. Frame numbers are unchanged.
  void append(const ZmpError& other);
};

/// Mean errors of two motions of the same length over the frames that count in both. Otherwise a violent
/// motion would have an advantage: fewer of its frames count, and those are the easier ones.
struct CommonZmp {
  double first_m = 0, second_m = 0;  ///< NaN if no frame counts in both
  int frames = 0;
};

/// Accumulates the `ZmpError` of two motions over the same stretches.
class ZmpComparison {
 public:
  /// Adds one stretch.
  void add(const ZmpError& first, const ZmpError& second);
  /// Appends the stretches of another body.
  void append(const ZmpComparison& other);
  CommonZmp common() const;

 private:
  std::vector<double> first_m_, second_m_;
};

/// Half width of the smoothing window in frames: 4 at 60 Hz, 2 at 30 Hz, 1 at 15 Hz for 4/60 s.
int smoothing_half_width(const ZmpSettings& settings, double fps);

/// ZMP of segments taken as point masses (Ikemoto, Arikan and Forsyth 2007; paper 4.5):
///   x = sum m_i [(a_iy + g) x_i - a_ix y_i] / sum m_i (a_iy + g), z likewise,
/// y above the floor; accelerations by central differences, then averaged with the weights h + 1 - |k| of the
/// frames k = -h .. h around, h = `smoothing_half_width`. The support polygon is the convex hull of ankle,
/// toe-base and toe-tip of supporting feet.
/// Invariant under rotation about Y and horizontal translation of the motion.
/// @param poses  one body at a constant rate, world [m]
/// @throws std::invalid_argument if the rate is not positive, or smoothing or margin is negative
ZmpError measure_zmp(std::span<const Pose> poses, double fps, const ZmpSettings& settings);

/// Metres per unit of the CMU skeleton files, most probably the unit of the paper's Table IV.
inline constexpr double metres_per_asf_unit = 2.54 / 0.45 / 100;

}  // namespace abrazo
