#include "core/metrics/published.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/statistics.hpp"
#include "core/library/store/normalization.hpp"

namespace abrazo {

namespace {

constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

double mean_or_nothing(const std::vector<double>& values) {
  return values.empty() ? no_figure : mean(values);
}

/// Mean over the joints of how far they are apart.
double mean_distance(const Pose& a, const Pose& b) {
  return (a - b).rowwise().norm().mean();
}

double least_joint_distance(const Pose& a, const Pose& b) {
  double least_sq = std::numeric_limits<double>::infinity();
  for (int j = 0; j < joint_count; ++j)
    least_sq = std::min(least_sq, (b.rowwise() - a.row(j)).rowwise().squaredNorm().minCoeff());
  return std::sqrt(least_sq);
}

/// Distances of the partner's joints (rows of ten) from the user's.
CrossDistances cross_distances_of(const Pose& user, const Pose& partner) {
  CrossDistances distances;
  Eigen::Index row = 0;
  for (const int of_partner : cross_joints)
    for (const int of_user : cross_joints)
      distances[row++] = (partner.row(of_partner) - user.row(of_user)).norm();
  return distances;
}

/// By a Gaussian that is cut off at four times its width, the values mirrored at both ends (their last one
/// twice).
std::vector<double> smoothed(const std::vector<double>& values, double width) {
  const int reach = static_cast<int>(4 * width + 0.5), count = static_cast<int>(values.size());
  std::vector<double> weights;
  double sum = 0;
  for (int offset = -reach; offset <= reach; ++offset) {
    weights.push_back(std::exp(-0.5 * offset * offset / (width * width)));
    sum += weights.back();
  }
  const auto mirrored = [&](int at) {
    const int period = 2 * count;
    at = ((at % period) + period) % period;
    return static_cast<std::size_t>(at < count ? at : period - 1 - at);
  };
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    double value = 0;
    for (int offset = -reach; offset <= reach; ++offset)
      value += weights[static_cast<std::size_t>(offset + reach)] * values[mirrored(i + offset)];
    result.push_back(value / sum);
  }
  return result;
}

/// Rows less their mean, scaled so that their product with themselves is the covariance (sample).
Eigen::MatrixXd deviations_of(const Eigen::MatrixXd& rows) {
  return (rows.rowwise() - rows.colwise().mean()) / std::sqrt(static_cast<double>(rows.rows() - 1));
}

}  // namespace

double mpjpe_m(std::span<const Pose> made, std::span<const Pose> captured) {
  std::vector<double> errors;
  for (std::size_t f = 0; f < made.size(); ++f) errors.push_back(mean_distance(made[f], captured[f]));
  return mean_or_nothing(errors);
}

double mpjve_m(std::span<const Pose> made, std::span<const Pose> captured) {
  std::vector<double> errors;
  for (std::size_t f = 1; f < made.size(); ++f)
    errors.push_back(mean_distance(made[f] - made[f - 1], captured[f] - captured[f - 1]));
  return mean_or_nothing(errors);
}

double foot_sliding_m(std::span<const Pose> poses) {
  constexpr double on_the_floor_m = 0.05;
  constexpr std::array toes = {joints::left_toe_base, joints::right_toe_base};
  double floor = std::numeric_limits<double>::infinity();
  for (const Pose& pose : poses)
    for (const int toe : toes) floor = std::min(floor, pose(toe, 1));
  std::vector<double> slides;
  for (std::size_t f = 0; f < poses.size(); ++f)
    for (const int toe : toes)
      if (poses[f](toe, 1) < floor + on_the_floor_m)
        slides.push_back(f == 0 ? 0 : (poses[f].row(toe) - poses[f - 1].row(toe)).norm());
  return mean_or_nothing(slides);
}

double skating_share(std::span<const Pose> poses) {
  constexpr double pelvis_moves_m = 0.03, legs_rest_m = 0.01;
  std::vector<double> skates;
  for (std::size_t f = 1; f < poses.size(); ++f) {
    const Pose &now = poses[f], &before = poses[f - 1];
    bool rest = true;
    for (const int ankle : {joints::left_ankle, joints::right_ankle})
      rest =
          rest &&
          ((now.row(ankle) - now.row(joints::Root)) - (before.row(ankle) - before.row(joints::Root))).norm() <
              legs_rest_m;
    const Eigen::RowVector3d way = now.row(joints::Root) - before.row(joints::Root);
    const bool moves = std::hypot(way.x(), way.z()) > pelvis_moves_m;
    // The official code passes over the first difference and counts it in the number of frames.
    skates.push_back(f > 1 && rest && moves ? 1 : 0);
  }
  return mean_or_nothing(skates);
}

double jitter_10_m_s3(std::span<const Pose> poses) {
  std::vector<double> lengths;
  for (std::size_t f = 3; f < poses.size(); ++f)
    lengths.push_back(
        (poses[f] - 3 * poses[f - 1] + 3 * poses[f - 2] - poses[f - 3]).rowwise().norm().mean());
  const double per_s = published_rate_hz;
  return mean_or_nothing(lengths) * per_s * per_s * per_s / 10;
}

JointPenetration joint_penetration(const Duet& duet) {
  constexpr double penetrates_m = 0.01;
  std::vector<double> share, depths;
  for (std::size_t f = 0; f < duet.user.size(); ++f) {
    const double least = least_joint_distance(duet.user[f], duet.partner[f]);
    share.push_back(least < penetrates_m ? 1 : 0);
    depths.push_back(std::max(0.0, penetrates_m - least));
  }
  return {mean_or_nothing(share), mean_or_nothing(depths)};
}

void ContactCounts::add(const ContactCounts& other) {
  both += other.both;
  only_made += other.only_made;
  only_captured += other.only_captured;
}

double ContactCounts::precision() const {
  return both + only_made > 0 ? static_cast<double>(both) / static_cast<double>(both + only_made) : no_figure;
}

double ContactCounts::recall() const {
  return both + only_captured > 0 ? static_cast<double>(both) / static_cast<double>(both + only_captured)
                                  : no_figure;
}

double ContactCounts::f1() const {
  const long long all = 2 * both + only_made + only_captured;
  return all > 0 ? 2.0 * static_cast<double>(both) / static_cast<double>(all) : no_figure;
}

ContactCounts joint_contacts(const Duet& made, const Duet& captured) {
  constexpr double contact_m = 0.25;
  ContactCounts counts;
  for (std::size_t f = 0; f < made.user.size(); ++f) {
    const CrossDistances shown = cross_distances_of(made.user[f], made.partner[f]);
    const CrossDistances meant = cross_distances_of(captured.user[f], captured.partner[f]);
    for (Eigen::Index pair = 0; pair < shown.size(); ++pair) {
      const bool is_shown = shown[pair] < contact_m, is_meant = meant[pair] < contact_m;
      counts.both += is_shown && is_meant ? 1 : 0;
      counts.only_made += is_shown && !is_meant ? 1 : 0;
      counts.only_captured += !is_shown && is_meant ? 1 : 0;
    }
  }
  return counts;
}

double turned_away_share(const Duet& duet) {
  const double least_cosine = std::cos(std::numbers::pi / 4);
  std::vector<double> turned;
  std::optional<double> user_before, partner_before;
  for (std::size_t f = 0; f < duet.user.size(); ++f) {
    const RootFrame user = root_frame(duet.user[f], user_before);
    const RootFrame partner = root_frame(duet.partner[f], partner_before);
    user_before = user.heading_rad, partner_before = partner.heading_rad;
    turned.push_back(-std::cos(user.heading_rad - partner.heading_rad) < least_cosine ? 1 : 0);
  }
  return mean_or_nothing(turned);
}

std::vector<int> motion_beats(std::span<const Pose> poses) {
  std::vector<double> speeds;
  for (std::size_t f = 1; f < poses.size(); ++f) speeds.push_back(mean_distance(poses[f], poses[f - 1]));
  constexpr double width = 5;
  const std::vector<double> smooth = smoothed(speeds, width);
  std::vector<int> beats;
  for (std::size_t f = 1; f + 1 < smooth.size(); ++f)
    if (smooth[f] < smooth[f - 1] && smooth[f] < smooth[f + 1]) beats.push_back(static_cast<int>(f));
  return beats;
}

double beat_echo_degree(std::span<const int> leader, std::span<const int> follower) {
  std::vector<double> echoes;
  for (const int beat : leader) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const int echo : follower) nearest = std::min(nearest, std::abs(static_cast<double>(echo - beat)));
    echoes.push_back(std::exp(-nearest * nearest / 2 / 9));
  }
  return mean_or_nothing(echoes);
}

CrossDistances cross_distances(const Duet& clip) {
  CrossDistances sum = CrossDistances::Zero();
  for (std::size_t f = 0; f < clip.user.size(); ++f) sum += cross_distances_of(clip.user[f], clip.partner[f]);
  return sum / static_cast<double>(clip.user.size());
}

Eigen::MatrixXd z_scored(const Eigen::MatrixXd& features, const Eigen::MatrixXd& reference) {
  constexpr double least = 1e-10;
  const Eigen::RowVectorXd mean = reference.colwise().mean();
  const Eigen::RowVectorXd deviation =
      (reference.rowwise() - mean).array().square().colwise().mean().sqrt() + least;
  return (features.rowwise() - mean).array().rowwise() / deviation.array();
}

double frechet_distance(const Eigen::MatrixXd& first, const Eigen::MatrixXd& second) {
  if (first.rows() < 2 || second.rows() < 2) return no_figure;
  const Eigen::MatrixXd a = deviations_of(first), b = deviations_of(second);
  // With C1 = A' A and C2 = B' B, the eigenvalues of C1 C2 are the squared singular values of A B': this
  // avoids the root of a matrix that is singular for fewer clips than features.
  const double trace_of_root = Eigen::BDCSVD<Eigen::MatrixXd>(a * b.transpose()).singularValues().sum();
  return (first.colwise().mean() - second.colwise().mean()).squaredNorm() + a.squaredNorm() +
         b.squaredNorm() - 2 * trace_of_root;
}

double diversity(const Eigen::MatrixXd& features) {
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < features.rows(); ++i)
    for (Eigen::Index j = i + 1; j < features.rows(); ++j)
      distances.push_back((features.row(i) - features.row(j)).norm());
  return mean_or_nothing(distances);
}

}  // namespace abrazo
