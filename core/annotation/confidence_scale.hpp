#pragma once

#include <Eigen/Core>
#include <vector>

namespace abrazo {

/// Maps the evidence for a suggestion to the share of such suggestions that were right in trials: p = 1 / (1
/// + exp(-(o + s logit(probability) + t strength))), fitted by maximum likelihood (Platt 1999) with a weak
/// pull towards p = probability.
class ConfidenceScale {
 public:
  struct Evidence {
    double probability = 0;  ///< 0 to 1, of the model
    double strength = 0;     ///< log odds of the stretch alone
  };
  struct Trial {
    Evidence evidence;
    bool right = false;
  };
  /// Without trials p = probability.
  static ConfidenceScale fit(const std::vector<Trial>& trials);

  /// 0.01 to 0.99: limited to that range.
  double operator()(const Evidence& evidence) const;
  int trials() const { return trials_; }

 private:
  Eigen::Vector3d weights_{0, 1, 0};  ///< o, s, t
  int trials_ = 0;
};

}  // namespace abrazo
