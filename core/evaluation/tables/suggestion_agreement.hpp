#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Agreement of one way to label a take with the labels of persons.
struct LabelAgreement {
  long frames = 0, agreed = 0, agreed_lenient = 0;
  int truths = 0, proposed = 0;
  int found = 0, found_lenient = 0;     ///< truths with a proposal of their label at IoU >= 0.5
  std::vector<double> boundary_errors;  ///< of the found ones' starts and ends [frames of the take]

  double frame_share() const;
  double lenient_frame_share() const;
  /// Harmonic mean of found / truths and found / proposed.
  double f1() const;
  double lenient_f1() const;
  void add(const LabelAgreement& other);
};

/// Labels of [start, end) frames against the truth. A frame without a true label does not count. Lenient:
/// the alternative label counts as well.
LabelAgreement label_agreement(const std::vector<LabelInterval>& truth,
                               const std::vector<LabelInterval>& proposed);

/// Suggestions for every labelled take of a library, each made from the other takes.
struct SuggestionAgreement {
  struct TakeResult {
    std::string take;
    LabelAgreement moves, majority, nearest_pose;
    long role_frames = 0, role_agreed = 0;
    int proposed_roles = 0, true_roles = 0;
  };
  std::vector<TakeResult> takes;
  /// Number of frames labelled `first` by a person and suggested as `second`.
  std::map<std::pair<std::string, std::string>, long> confusion;
  /// True moves of a label, found ones, and found ones including alternatives.
  struct LabelCount {
    int truths = 0, found = 0, found_lenient = 0, proposed = 0;
  };
  std::map<std::string, LabelCount> labels;
  /// Every suggestion: its confidence, and whether it was correct (label and IoU >= 0.5; role of most
  /// frames).
  struct Trial {
    double confidence = 0;
    bool right = false, right_lenient = false;
  };
  std::vector<Trial> move_trials, role_trials;

  LabelAgreement all(LabelAgreement TakeResult::*of) const;
  double role_share() const;
};

/// @return an Error when fewer than two takes have labels, or "cancelled"
Result<SuggestionAgreement> measure_suggestions(const MotionLibrary& library, const Progress& progress);

/// Confidences in ten steps: number of suggestions, mean confidence, share of correct ones.
struct ReliabilityBin {
  int count = 0;
  double mean_confidence = 0, right = 0, right_lenient = 0;  ///< shares
};
std::vector<ReliabilityBin> reliability(const std::vector<SuggestionAgreement::Trial>& trials, int bins);
/// Mean distance between confidence and share of correct ones, weighted by count (expected calibration
/// error).
double calibration_error(const std::vector<ReliabilityBin>& bins);

}  // namespace abrazo
