#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "core/base/positions.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// What is shown of a file's points while a person says which joints they are.
struct MappedFrame {
  Positions points;                       ///< Y up, any unit; not finite: not seen
  std::array<bool, joint_count> known{};  ///< joints that have points
  Pose pose = Pose::Zero();               ///< rows of known joints
  std::vector<int> chosen;                ///< points of the joint that is being edited
  int joint = -1;                         ///< which one that is
};

/// Points of a file as dots and the skeleton that follows from them, turned by dragging. A click chooses the
/// point under it.
class MappingPreview : public QWidget {
  Q_OBJECT
 public:
  explicit MappingPreview(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const MappedFrame& frame);
  /// Where a point of the file is seen.
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
