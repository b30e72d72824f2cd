#pragma once

#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/video/video_frame.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/video/overlay_painter.hpp"
#include "widgets/video/pick_mark.hpp"
#include "widgets/video/picture_framing.hpp"

namespace abrazo::widgets {

/// A picture of a video, fitted or zoomed, with the overlay of the pair. During picking a magnifier follows
/// the pointer: press, aim, release. Shows values and emits requests.
class VideoView : public QWidget {
  Q_OBJECT
 public:
  explicit VideoView(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// @param picture null = none
  void showPicture(VideoFramePtr picture);
  const VideoFramePtr& picture() const { return m_picture; }
  void showOverlay(VideoOverlay overlay);
  const VideoOverlay& overlay() const { return m_overlay; }
  void setOpacity(double opacity);
  /// Shows over the dimmed picture why there is none, or why it does not match the time.
  void setNotice(const QString& text);
  const QString& notice() const { return m_notice; }
  /// Shows enlarged pixels smoothed, or as squares.
  void setSmooth(bool on);
  void setZoom(const PictureZoom& zoom);
  const PictureZoom& zoom() const { return m_zoom; }
  void zoomBy(double factor);
  /// One picture pixel per screen pixel.
  void zoomToPixels();
  PictureFraming framing() const;

  /// @param joint joint of the next click; empty = no picking
  void setPicking(const QString& joint);
  bool isPicking() const { return !m_joint.isEmpty(); }
  void setPicks(std::vector<PickMark> picks);
  const std::vector<PickMark>& picks() const { return m_picks; }
  void selectPick(int index);
  QSize sizeHint() const override { return {384, 216}; }
  QSize minimumSizeHint() const override { return {160, 90}; }

 signals:
  void picked(const abrazo::Pixel& pixel);
  /// @param gesture  the same for all moves of one drag, or of keys pressed one after the other
  void pickMoved(int index, const abrazo::Pixel& pixel, int gesture);
  void pickSelected(int index);
  void pickRemoveRequested(int index);
  void pickingEndRequested();
  /// , and . while the view has the focus.
  void stepRequested(int pictures);
  void painted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  PictureSize pictureSize() const;
  PictureSize viewSize() const { return {static_cast<double>(width()), static_cast<double>(height())}; }
  bool keeps(int key, Qt::KeyboardModifiers held) const;
  void nudge(double dx, double dy);
  void paintPicture(QPainter& painter);
  void paintPicks(QPainter& painter) const;
  void paintLens(QPainter& painter);
  void paintNotice(QPainter& painter) const;
  int pickAt(const QPointF& place) const;
  Pixel held(const Pixel& pixel) const;
  void describe();

  Palette m_palette;
  VideoFramePtr m_picture;
  QImage m_image;   ///< over the picture's own bytes
  QImage m_scaled;  ///< at screen size, if reduced
  VideoOverlay m_overlay;
  OverlayLook m_look;
  QString m_notice, m_joint;
  PictureZoom m_zoom;
  bool m_smooth = true;
  std::vector<PickMark> m_picks;
  int m_selected = -1;
  std::optional<QPointF> m_pointer;  ///< position in the view
  std::optional<QPointF> m_panFrom;
  bool m_placing = false;  ///< a new pick is being placed
  int m_dragged = -1;      ///< pick being moved
  int m_gesture = 0;
};

}  // namespace abrazo::widgets
