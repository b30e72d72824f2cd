#include "core/selection/partner_embedding.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

constexpr double least_share = 1e-6;  ///< of the greatest eigenvalue; axes below are rounding

}  // namespace

PartnerEmbedding::PartnerEmbedding(const std::vector<Pose>& landmarks) {
  const auto count = static_cast<Eigen::Index>(landmarks.size());
  landmarks_.resize(joint_count * 3, count);
  for (Eigen::Index l = 0; l < count; ++l)
    for (int joint = 0; joint < joint_count; ++joint)
      for (int axis = 0; axis < 3; ++axis)
        landmarks_(3 * joint + axis, l) =
            static_cast<float>(landmarks[static_cast<std::size_t>(l)](joint, axis));
  Eigen::MatrixXd distances(count, count);
  std::vector<float> row(landmarks.size());
  for (Eigen::Index l = 0; l < count; ++l) {
    distances_to(landmarks[static_cast<std::size_t>(l)], row);
    distances.row(l) = Eigen::Map<const Eigen::RowVectorXf>(row.data(), count).cast<double>();
  }
  distances = 0.5 * (distances + distances.transpose()).eval();
  const Eigen::VectorXd usual = distances.colwise().mean();
  const Eigen::MatrixXd centred =
      (-0.5 * ((distances.colwise() - usual).rowwise() - usual.transpose()).array() - 0.5 * usual.mean())
          .matrix();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(centred);
  const Eigen::VectorXd& values = found.eigenvalues();  // ascending
  const double least = std::max(values(count - 1) * least_share, 1e-12);
  Eigen::Index axes = 0;
  while (axes < std::min<Eigen::Index>(count, most_axes) && values(count - 1 - axes) > least) ++axes;
  axes_.resize(count, axes);
  for (Eigen::Index a = 0; a < axes; ++a)
    axes_.col(a) = (found.eigenvectors().col(count - 1 - a) / std::sqrt(values(count - 1 - a))).cast<float>();
  usual_ = usual.cast<float>();
}

void PartnerEmbedding::distances_to(const Pose& partner, std::span<float> distances) const {
  Eigen::Map<Eigen::ArrayXf> sum(distances.data(), landmarks_.cols());
  sum.setZero();
  for (int joint = 0; joint < joint_count; ++joint) {
    const auto x = landmarks_.row(3 * joint).transpose().array() - static_cast<float>(partner(joint, 0));
    const auto y = landmarks_.row(3 * joint + 1).transpose().array() - static_cast<float>(partner(joint, 1));
    const auto z = landmarks_.row(3 * joint + 2).transpose().array() - static_cast<float>(partner(joint, 2));
    sum += (x.square() + y.square() + z.square()).sqrt();
  }
  sum /= static_cast<float>(joint_count);
}

void PartnerEmbedding::embed(const Pose& partner, std::span<float> point, std::span<float> work) const {
  distances_to(partner, work);
  Eigen::Map<Eigen::VectorXf> off(work.data(), room());
  off -= usual_;
  Eigen::Map<Eigen::VectorXf>(point.data(), size()).noalias() = -0.5F * (axes_.transpose() * off);
}

}  // namespace abrazo
