#pragma once

#include <optional>

namespace abrazo {

/// Eq. 7 term by term [m^2].
struct CostBreakdown {
  double pose = 0;              ///< sum_l |p_in - p_A,j|^2
  double temporal_active = 0;   ///< sum_l |s_A* - q''_A,j|^2, not yet times alpha
  double temporal_passive = 0;  ///< sum_l |s_S* - q''_S,j|^2, not yet times alpha
  double total = 0;             ///< pose + alpha (temporal_active + temporal_passive)
};

/// Cost of a recorded pair by the selection `intent`, term by term [m]; terms include their weights.
struct IntentCost {
  double partner = 0;   ///< expected mean joint distance between its partner and the intended one
  double leader = 0;    ///< w_l (1 - kernel): the user's last two seconds compared with those before this
                        ///< pair
  double move = 0;      ///< w_m (1 - P(its label))
  double meant = 0;     ///< w_p if another label or take is intended
  double change = 0;    ///< the switch margin if it does not continue the current source
  double total = 0;     ///< their sum, with `temporal`
  double temporal = 0;  ///< alpha (d + 0.1 s v + c): difference from the shown partner in place, speed and
                        ///< contacts
};

/// A recorded pair considered for a frame.
struct Candidate {
  int pair = -1;                ///< in the library
  double feature_distance = 0;  ///< Euclidean [m]
  bool continuation = false;    ///< added as a continuation of the current source, not as a nearest neighbour
  CostBreakdown cost;
  std::optional<IntentCost> intent = {};  ///< set by the selection `intent`, which decides by its total
};

/// The deciding cost of a candidate; less is better. [m^2] by Eq. 7, [m] by `intent`.
inline double deciding_cost(const Candidate& candidate) {
  return candidate.intent ? candidate.intent->total : candidate.cost.total;
}

}  // namespace abrazo
