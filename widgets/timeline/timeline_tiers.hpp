#pragma once

#include <QPointF>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "widgets/timeline/tier_drag.hpp"

class QPainter;

namespace abrazo::widgets {

/// An open label while the cursor moves: from its start to the cursor.
struct RunningLabel {
  int tier = 0;
  double from_s = 0;
  std::string value;

  bool operator==(const RunningLabel&) const = default;
};

/// Content and selection of the lanes of tiers.
struct TimelineTiers {
  Annotations annotations;
  int active_tier = 0;
  int selected = 0;    ///< annotation
  int suggestion = 0;  ///< suggestion being viewed
  TierRules rules;
  std::vector<RunningLabel> running;
  std::optional<TierDrag> drag;
  TierDrag::Outcome dragged;  ///< valid during a drag

  const Annotations& shown() const { return drag && dragged.moved ? dragged.annotations : annotations; }
};

struct TimelineContent;

void paint_tier_names(QPainter& painter, const TimelineContent& content);
void paint_tiers(QPainter& painter, const TimelineContent& content);
/// Paints the open labels while the cursor moves.
void paint_running_labels(QPainter& painter, const TimelineContent& content);

/// Facts at a position in the lane of a tier, as rich text.
QString tier_facts(const TimelineContent& content, const QPointF& place);

}  // namespace abrazo::widgets
