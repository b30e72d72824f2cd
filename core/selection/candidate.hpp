#pragma once

namespace abrazo {

/// Eq. 7 term by term [m^2].
struct CostBreakdown {
  double pose = 0;              ///< sum_l |p_in - p_A,j|^2
  double temporal_active = 0;   ///< sum_l |s_A* - q''_A,j|^2, not yet times alpha
  double temporal_passive = 0;  ///< sum_l |s_S* - q''_S,j|^2, not yet times alpha
  double total = 0;             ///< pose + alpha (temporal_active + temporal_passive)
};

/// A recorded pair that was considered for a frame.
struct Candidate {
  int pair = -1;                ///< in the library
  double feature_distance = 0;  ///< Euclidean [m]
  bool continuation = false;  ///< joined because it continues the current source, not as a nearest neighbour
  CostBreakdown cost;
};

}  // namespace abrazo
