#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

class QToolButton;

namespace abrazo::widgets {

class TabularLabel;

/// Bar below the picture: its index, previous, next, and the switch to follow the timeline.
class StepBar : public QWidget {
  Q_OBJECT
 public:
  explicit StepBar(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// @param index -1 = none
  void showPicture(int index, int pictures, double time_s);
  void setLinked(bool linked);
  bool isLinked() const;
  void setUsable(bool on);
  QString text() const;

 signals:
  void stepRequested(int pictures);
  void linkRequested(bool linked);

 private:
  QToolButton* makeStep(const QString& name, int pictures);

  QToolButton *m_back, *m_on, *m_link;
  TabularLabel *m_time, *m_picture;
};

}  // namespace abrazo::widgets
