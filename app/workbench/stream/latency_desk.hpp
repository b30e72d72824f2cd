#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "app/workbench/stream/latency_log.hpp"

namespace abrazo::widgets {
class LatencyButton;
class LatencyPlot;
class LatencyTable;
}  // namespace abrazo::widgets

namespace abrazo::app {

class MainWindow;
class StreamDesk;

/// The latency of the shown frame and the seconds before it: a figure in the status bar, and a panel with the
/// breakdown. Works for recorded and live frames.
class LatencyDesk : public QObject {
  Q_OBJECT
 public:
  LatencyDesk(MainWindow& window, const StreamDesk& stream);
  const LatencyLog& log() const { return m_log; }

 private:
  void makePanel();
  void refresh();
  void pictureDrawn(const abrazo::FrameSnapshotPtr& frame, double took_ms);
  bool isPanelSeen() const;

  MainWindow& m_window;
  const StreamDesk& m_stream;
  LatencyLog m_log;
  QElapsedTimer m_sinceRefresh;
  widgets::LatencyButton* m_button;
  widgets::LatencyTable* m_table = nullptr;
  widgets::LatencyPlot* m_plot = nullptr;
};

}  // namespace abrazo::app
