#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The seconds until a take begins, readable across a studio, over the middle of another widget. Ignores the
/// pointer.
class Countdown : public QWidget {
  Q_OBJECT
 public:
  /// @param over parent widget, whose middle it covers
  explicit Countdown(QWidget* over);
  void setColours(const Palette& palette);
  /// 0 hides it. @param take name of the take
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
