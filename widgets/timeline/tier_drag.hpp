#pragma once

#include <optional>
#include <string>

#include "widgets/timeline/tier_hit.hpp"

namespace abrazo::widgets {

/// Rules of a drag in the lanes of tiers.
struct TierRules {
  Conflict conflict = Conflict::Replace;
  Annotations::Range range;
  double fps = 0;  ///< 0 = no frame grid

  bool operator==(const TierRules&) const = default;
};

/// A drag in the lane of a tier, from press to release: computes the resulting annotations. Independent of
/// Qt; nothing changes before the release.
class TierDrag {
 public:
  enum class Kind { Draw, Move, Start, End, Between };

  struct Outcome {
    Annotations annotations;          ///< result; unchanged for Draw
    double from_s = 0, to_s = 0;      ///< of the dragged item
    std::optional<double> snapped_s;  ///< at an edge, marker or the cursor; not at a frame
    std::string refused;              ///< reason of a refusal; empty if valid
    bool moved = false;
  };

  /// @param draws_anew draws even over existing annotations
  TierDrag(const Annotations& annotations, const TierHit& hit, double pressed_s, const TierRules& rules,
           bool draws_anew);

  Kind kind() const { return kind_; }
  int tier() const { return hit_.tier; }
  int annotation() const { return hit_.annotation; }
  /// @param targets without the dragged edges; @param reach_s 0 = frames only
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
  Annotation dragged_, next_;  ///< original state
};

/// Snap targets of edges: edges of all annotations except the dragged ones, and the frames nearest to
/// markers, in, out and cursor.
SnapTargets snap_targets(const Annotations& annotations, const TierHit& dragged, double fps, double cursor_s,
                         const std::vector<double>& markers_s);

}  // namespace abrazo::widgets
