#pragma once

#include <QString>

#include "core/bodies/take_retargeting.hpp"

namespace abrazo::app {

/// The bodies of a retargeted take and how well they keep its relations, as a part of a sentence.
inline QString outcome_of(const RetargetedTake& take) {
  return QString("leader %1 (%2 m), follower %3 (%4 m); %5")
      .arg(QString::fromStdString(take.active_body))
      .arg(take.active_height_m, 0, 'f', 2)
      .arg(QString::fromStdString(take.passive_body))
      .arg(take.passive_height_m, 0, 'f', 2)
      .arg(QString::fromStdString(take.quality_text()).replace('\n', ". "));
}

}  // namespace abrazo::app
