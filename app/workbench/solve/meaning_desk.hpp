#pragma once

#include <QObject>
#include <QTimer>

#include "widgets/meaning/meaning_choice.hpp"

class QToolButton;

namespace abrazo::widgets {
class MeaningPopup;
struct Palette;
}  // namespace abrazo::widgets

namespace abrazo::app {

class MainWindow;

/// "I mean this move": what can be meant, what is meant, and when that is over.
class MeaningDesk : public QObject {
  Q_OBJECT
 public:
  explicit MeaningDesk(MainWindow& window);

  /// Takes back what is meant; where nothing is, offers what can be.
  void toggle();
  void offer();
  void takeBack();
  widgets::MeaningPopup& popup() { return *m_popup; }
  QToolButton& chip() { return *m_chip; }

 private:
  std::vector<widgets::MeaningChoice> choices() const;
  void mean(const widgets::MeaningChoice& choice, widgets::MeaningSpan span);
  void refreshDistances();
  void onPanels();
  void showChip();

  MainWindow& m_window;
  widgets::MeaningPopup* m_popup;
  QToolButton* m_chip;
  QTimer m_refresh;
  double m_since_s = 0;  ///< session clock; when it was said
};

}  // namespace abrazo::app
