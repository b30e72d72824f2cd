#pragma once

#include <QObject>
#include <QTimer>

#include "widgets/intended/intended_move_choice.hpp"

class QToolButton;

namespace abrazo::widgets {
class IntendedMovePopup;
struct Palette;
}  // namespace abrazo::widgets

namespace abrazo::app {

class MainWindow;

/// Handles the intended move: available choices, declaration, and its end.
class IntendedMoveDesk : public QObject {
  Q_OBJECT
 public:
  explicit IntendedMoveDesk(MainWindow& window);

  /// Cancels the intended move; without one, offers the choices.
  void toggle();
  void offer();
  void takeBack();
  widgets::IntendedMovePopup& popup() { return *m_popup; }
  QToolButton& chip() { return *m_chip; }

 private:
  std::vector<widgets::IntendedMoveChoice> choices() const;
  void declare(const widgets::IntendedMoveChoice& choice, widgets::IntendedMoveSpan span);
  void refreshDistances();
  void onPanels();
  void showChip();

  MainWindow& m_window;
  widgets::IntendedMovePopup* m_popup;
  QToolButton* m_chip;
  QTimer m_refresh;
  double m_since_s = 0;  ///< session clock; time of the declaration
};

}  // namespace abrazo::app
