#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The seconds until a take begins, large enough to be read across a studio; over another widget, in its
/// middle. Never takes the pointer.
class Countdown : public QWidget {
  Q_OBJECT
 public:
  /// @param over  it covers the middle of this widget, of which it becomes a child
  explicit Countdown(QWidget* over);
  void setColours(const Palette& palette);
  /// 0 hides it. @param take  what will be recorded
  void showCount(int seconds, const QString& take);
  int count() const { return m_count; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Palette m_palette;
  int m_count = 0;
  QString m_take;
};

}  // namespace abrazo::widgets
