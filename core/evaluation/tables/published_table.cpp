#include "core/evaluation/tables/published_table.hpp"

#include <array>
#include <cmath>

#include "core/base/statistics.hpp"
#include "core/evaluation/takes/pose_queries.hpp"
#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/library/store/pose_index.hpp"
#include "core/metrics/published.hpp"
#include "core/motion/body/resample.hpp"

namespace abrazo {

namespace {

using enum PublishedRow::Better;

constexpr std::array published_row_table = {
    PublishedRow{"mpjpe_m", "MPJPE", "mm", 1000, &PublishedFigures::mpjpe_m},
    PublishedRow{"mpjve_m", "MPJVE, per frame", "mm", 1000, &PublishedFigures::mpjve_m},
    PublishedRow{"foot_sliding_m", "foot sliding, per frame", "cm", 100, &PublishedFigures::foot_sliding_m,
                 AsRecorded},
    PublishedRow{"skating_share", "skating frames", "%", 100, &PublishedFigures::skating_share},
    PublishedRow{"jitter_10_m_s3", "jitter", "10 m/s\u00b3", 1, &PublishedFigures::jitter_10_m_s3,
                 AsRecorded},
    PublishedRow{"penetration_share", "frames with penetration", "%", 100,
                 &PublishedFigures::penetration_share},
    PublishedRow{"penetration_depth_m", "depth of penetration, mean", "mm", 1000,
                 &PublishedFigures::penetration_depth_m},
    PublishedRow{"contact_precision", "contact, precision", "%", 100, &PublishedFigures::contact_precision,
                 Higher},
    PublishedRow{"contact_recall", "contact, recall", "%", 100, &PublishedFigures::contact_recall, Higher},
    PublishedRow{"contact_f1", "contact, F1", "%", 100, &PublishedFigures::contact_f1, Higher},
    PublishedRow{"turned_away_share", "frames turned away", "%", 100, &PublishedFigures::turned_away_share,
                 AsRecorded},
    PublishedRow{"beat_echo_degree", "beat echo degree", "", 1, &PublishedFigures::beat_echo_degree, Higher},
    PublishedRow{"fid_cd", "FID of cross-distances", "", 1, &PublishedFigures::fid_cd},
    PublishedRow{"diversity", "diversity of cross-distances", "", 1, &PublishedFigures::diversity,
                 AsRecorded},
};

constexpr double published_clip_s = 2;

/// Poses of the steps at 30 Hz.
std::vector<Pose> at_published_rate(const SynthesisedTake& take, const std::vector<Pose>& steps) {
  std::vector<StampedPose> stamped;
  for (std::size_t step = 0; step < steps.size(); ++step)
    stamped.push_back({take.times_s[step], steps[step]});
  return resample(stamped, published_rate_hz).poses;
}

/// The recorded partner of the nearest pose, in every step, where the user is.
Result<std::vector<Pose>> nearest_partners(const SynthesisedTake& take, const MotionLibrary& library,
                                           bool both_roles) {
  const auto queries = PoseQueries(library, take.user_role, both_roles).of(*take.take, take.frames);
  if (!queries) return queries.error();
  const std::vector<int> pairs = pairs_without(library, take.of_library ? take.take->name : std::string(), 0);
  const PoseIndex index = pose_index_of(library, pairs);
  std::vector<Pose> partners;
  std::vector<PoseMatch> matches;
  for (const SelectionQuery& query : *queries) {
    index.nearest(query.features, 1, matches);
    partners.emplace_back(library.pair_in_world(matches.front().pair, query.root).bottomRows<joint_count>());
  }
  return partners;
}

void append_clips(const Duet& duet, std::vector<CrossDistances>& clips) {
  constexpr auto length = static_cast<std::size_t>(published_clip_s * published_rate_hz);
  const auto part = [](const std::vector<Pose>& poses, std::size_t from) {
    const auto begin = poses.begin() + static_cast<std::ptrdiff_t>(from);
    return std::vector<Pose>(begin, begin + static_cast<std::ptrdiff_t>(length));
  };
  for (std::size_t from = 0; from + length <= duet.user.size(); from += length)
    clips.push_back(cross_distances({part(duet.user, from), part(duet.partner, from)}));
}

Eigen::MatrixXd rows_of(const std::vector<CrossDistances>& clips) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(clips.size()), CrossDistances::RowsAtCompileTime);
  for (std::size_t c = 0; c < clips.size(); ++c)
    rows.row(static_cast<Eigen::Index>(c)) = clips[c].transpose();
  return rows;
}

/// One way to answer the users of all takes.
class PublishedMeasure {
 public:
  void add(const Duet& made, const Duet& captured) {
    PublishedFigures& take = takes_.emplace_back();
    take.mpjpe_m = mpjpe_m(made.partner, captured.partner);
    take.mpjve_m = mpjve_m(made.partner, captured.partner);
    take.foot_sliding_m = foot_sliding_m(made.partner);
    take.skating_share = abrazo::skating_share(made.partner);
    take.jitter_10_m_s3 = abrazo::jitter_10_m_s3(made.partner);
    const JointPenetration penetration = joint_penetration(made);
    take.penetration_share = penetration.share, take.penetration_depth_m = penetration.mean_depth_m;
    take.turned_away_share = abrazo::turned_away_share(made);
    take.beat_echo_degree = abrazo::beat_echo_degree(motion_beats(made.user), motion_beats(made.partner));
    contacts_.add(joint_contacts(made, captured));
    append_clips(made, clips_);
  }
  int clips() const { return static_cast<int>(clips_.size()); }

  PublishedFigures figures(const PublishedMeasure& captured) const {
    PublishedFigures all;
    for (const PublishedRow& row : published_rows()) {
      std::vector<double> values;
      for (const PublishedFigures& take : takes_)
        if (!std::isnan(take.*row.figure)) values.push_back(take.*row.figure);
      all.*row.figure = values.empty() ? quantile(values, 1) : mean(values);
    }
    all.contact_precision = contacts_.precision();
    all.contact_recall = contacts_.recall();
    all.contact_f1 = contacts_.f1();
    const Eigen::MatrixXd reference = rows_of(captured.clips_);
    const Eigen::MatrixXd own = z_scored(rows_of(clips_), reference);
    all.fid_cd = frechet_distance(own, z_scored(reference, reference));
    all.diversity = abrazo::diversity(own);
    return all;
  }

 private:
  std::vector<PublishedFigures> takes_;
  ContactCounts contacts_;
  std::vector<CrossDistances> clips_;
};

}  // namespace

std::span<const PublishedRow> published_rows() {
  return published_row_table;
}

Result<PublishedTable> measure_published(std::span<const SynthesisedTake> takes,
                                         const std::shared_ptr<const MotionLibrary>& library,
                                         bool both_roles) {
  if (takes.empty()) return PublishedTable{};
  const auto as_searched = library_for(library, takes.front().user_role);
  PublishedMeasure made, nearest, captured;
  for (const SynthesisedTake& take : takes) {
    std::vector<Pose> users, captured_partners, made_partners;
    for (std::size_t step = 0; step < take.size(); ++step) {
      users.push_back(take.true_user(step));
      captured_partners.push_back(take.true_partner(step));
      made_partners.push_back(take.partner(step));
    }
    const auto nearest_steps = nearest_partners(take, *as_searched, both_roles);
    if (!nearest_steps) return nearest_steps.error();
    const std::vector<Pose> user = at_published_rate(take, users);
    const Duet as_captured{user, at_published_rate(take, captured_partners)};
    made.add({user, at_published_rate(take, made_partners)}, as_captured);
    nearest.add({user, at_published_rate(take, *nearest_steps)}, as_captured);
    captured.add(as_captured, as_captured);
  }
  return PublishedTable{.made = made.figures(captured),
                        .nearest = nearest.figures(captured),
                        .captured = captured.figures(captured),
                        .clips = captured.clips()};
}

}  // namespace abrazo
