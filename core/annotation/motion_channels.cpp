#include "core/annotation/motion_channels.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/base/positions.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double lead_lag_s = 0.25;      ///< between a movement and the answer to it
constexpr double speed_window_s = 0.10;  ///< speeds are differences over this time
constexpr double longest_reach_m = 2.5;  ///< farther apart is the same

double level_norm(const Vec3& v) {
  return std::hypot(v.x(), v.z());
}

/// Curves of one performer and of what he or she does to the other.
struct Side {
  const std::vector<Pose>& mine;
  const std::vector<Pose>& yours;
  const std::vector<double>& my_heading;
};

/// One row of a table, filled from the left.
class Row {
 public:
  explicit Row(Eigen::Ref<Eigen::Matrix<float, 1, Eigen::Dynamic>, 0, Eigen::InnerStride<>> row)
      : row_(row) {}
  void operator<<(double value) { row_[next_++] = static_cast<float>(value); }
  int next() const { return next_; }

 private:
  Eigen::Ref<Eigen::Matrix<float, 1, Eigen::Dynamic>, 0, Eigen::InnerStride<>> row_;
  int next_ = 0;
};

/// Speed of a joint about a frame [m/s].
double speed(const std::vector<Pose>& poses, int joint_index, int frame, int reach, double fps) {
  const int last = static_cast<int>(poses.size()) - 1;
  const int from = std::max(0, frame - reach), to = std::min(last, frame + reach);
  if (from == to) return 0;
  return (joint_at(poses[static_cast<std::size_t>(to)], joint_index) -
          joint_at(poses[static_cast<std::size_t>(from)], joint_index))
             .norm() *
         fps / (to - from);
}

double trunk_distance(const Vec3& point, const Pose& body) {
  double nearest = longest_reach_m;
  for (const int spine : {joints::Root, joints::LowerBack, joints::UpperBack, joints::Thorax})
    nearest = std::min(nearest, (point - joint_at(body, spine)).norm());
  return nearest;
}

void add_side(Row& row, const Side& side, int frame, int reach, double fps, double facing) {
  const Pose& me = side.mine[static_cast<std::size_t>(frame)];
  const Pose& you = side.yours[static_cast<std::size_t>(frame)];
  const Vec3 root = joint_at(me, joints::Root);
  const double heading = side.my_heading[static_cast<std::size_t>(frame)] * 2 * std::numbers::pi;
  const Vec3 forward(std::sin(heading), 0, std::cos(heading));
  row << std::abs(facing);
  for (const int hand : {joints::left_hand, joints::right_hand}) {
    const Vec3 at = joint_at(me, hand);
    row << back_distance(at, you);
    row << std::min(longest_reach_m, (at - joint_at(you, joints::Head)).norm());
    row << trunk_distance(at, you);
    row << (at - root).dot(forward);
    row << at.y() - joint_at(me, joints::Head).y();
    row << speed(side.mine, hand, frame, reach, fps);
  }
  double lowest = 10;
  for (const int foot : {joints::left_ankle, joints::right_ankle}) {
    const Vec3 at = joint_at(me, foot);
    row << at.y();
    row << trunk_distance(at, you);
    row << speed(side.mine, foot, frame, reach, fps);
    lowest = std::min(lowest, at.y());
  }
  row << root.y() - lowest;
  row << joint_at(me, joints::Head).y() - lowest;
  const Vec3 lean = joint_at(me, joints::Thorax) - root;
  row << lean.dot(forward);
  row << lean.dot(forward.cross(Vec3::UnitY()));
  row << speed(side.mine, joints::Root, frame, reach, fps);
  row << speed(side.mine, joints::Head, frame, reach, fps);
}

/// Above 0 where x moves first and y answers: s_x(t - T/2) s_y(t + T/2) - s_x(t + T/2) s_y(t - T/2), of the
/// speeds of a joint, for T = `lead_lag_s`, in shares of the mean square.
void add_lead(MotionChannels& channels, int column, int speed_x, int speed_y) {
  const int half = std::max(1, static_cast<int>(std::lround(lead_lag_s / 2 * channels.fps)));
  auto& values = channels.values;
  const float power = (values.col(speed_x).squaredNorm() + values.col(speed_y).squaredNorm()) /
                      static_cast<float>(2 * std::max<Eigen::Index>(1, values.rows()));
  values.col(column).setZero();
  if (power <= 0) return;
  for (Eigen::Index f = half; f + half < values.rows(); ++f)
    values(f, column) = (values(f - half, speed_x) * values(f + half, speed_y) -
                         values(f + half, speed_x) * values(f - half, speed_y)) /
                        power;
}

constexpr int shared_channels = 8;
constexpr int side_channels = 25;
constexpr int rate_channels = 3;

}  // namespace

MotionChannels motion_channels(const CoupleMotion& motion, const CoupleGeometry& geometry, bool b_is_active) {
  MotionChannels channels;
  channels.fps = motion.fps;
  channels.orb = geometry.orb;
  const auto &x = b_is_active ? motion.b : motion.a, &y = b_is_active ? motion.a : motion.b;
  const auto &heading_x = b_is_active ? geometry.heading_b : geometry.heading_a,
             &heading_y = b_is_active ? geometry.heading_a : geometry.heading_b;
  for (int f = 0; f < motion.size(); ++f) {
    channels.n_x.push_back(b_is_active ? geometry.n_b(f) : geometry.n_a(f));
    channels.n_y.push_back(b_is_active ? geometry.n_a(f) : geometry.n_b(f));
  }
  const int reach = std::max(1, static_cast<int>(std::lround(speed_window_s / 2 * motion.fps)));
  channels.values.resize(motion.size(),
                         shared_channels + 2 * side_channels + rate_channels + lead_channel_count);
  for (int f = 0; f < motion.size(); ++f) {
    const auto i = static_cast<std::size_t>(f);
    Row row(channels.values.row(f));
    row << std::min(longest_reach_m, level_norm(joint_at(x[i], joints::Root) - joint_at(y[i], joints::Root)));
    row << std::abs(std::remainder(heading_x[i] - heading_y[i], 1.0));
    double nearest = far_m;
    for (const HandPair hands : hand_pairs) {
      const double apart = std::min(far_m, hand_distance(x[i], y[i], hands));
      nearest = std::min(nearest, apart);
      row << apart;
    }
    row << nearest;
    row << std::min(longest_reach_m, (joint_at(x[i], joints::Head) - joint_at(y[i], joints::Head)).norm());
    // n = heading - orb is 0 for the performer at whom the line begins when facing the other, 1/2 for the
    // other.
    const double face_x = std::remainder(channels.n_x[i] - (b_is_active ? 0.5 : 0), 1.0);
    const double face_y = std::remainder(channels.n_y[i] - (b_is_active ? 0 : 0.5), 1.0);
    add_side(row, {x, y, heading_x}, f, reach, motion.fps, face_x);
    add_side(row, {y, x, heading_y}, f, reach, motion.fps, face_y);
    const auto rate = [&](const std::vector<double>& turns) {
      const int from = std::max(0, f - reach), to = std::min(motion.size() - 1, f + reach);
      return to == from ? 0.0
                        : (turns[static_cast<std::size_t>(to)] - turns[static_cast<std::size_t>(from)]) *
                              motion.fps / (to - from);
    };
    row << rate(channels.n_x);
    row << rate(channels.n_y);
    row << rate(channels.orb);
    if (row.next() + lead_channel_count != channels.count())
      throw std::logic_error("channels are counted wrongly: " + std::to_string(row.next()));
  }
  // Positions of speeds within a side, as `add_side` writes them.
  constexpr int left_hand_speed = 6, root_speed = 23, head_speed = 24;
  constexpr int side_x = shared_channels, side_y = shared_channels + side_channels;
  int column = channels.count() - lead_channel_count;
  for (const int of : {left_hand_speed, root_speed, head_speed})
    add_lead(channels, column++, side_x + of, side_y + of);
  return channels;
}

}  // namespace abrazo
