#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "widgets/timeline/sample_curve.hpp"

namespace abrazo::widgets {

/// Who leads: by the annotation of the recording, else by the setting of the user's role.
enum class Leader { User, Partner };

/// Values of one frame for the lanes.
struct TrackRow {
  double time_s = 0;
  int pair = -1;           ///< of the library; -1 = none selected
  int take = -1;           ///< of that pair
  std::string_view label;  ///< its move; may be empty
  bool source_changed = false;
  Leader leader = Leader::User;
  double cost = 0;             ///< of the selected pair [m^2], of `intent` [m]
  double energy = 0;           ///< sum of the terms [m^2]
  bool user_is_active = true;  ///< the role the user was given, whoever leads
  double left_out_s = 0;       ///< time that frames took which were left out before it
  bool is_by_intent = false;   ///< the cost
};

/// What the lanes say of a pair.
struct PairFacts {
  int pair = -1;
  std::string_view label;
  Leader leader = Leader::User;
};

/// Content of the lanes of the timeline, updated frame by frame. Plain data, independent of Qt.
class TimelineTracks {
 public:
  struct Interval {
    double from_s = 0;
    double to_s = 0;
    int key = -1;  ///< take, index into labels(), Leader, or whether the user is active, whether `intent`
                   ///< decided; -1: nothing
  };
  using Lane = std::deque<Interval>;

  /// Rows come in ascending time.
  void append(const TrackRow& row);
  void drop_before(double time_s);
  /// Bounds the memory: curves as in SampleCurve; pairs of older frames are halved as often as needed. Lanes
  /// keep all their intervals.
  void thin_older(std::size_t newest, std::size_t most_older);
  /// The same rows with another library: all at once, from what is kept. Where pairs are thinned, moves and
  /// leaders change at the kept ones.
  /// @param takes  the new number of each take; -1 = gone
  /// @param facts  of a pair by its former number (-1 = none), and whether the user was active
  void renumber(const std::vector<int>& takes, const std::function<PairFacts(int, bool)>& facts);

  const Lane& sources() const { return sources_; }  ///< a jump within a take also begins an interval
  const Lane& moves() const { return moves_; }
  const Lane& leaders() const { return leaders_; }
  const Lane& user_roles() const { return user_roles_; }
  const SampleCurve& costs() const { return costs_; }
  bool is_by_intent_at(double time_s) const;  ///< the cost
  const SampleCurve& energies() const { return energies_; }
  const std::string& label(int key) const { return labels_[static_cast<std::size_t>(key)]; }

  /// Whether the curves end between two times: frames have a gap there, or nothing selected.
  bool has_gap_of_curves(double from_s, double to_s) const;
  /// Longer than any interval without a gap.
  double longest_gap_s() const;

  /// The pair selected in the frame shown at a time; -1 = none.
  int pair_at(double time_s) const;
  /// The last change of the sources' move before a time, or the next after it.
  std::optional<double> edge_before(double time_s) const;
  std::optional<double> edge_after(double time_s) const;

 private:
  struct Selection {
    double time_s = 0;
    int pair = -1;
  };
  static void extend(Lane& lane, double time_s, double gap_s, int key, bool begins = false);
  double pairs_apart_s() const;
  int label_key(std::string_view label);

  Lane sources_, moves_, leaders_, user_roles_, by_intent_;
  double left_out_s_ = 0;  ///< largest value
  SampleCurve costs_, energies_;
  std::deque<Selection> pairs_;  ///< of every frame; thinned for older ones
  std::size_t older_pairs_ = 0;
  int pairs_level_ = 0;  ///< number of halvings of older ones
  std::vector<std::string> labels_;
};

/// The interval of a lane at a time; null if there is none.
const TimelineTracks::Interval* interval_at(const TimelineTracks::Lane& lane, double time_s);

/// The intervals of a lane to draw in [from, to]; of those shorter than `least_s` only the first in each
/// `least_s`. The cost depends on the number of returned intervals only.
TimelineTracks::Lane drawn(const TimelineTracks::Lane& lane, double from_s, double to_s, double least_s);

/// The digits at the end of a take's name ("salsa_06" -> "06"), or the whole name.
std::string_view short_take_name(std::string_view name);

}  // namespace abrazo::widgets
