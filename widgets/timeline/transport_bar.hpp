#pragma once

#include <QWidget>

#include "core/session/playback.hpp"
#include "widgets/common/palette.hpp"

class QLabel;
class QPushButton;
class QToolButton;

namespace abrazo::widgets {

class TabularLabel;

/// "00:11.500"; hours only when there are any.
QString clock_text(double time_s);

/// Play, step, time, state, speed, loop. Asks; shows what it is told.
class TransportBar : public QWidget {
  Q_OBJECT
 public:
  explicit TransportBar(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setInput(const QString& text);
  QString stateText() const;

 public slots:
  /// @param frame  index of the shown frame; -1 when there is none
  void showPlayback(const abrazo::Playback& playback, long long frame);

 signals:
  void toggleRequested();
  void stepRequested(int frames);
  void startRequested();
  void followRequested();
  void speedRequested(double factor);
  void loopRequested(bool on);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QToolButton* button(const QString& tip);
  void dress();
  void makeRoom();

  Palette m_palette;
  Playback m_shown;
  QToolButton *m_start, *m_back, *m_play, *m_forward, *m_end, *m_speed, *m_loop;
  TabularLabel *m_time, *m_frame, *m_state;
  QPushButton* m_live;
  QLabel* m_input;
};

}  // namespace abrazo::widgets
