#pragma once

#include <QWidget>
#include <memory>

#include "core/library/motion_library.hpp"
#include "core/session/frame_history.hpp"
#include "core/session/playback.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/timeline/timeline_axis.hpp"
#include "widgets/timeline/timeline_tracks.hpp"

namespace abrazo::widgets {

/// The lanes below the transport: ruler, sources, moves, cost; one white cursor through all. Does not move
/// the cursor itself: it asks, and waits to be shown the playback that answers.
class TimelineView : public QWidget {
  Q_OBJECT
 public:
  explicit TimelineView(QWidget* parent = nullptr);
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);
  const TimelineAxis& axis() const { return m_axis; }
  const TimelineTracks& tracks() const { return m_tracks; }
  QSize sizeHint() const override { return {800, 150}; }

 public slots:
  /// Takes what is new in the history and moves the cursor.
  void refresh(const abrazo::FrameHistory& history, const abrazo::Playback& playback);

 signals:
  void seekRequested(double time_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void take(const FrameSnapshot& frame);
  void paintRuler(QPainter& painter) const;
  void paintSources(QPainter& painter) const;
  void paintMoves(QPainter& painter) const;
  void paintCost(QPainter& painter) const;
  void paintEvicted(QPainter& painter) const;
  void paintCursor(QPainter& painter) const;
  QRectF laneRect(int lane) const;
  QRectF block(const TimelineTracks::Interval& interval, int lane) const;

  Palette m_palette;
  std::shared_ptr<const MotionLibrary> m_library;
  TimelineAxis m_axis;
  TimelineTracks m_tracks;
  Playback m_playback;
  std::uint64_t m_nextIndex = 0;
  bool m_scrubbing = false;
};

}  // namespace abrazo::widgets
