#pragma once

#include <QPixmap>
#include <QWidget>
#include <span>

#include "core/session/frames/frame_gaps.hpp"
#include "core/session/frames/frame_history.hpp"
#include "widgets/common/annotation_types.hpp"
#include "widgets/timeline/timeline_content.hpp"
#include "widgets/timeline/timeline_hit.hpp"

class QScrollBar;

Q_DECLARE_METATYPE(abrazo::Markers)

namespace abrazo::widgets {

/// The lanes below the transport, with one white cursor through all. Does not move cursor, range or markers
/// itself: it emits requests and shows what it is given.
class TimelineView : public QWidget {
  Q_OBJECT
 public:
  explicit TimelineView(QWidget* parent = nullptr);
  /// Begins a session: clears frames and markers.
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  /// Rebuilds the lanes from other frames of the same session; `showMarkers` sets the markers.
  void showOtherFrames();
  /// Continues with another library: a take more, or other roles and labels. The lanes stay, as this library
  /// says.
  void extendLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);

  const TimelineAxis& axis() const { return m_content.axis(); }
  const TimelineTracks& tracks() const { return m_content.tracks; }
  const TimelineLanes& lanes() const { return m_content.lanes; }
  const TimelineViewport& viewport() const { return m_content.viewport; }
  const Playback& playback() const { return m_content.playback; }
  void setLanes(const TimelineLanes& lanes);

  const Markers& markers() const { return m_content.markers; }
  void showMarkers(const Markers& markers);
  int selectedMarker() const { return m_content.selected_marker; }
  void selectMarker(int id);

  const std::vector<TimelineTake>& takes() const { return m_content.takes; }
  void showTakes(std::vector<TimelineTake> takes);

  /// Why the oldest frames are not kept, written where the timeline begins; empty = all are.
  void showLost(const QString& why);
  const QString& lost() const { return m_content.lost; }

  const TimelineTiers& tiers() const { return m_content.tiers; }
  void showAnnotations(const Annotations& annotations, const TierRules& rules);
  /// Which tier is active, and what is selected; 0 = none.
  void showChosen(int tier, int annotation);
  void showChosenSuggestion(int suggestion);
  /// The open labels while the cursor moves.
  void showRunning(std::vector<RunningLabel> running);
  /// Shows lanes of a take of the library, or of the session.
  void showOfTake(bool on);
  /// Upper left corner of a tier at a time, for pop-ups.
  QPoint placeOf(int tier, double time_s) const;

  /// For frames that do not come from a history.
  void append(std::span<const TrackRow> rows);
  void askSeek(double time_s) { emit seekRequested(time_s); }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 public slots:
  /// Reads new frames of the history, many in several calls, and moves the cursor.
  void refresh(const abrazo::FrameHistory& history, const abrazo::Playback& playback);
  /// Moves the cursor alone.
  void showPlayback(const abrazo::Playback& playback);
  void zoom(double factor);
  void showAll();
  void showRange();  ///< from in to out; everything without them

 signals:
  /// The history has more frames than were read.
  void unfinished();
  void seekRequested(double time_s);
  /// Begin or end of dragging the cursor.
  void scrubbing(bool on);
  /// @param drag  number of the drag: its requests are one change
  void rangeRequested(double from_s, double to_s, int drag);
  void rangeEntryRequested();
  void takeRequested(qint64 id);
  void markersRequested(const abrazo::Markers& next, const QString& what);
  void markerEntryRequested(int id);
  void menuRequested(const QPoint& global);
  void lanesChanged();
  void annotationsRequested(const abrazo::Annotations& next, const QString& what);
  /// An interval was drawn and needs a value.
  void labelDrawn(int tier, double from_s, double to_s);
  void labelRefused(const QString& why);
  void tierChosen(int tier);
  void annotationChosen(int annotation);
  void suggestionChosen(int suggestion);
  /// Requests to edit the value of an annotation.
  void valueEntryRequested(int annotation);
  void suggestionEntryRequested(int suggestion);
  void tierMenuRequested(int tier, int annotation, double time_s, const QPoint& global);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { None, Cursor, In, Out, NewRange, Marker, View, Overview, Tier };

  void take(const FrameSnapshot& frame, std::uint64_t frames_each);
  void place(const Playback& playback);
  void redraw();
  void arrange();
  void arrangeScroll();
  TimelineHit under(const QPointF& place) const;
  const TimelineTake* takeUnder(const QPointF& place) const;
  void begin(const TimelineHit& hit, QMouseEvent* event);
  void dragTo(const QPointF& place);
  void scrubTo(double x_px);
  void dragRangeTo(double time_s);
  void showPointer(const QPointF& place);
  TierHit tierUnder(const QPointF& place) const;
  bool beginInTier(QMouseEvent* event);
  void dragInTier(const QPointF& place, bool snaps);
  void endInTier();

  TimelineContent m_content;
  QPixmap m_layer;
  bool m_layerIsOld = true;
  std::uint64_t m_nextIndex = 0;
  FrameGaps m_gaps;
  double m_settingsMarksScale = 0;  ///< [s/px] at which the marks were merged
  QScrollBar* m_scroll;

  Drag m_drag = Drag::None;
  QPointF m_pressed;
  double m_pressedTime = 0;
  bool m_moved = false;
  Playback::Range m_draggedRange;
  int m_rangeDrag = 0;  ///< number of the last one
  Markers m_draggedMarkers;
};

}  // namespace abrazo::widgets
