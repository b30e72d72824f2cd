#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

class QLabel;
class QLineEdit;

namespace abrazo::widgets {

class ValueSlider;

/// A whole number with a title, to drag or type; a double click restores the default.
class NumberRow : public QWidget {
  Q_OBJECT
 public:
  struct Range {
    int least = 0, most = 100, usual = 0;
    int step = 1;  ///< of the arrow keys
  };
  NumberRow(const QString& title, const QString& unit, Range range, QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setNumber(int number);
  int number() const { return m_number; }

 signals:
  void changed(int number);

 private:
  void ask(int number);
  void take();

  QString m_unit;
  Range m_range;
  int m_number;
  QLabel* m_title;
  QLineEdit* m_field;
  ValueSlider* m_slider;
};

}  // namespace abrazo::widgets
