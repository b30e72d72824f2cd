#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "core/base/positions.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// A file's points, shown while the user assigns joints.
struct MappedFrame {
  Positions points;                       ///< Y up, any unit; not finite = not visible
  std::array<bool, joint_count> known{};  ///< joints with points
  Pose pose = Pose::Zero();               ///< rows of known joints
  std::vector<int> chosen;                ///< points of the edited joint
  int joint = -1;                         ///< the edited joint
};

/// Points of a file as dots and the resulting skeleton; dragging rotates the view, a click chooses a point.
class MappingPreview : public QWidget {
  Q_OBJECT
 public:
  explicit MappingPreview(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const MappedFrame& frame);
  /// Position of a point in the view.
  QPointF placeOf(int point) const;
  QSize sizeHint() const override { return {420, 460}; }

 signals:
  void pointClicked(int point);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QPointF project(const Vec3& place) const;
  void fit();
  void paintSkeleton(QPainter& painter) const;
  void paintPoints(QPainter& painter) const;

  Palette m_palette;
  MappedFrame m_frame;
  Vec3 m_middle = Vec3::Zero();
  double m_extent = 1, m_yaw = 0.5, m_yawAtPress = 0;
  QPoint m_pressed;
};

}  // namespace abrazo::widgets
