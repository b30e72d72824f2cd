#include "core/annotation/confidence_scale.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

constexpr double least = 0.01;
constexpr double greatest_strength = 5;

double logit(double p) {
  p = std::clamp(p, least, 1 - least);
  return std::log(p / (1 - p));
}
double logistic(double x) {
  return 1 / (1 + std::exp(-x));
}
Eigen::Vector3d row(const ConfidenceScale::Evidence& evidence) {
  return {1, logit(evidence.probability),
          std::clamp(evidence.strength, -greatest_strength, greatest_strength)};
}

}  // namespace

ConfidenceScale ConfidenceScale::fit(const std::vector<Trial>& trials) {
  ConfidenceScale scale;
  scale.trials_ = static_cast<int>(trials.size());
  if (trials.empty()) return scale;
  const Eigen::Vector3d usual(0, 1, 0);
  for (int step = 0; step < 100; ++step) {
    // Newton's step on the log likelihood less 1/2 |weights - usual|^2: as strong as a few trials.
    Eigen::Vector3d gradient = usual - scale.weights_;
    Eigen::Matrix3d bend = Eigen::Matrix3d::Identity();
    for (const Trial& trial : trials) {
      const Eigen::Vector3d x = row(trial.evidence);
      const double p = logistic(scale.weights_.dot(x));
      gradient += ((trial.right ? 1 : 0) - p) * x;
      bend += p * (1 - p) * x * x.transpose();
    }
    const Eigen::Vector3d change = bend.llt().solve(gradient).cwiseMax(-1).cwiseMin(1);
    scale.weights_ += change;
    if (change.norm() < 1e-9) break;
  }
  return scale;
}

double ConfidenceScale::operator()(const Evidence& evidence) const {
  return std::clamp(logistic(weights_.dot(row(evidence))), least, 1 - least);
}

}  // namespace abrazo
