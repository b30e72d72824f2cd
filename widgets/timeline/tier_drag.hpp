#pragma once

#include <optional>
#include <string>

#include "widgets/timeline/tier_hit.hpp"

namespace abrazo::widgets {

/// What a drag in the lanes of tiers may take notice of.
struct TierRules {
  Conflict conflict = Conflict::Replace;
  Annotations::Range range;
  double fps = 0;  ///< 0: there is no grid of frames

  bool operator==(const TierRules&) const = default;
};

/// A drag in the lane of a tier, from press to release: what the annotations would be. Plain arithmetic, no
/// toolkit; nothing is changed before it is let go.
class TierDrag {
 public:
  enum class Kind { Draw, Move, Start, End, Between };

  struct Outcome {
    Annotations annotations;          ///< as they would be; of Draw as they were
    double from_s = 0, to_s = 0;      ///< of what is dragged
    std::optional<double> snapped_s;  ///< at an edge, marker or the cursor; not at a frame
    std::string refused;              ///< why it cannot be; empty when it can
    bool moved = false;
  };

  /// @param draws_anew  also over what is there already
  TierDrag(const Annotations& annotations, const TierHit& hit, double pressed_s, const TierRules& rules,
           bool draws_anew);

  Kind kind() const { return kind_; }
  int tier() const { return hit_.tier; }
  int annotation() const { return hit_.annotation; }
  /// @param targets  without edges of its own; @param reach_s 0: to frames only
  Outcome to(double time_s, const SnapTargets& targets, double reach_s) const;
  /// "resize turn", "draw".
  std::string words() const;

 private:
  Outcome drawn(double time_s, const SnapTargets& targets, double reach_s) const;
  Outcome moved(double time_s, const SnapTargets& targets, double reach_s) const;
  Outcome resized(double time_s, const SnapTargets& targets, double reach_s) const;

  Annotations annotations_;
  TierHit hit_;
  double pressed_s_;
  TierRules rules_;
  Kind kind_;
  Annotation dragged_, next_;  ///< as they were
};

/// Where edges may snap: edges of all annotations but those that are dragged, and the frames nearest to
/// markers, in and out and the cursor.
SnapTargets snap_targets(const Annotations& annotations, const TierHit& dragged, double fps, double cursor_s,
                         const std::vector<double>& markers_s);

}  // namespace abrazo::widgets
