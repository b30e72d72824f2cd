#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/base/result.hpp"

namespace abrazo {

class MotionLibrary;
struct SynthesisedTake;

/// Figures of the literature on two people (core/metrics/published.hpp) of one way to answer the user. NaN
/// if there was nothing to measure.
struct PublishedFigures {
  double mpjpe_m = 0, mpjve_m = 0;
  double foot_sliding_m = 0, skating_share = 0, jitter_10_m_s3 = 0;
  double penetration_share = 0, penetration_depth_m = 0;
  double contact_precision = 0, contact_recall = 0, contact_f1 = 0;
  double turned_away_share = 0;
  double beat_echo_degree = 0;
  double fid_cd = 0, diversity = 0;
};

/// How a figure is written: a row in report.html, an entry under "published" in report.json.
struct PublishedRow {
  enum class Better { Lower, Higher, AsRecorded };
  std::string_view key, title, unit;
  double scale = 1;  ///< shown = scale times the value
  double PublishedFigures::*figure = nullptr;
  Better better = Better::Lower;
};
std::span<const PublishedRow> published_rows();

/// The synthesised partner and two baselines: the recorded partner of the nearest pose, unedited, and the
/// recording itself.
struct PublishedTable {
  PublishedFigures made, nearest, captured;
  int clips = 0;  ///< number of clips for the cross-distances
};

/// Every take is brought to 30 Hz, and the partner is measured with the user as captured. Figures are means
/// over the takes with equal weights, except contacts, which are counted over all frames, and fid_cd and
/// diversity, which are of all clips of 2 s without overlap, z-scored by the recorded ones.
/// @param library  that answered the takes; a take of its own is left out for the nearest pose as well
Result<PublishedTable> measure_published(std::span<const SynthesisedTake> takes,
                                         const std::shared_ptr<const MotionLibrary>& library,
                                         bool both_roles);

}  // namespace abrazo
