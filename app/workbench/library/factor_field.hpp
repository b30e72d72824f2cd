#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

class QLabel;

namespace abrazo::widgets {
class ValueSlider;
}

namespace abrazo::app {

/// A factor from 0 to `greatest` on a slider, 1 in the middle.
class FactorField : public QWidget {
  Q_OBJECT
 public:
  /// @param greatest  more than 1
  FactorField(const QString& name, double greatest, QWidget* parent);
  void setColours(const widgets::Palette& palette);
  double factor() const { return m_factor; }

 signals:
  void changed();

 private:
  void slideTo(double place);

  double m_bend;  ///< factor = greatest * place^bend
  double m_greatest;
  double m_factor = 1;
  widgets::ValueSlider* m_slider;
  QLabel* m_number;
};

}  // namespace abrazo::app
