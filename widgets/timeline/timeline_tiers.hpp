#pragma once

#include <QPointF>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "widgets/timeline/tier_drag.hpp"

class QPainter;

namespace abrazo::widgets {

/// Something that is being said while the cursor goes on: from here to the cursor.
struct RunningLabel {
  int tier = 0;
  double from_s = 0;
  std::string value;

  bool operator==(const RunningLabel&) const = default;
};

/// Lanes of tiers: what they show, and what of it is chosen.
struct TimelineTiers {
  Annotations annotations;
  int active_tier = 0;
  int selected = 0;    ///< annotation
  int suggestion = 0;  ///< that a person looks at
  TierRules rules;
  std::vector<RunningLabel> running;
  std::optional<TierDrag> drag;
  TierDrag::Outcome dragged;  ///< while there is a drag

  const Annotations& shown() const { return drag && dragged.moved ? dragged.annotations : annotations; }
};

struct TimelineContent;

void paint_tier_names(QPainter& painter, const TimelineContent& content);
void paint_tiers(QPainter& painter, const TimelineContent& content);
/// What is being said while the cursor goes on.
void paint_running_labels(QPainter& painter, const TimelineContent& content);

/// The facts at a place in the lane of a tier, as rich text.
QString tier_facts(const TimelineContent& content, const QPointF& place);

}  // namespace abrazo::widgets
