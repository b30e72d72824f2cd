#pragma once

#include <QObject>

namespace abrazo::widgets {

/// During its lifetime the wheel scrolls a list and never changes a choice or number in it: whatever comes
/// under the pointer while a person scrolls would get another value, unseen.
class WheelToScroll : public QObject {
 public:
  /// Requires an existing application.
  explicit WheelToScroll(QObject* parent = nullptr);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace abrazo::widgets
