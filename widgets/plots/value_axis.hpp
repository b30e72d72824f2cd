#pragma once

#include "widgets/common/value_range.hpp"

namespace abrazo::widgets {

/// The value axis of all panes of one quantity, so that their curves can be compared. All of them are read
/// before the first is drawn.
class ValueAxis {
 public:
  /// What the values of a pane that was read need above and below 0, and how far the axis reaches at least.
  void include(double above, double below, double least_reach);
  /// Takes what was included. The scale shrinks only after values were smaller for a while, so that the
  /// numbers stay readable.
  void settle(double time_s);
  void forget();

  double lower() const { return m_needs.below > 0 ? -m_below.upper() : 0; }
  double upper() const;

 private:
  struct Needs {
    double above = 0, below = 0, least_reach = 0;
  };
  Needs m_needs;
  bool m_isSettled = true;
  SteadyRange m_above, m_below;
};

}  // namespace abrazo::widgets
