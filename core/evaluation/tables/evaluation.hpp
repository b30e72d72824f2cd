#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/evaluation/tables/body_table.hpp"
#include "core/evaluation/tables/movement_table.hpp"
#include "core/evaluation/tables/published_table.hpp"
#include "core/metrics/continuity.hpp"
#include "core/metrics/holds.hpp"
#include "core/metrics/penetration.hpp"
#include "core/metrics/zmp.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// Table I: how often the search in the 15-D features (M_A) finds the result of a comparison of whole poses
/// with every pair (M_B, pose term of Eq. 7).
struct SelectionRow {
  int k = 0;
  double recall_best = 0;   ///< the best pair is among the k
  double recall_best2 = 0;  ///< one of the best two is
  double pose_excess = 0;  ///< rms joint distance of the best among the k over that of the best pair, minus 1
  double query_us = 0;     ///< search and Eq. 7 over the k, median
};

struct SelectionTable {
  double rate_hz = 0;  ///< of the library searched
  int pairs = 0;
  int queries = 0;
  std::vector<SelectionRow> rows;  ///< ascending k
};

/// Table II: time of one selection against the size of the library.
struct TimingRow {
  int pairs = 0;
  int generated = 0;    ///< of them, added because the takes have fewer
  double knn_us = 0;    ///< 10 nearest neighbours and Eq. 7 over them, median
  double brute_us = 0;  ///< Eq. 7 over all pairs, median
};

/// Moves of one label or take.
struct MoveCount {
  int total = 0;
  int successful = 0;
  int lenient = 0;  ///< successful by the label or by an alternative of the annotator
  double rate() const { return total > 0 ? static_cast<double>(successful) / total : 0; }
  double lenient_rate() const { return total > 0 ? static_cast<double>(lenient) / total : 0; }
};

/// Table III: a move counts as successful when most of its synthesised steps come from pairs with its own
/// label.
struct MoveTable {
  MoveCount all;
  std::map<std::string, MoveCount> per_take, per_label;
  std::vector<std::string> labels;          ///< rows and columns of the matrices
  std::vector<std::vector<int>> confusion;  ///< moves: [own label][label of most of its steps]
  std::vector<std::vector<int>> steps;      ///< the same counted by steps
  double step_accuracy = 0;                 ///< steps within moves whose source has the move's label
  double by_chance = 0;  ///< success if every move were answered with the library's most frequent label
};

/// Table IV. Mean distance of the ZMP from the support polygon [m].
struct ZmpTable {
  double original_m = 0, synthesised_m = 0;  ///< both bodies
  double original_partner_m = 0, synthesised_partner_m = 0;
  int frames = 0, skipped_frames = 0;  ///< body frames of the synthesis
  int original_skipped_frames = 0;
  /// The partner in stretches without a change of source, and the captured partner in the same steps: without
  /// the effect of jumps between recorded pairs.
  double partner_between_changes_m = 0, original_between_changes_m = 0;
  double between_changes_share = 0;  ///< of the steps
  /// Captured and synthesised over the body frames that count in both.
  CommonZmp common, common_partner;
  /// Frames of the partner that are left out: too little presses on the floor, no foot is near it.
  int partner_free_fall = 0, original_partner_free_fall = 0;
  int partner_no_support = 0, original_partner_no_support = 0;
  int partner_frames = 0, original_partner_frames = 0;  ///< that count
  ZmpSettings settings;                                 ///< as measured
};

struct ContactTable {
  HoldMetric::Figures holds;
  PenetrationMetric::Figures penetration, original_penetration;
  double original_foot_slide_m_s = 0, foot_slide_m_s = 0;  ///< of the partner's landed toe-bases
  double user_foot_slide_m_s = 0;
  double bone_length_max = 0;  ///< relative
  double foot_lock_drift_max_m = 0;
};

struct PartnerTable {
  double mean_joint_error_m = 0, median_joint_error_m = 0, p95_joint_error_m = 0;
  double lag_s = 0, lag_correlation = 0;
  double behind_selected_mean_m = 0;  ///< partner joints from those of the selected pair
  ContinuityMetric::Figures continuity, original_continuity;
};

struct SolveTimes {
  double p50_us = 0, p95_us = 0, p99_us = 0;
  int steps = 0, relaxed = 0, failed = 0;
};

/// Results of one kind of user over all takes.
struct UserResult {
  std::string user;  ///< "as captured", "body at 85 %", "10 % of the frames lost", ...
  MoveTable moves;
  ZmpTable zmp;
  ContactTable contact;
  PartnerTable partner;
  MovementTable movement;
  SolveTimes solve;
  std::optional<PublishedTable> published;  ///< if requested; only for the takes as captured
};

/// All results of an evaluation; parts that were not requested are empty.
struct Evaluation {
  std::string data;   ///< name of the manifest
  std::string users;  ///< name of the users' manifest; empty when takes are left out one by one
  Settings settings;
  double step_rate_hz = 0;  ///< 0 when takes differ
  bool both_roles = false;
  int library_pairs = 0;
  std::vector<std::string> takes;         ///< that were answered
  double seconds = 0;                     ///< duration
  std::vector<SelectionTable> selection;  ///< full rate first, then thinned
  std::vector<TimingRow> timing;
  std::optional<UserResult> result;                              ///< takes as captured
  std::vector<UserResult> builds;                                ///< users of other builds
  std::vector<UserResult> disturbed;                             ///< frames lost, noise, delay
  bool has_moves = false, has_zmp = false, has_contact = false;  ///< requested parts of `result`
  std::optional<BodyTable> bodies;                               ///< recorded pairs on other bodies
  std::vector<std::string> remarks;  ///< what a reader must know: takes without labels, warnings
};

}  // namespace abrazo
