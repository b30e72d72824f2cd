#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "core/base/positions.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

/// Frame rate of the literature on two people: both papers below and their data.
inline constexpr double published_rate_hz = 30;

/// Two people in the same frames, `published_rate_hz` apart, world, metres, Y up.
struct Duet {
  std::vector<Pose> user, partner;
};

// Figures from the literature on two people, as defined by the official code.
//
// Duolando: Siyao et al., ICLR 2024, github.com/lisiyao21/Duolando: utils/metrics_duet.py and
// utils/metric_footskating_dur.py.
//
// R2R: Cen et al., Ready-to-React, ICLR 2025, github.com/zju3dv/ready_to_react:
// reactmotion/runners/evaluators/reactive_mocon_evaluator.py.
//
// ReMoS: Ghosh et al., ECCV 2024, arXiv:2311.17057.
//
// SMPL-X joints are mapped to those of the 25 at the same place (foot: toe base, head: upper neck).

/// MPJPE (ReMoS; mean over joints and frames) of a reaction against the captured one [m], in world space.
/// @param made, captured of equal length; NaN if empty
double mpjpe_m(std::span<const Pose> made, std::span<const Pose> captured);

/// MPJVE (ReMoS; Pavllo et al., CVPR 2019, github.com/facebookresearch/VideoPose3D, common/loss.py): the same
/// for the displacement of joints between frames [m per frame]. NaN below two frames.
double mpjve_m(std::span<const Pose> made, std::span<const Pose> captured);

/// Foot sliding (R2R, `compute_foot_slide`): mean displacement between frames of toe bases that are less than
/// 5 cm above the lowest of the clip [m]. As in R2R, the first frame counts with 0, and vertical movement
/// counts.
double foot_sliding_m(std::span<const Pose> poses);

/// Skating (Duolando, `detect_footskating_dur`): share of the frames, without the first two, in which the
/// pelvis moves more than 3 cm horizontally while both ankles move less than 1 cm relative to it.
double skating_share(std::span<const Pose> poses);

/// Jitter (R2R, `compute_jitter`): mean norm of the third time derivative of the joints (third difference),
/// divided by 10 [10 m/s^3]. NaN below four frames.
double jitter_10_m_s3(std::span<const Pose> poses);

/// Penetration (Duolando, `cross_penetration`): share of the frames in which two joints, one of each person,
/// are nearer than 1 cm. The depth (our definition): mean over all frames of max(0, 1 cm - smallest
/// distance).
struct JointPenetration {
  double share = 0, mean_depth_m = 0;
};
JointPenetration joint_penetration(const Duet& duet);

/// Contacts: pairs of the ten joints below, one of each person, nearer than 0.25 m; the captured duet is the
/// ground truth. Counts over all frames, so that takes can be added.
struct ContactCounts {
  long long both = 0, only_made = 0, only_captured = 0;

  void add(const ContactCounts& other);
  double precision() const;  ///< NaN if there is no contact
  double recall() const;
  double f1() const;  ///< harmonic mean; 0 if both are 0
};
ContactCounts joint_contacts(const Duet& made, const Duet& captured);

/// Orientation (R2R, `compute_twoagent_rootrot`): share of the frames in which the partner's heading differs
/// by more than 45 degrees from the opposite of the user's heading.
double turned_away_share(const Duet& duet);

/// Beats of a dance (Duolando, `calc_db`): frames of which the mean speed of the joints, smoothed by a
/// Gaussian of 5 frames (cut off at 20, mirrored at the ends), is less than in both neighbours.
std::vector<int> motion_beats(std::span<const Pose> poses);

/// Beat echo degree (Duolando, `BA`): mean over the leader's beats of exp(-d^2 / 18), d = frames to the
/// follower's nearest beat; NaN if the leader has none.
double beat_echo_degree(std::span<const int> leader, std::span<const int> follower);

/// Pelvis, ankles, toe bases, head, shoulders, wrists: the joints of Duolando's cross-distances.
inline constexpr std::array<int, 10> cross_joints = {
    joints::Root,           joints::left_ankle, joints::right_ankle,   joints::left_toe_base,
    joints::right_toe_base, joints::UpperNeck,  joints::left_shoulder, joints::right_shoulder,
    joints::left_wrist,     joints::right_wrist};

/// The 100 distances of the partner's joints (rows) from the user's, mean over a clip (Duolando,
/// `duet_feature`) [m].
using CrossDistances = Eigen::Matrix<double, 100, 1>;
CrossDistances cross_distances(const Duet& clip);

/// Clips x features, each feature minus its mean over `reference`, divided by its (population) standard
/// deviation there (Duolando, `normalize`).
Eigen::MatrixXd z_scored(const Eigen::MatrixXd& features, const Eigen::MatrixXd& reference);

/// Frechet distance of the normal distributions with the means and (sample) covariances of two sets of
/// features (Duolando, `calc_fid`; Heusel et al. 2017): |m1 - m2|^2 + tr(C1 + C2 - 2 (C1 C2)^1/2). NaN below
/// two rows.
double frechet_distance(const Eigen::MatrixXd& first, const Eigen::MatrixXd& second);

/// Diversity (Duolando, `calculate_avg_distance`): mean distance of two rows. NaN below two rows.
double diversity(const Eigen::MatrixXd& features);

}  // namespace abrazo
