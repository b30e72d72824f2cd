#pragma once

#include <vector>

#include "core/base/positions.hpp"
#include "core/library/build/capsule_calibration.hpp"
#include "core/synthesis/edit/capsule_contacts.hpp"

namespace abrazo {

/// Penetration over a run, measured with the capsules of the synthesis: per frame the deepest overlap of two
/// capsules of different bodies, 0 if none touch. Leaves out hands and forearms of arms that hold one another
/// in the selected pair.
class PenetrationMetric {
 public:
  void add(const PairPose& result, const PairPose& selected, const CapsuleRadii& active,
           const CapsuleRadii& passive);
  /// Adds a frame with known depths, see FrameResult::residual.
  void add(double deepest_m, double deepest_excess_m);

  struct Figures {
    double deep_share = 0;  ///< frames deeper than 1 cm
    double mean_m = 0;      ///< of the deepest overlap of a frame
    double p99_m = 0;
    double max_m = 0;
    double excess_p99_m = 0;  ///< beyond the selected pair's own
    double excess_max_m = 0;
    int frames = 0;
  };
  Figures figures() const;

 private:
  CapsuleContacts contacts_;
  std::vector<CapsuleContact> overlaps_;
  std::vector<double> depths_m_, excesses_m_;
};

}  // namespace abrazo
