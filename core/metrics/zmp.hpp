#pragma once

#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/body_segments.hpp"

namespace abrazo {

/// How the zero-moment-point error is measured. All of it belongs into a report: the figure depends on it.
struct ZmpSettings {
  using Segments = SegmentTable;
  Segments segments = Segments::Mean;
  double floor_m = 0;  ///< height of the floor
  double contact_height_m =
      0.10;                       ///< a foot supports while its lower toe joint is below this above the floor
  double smoothing_s = 4.0 / 60;  ///< half width of the triangular window over accelerations; 0 = none
  double sole_margin_m = 0;       ///< the support polygon is widened by this
};

/// Distance of the zero moment point from the support polygon, frame by frame.
struct ZmpError {
  std::vector<double> error_m;  ///< of the frames that count, in order; 0 inside the polygon
  std::vector<int> frames;      ///< which these are
  int skipped_no_support = 0;   ///< no foot on the floor
  int skipped_free_fall = 0;    ///< vertical force below 0.2 of the weight: the point is not defined
  int skipped_ends = 0;         ///< first and last frames, where no acceleration can be had
  double mean_m() const;        ///< 0 when no frame counts
  int skipped() const { return skipped_no_support + skipped_free_fall + skipped_ends; }
  /// Takes in the frames of another motion, so that the mean is over both. Their numbers stay what they are.
  void append(const ZmpError& other);
};

/// Mean errors of two measures of motions of the same length, over the frames that count in both: a motion
/// that throws itself about has fewer frames, and they are the easier ones.
struct CommonZmp {
  double first_m = 0, second_m = 0;  ///< not a number when no frame counts in both
  int frames = 0;
};

/// `ZmpError` of a motion in several stretches, beside that of another in the same ones.
class ZmpComparison {
 public:
  /// Of one stretch.
  void add(const ZmpError& first, const ZmpError& second);
  /// Takes in those of another body.
  void append(const ZmpComparison& other);
  CommonZmp common() const;

 private:
  std::vector<double> first_m_, second_m_;
};

/// Frames on either side that the window reaches at a rate: 4 at 60 Hz, 2 at 30 Hz, 1 at 15 Hz for 4/60 s.
int smoothing_half_width(const ZmpSettings& settings, double fps);

/// ZMP of segments taken as point masses (Ikemoto, Arikan and Forsyth 2007; paper 4.5):
///   x = sum m_i [(a_iy + g) x_i - a_ix y_i] / sum m_i (a_iy + g), z likewise,
/// y above the floor; accelerations by central differences, then averaged with the weights h + 1 - |k| of the
/// frames k = -h .. h around, h = `smoothing_half_width`. The support polygon is the convex hull of ankle,
/// toe-base and toe-tip of supporting feet.
/// Unchanged by a turn about Y and by a horizontal shift of the whole motion.
/// @param poses  one body at a constant rate, world [m]
/// @throws std::invalid_argument when the rate is not positive or the smoothing or margin is negative
ZmpError measure_zmp(std::span<const Pose> poses, double fps, const ZmpSettings& settings);

/// Metres in one unit of the CMU skeleton files, in which the paper's Table IV most probably is.
inline constexpr double metres_per_asf_unit = 2.54 / 0.45 / 100;

}  // namespace abrazo
