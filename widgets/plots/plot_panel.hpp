#pragma once

#include <QWidget>
#include <memory>

#include "core/session/frame_history.hpp"
#include "core/session/playback.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// Energies and constraint residuals over the last while, with the time cursor. A click asks to go there.
class PlotPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PlotPanel(QWidget* parent = nullptr);
  ~PlotPanel() override;
  void setColours(const Palette& palette);
  void clear();
  /// Where a time is in the first pane, in pixels of this widget; for tests.
  double cursorX() const;

 public slots:
  /// Takes what is new in the history, moves the window and the cursor, and draws.
  void refresh(const abrazo::FrameHistory& history, const abrazo::Playback& playback,
               const abrazo::FrameSnapshotPtr& shown);

 signals:
  void seekRequested(double time_s);

 private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

}  // namespace abrazo::widgets
