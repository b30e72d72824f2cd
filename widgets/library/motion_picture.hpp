#pragma once

#include <QWidget>
#include <array>
#include <string>
#include <vector>

#include "core/base/positions.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// One frame of a motion file: its points, and the joints that they give.
struct PicturedFrame {
  Positions points;                                    ///< P x 3, Y up, any unit; not finite = not visible
  std::vector<std::string> names;                      ///< of the points; may be empty
  std::array<bool, joint_count> known{};               ///< joints with points
  Pose pose = Pose::Zero();                            ///< rows of known joints
  std::array<std::string, joint_count> joint_names{};  ///< shown at the joints, where not empty
  std::vector<int> chosen;                             ///< points of the edited joint
  int joint = -1;                                      ///< the edited joint
  bool is_body = false;                                ///< limbs with thickness; the unit is the metre
};

/// What stays the same over the frames of a motion.
struct PicturedSpace {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< box that is kept in view, at the place of the frame
  double ground = 0;                             ///< height of the floor
  double grid = 0.5;                             ///< spacing of the lines on it
  double height = 0;                             ///< of the standing person, above the floor; 0: not shown
  QString height_words;                          ///< "1.76 m"
};

/// A motion file upright on the ground, as dots or as a body, with names at the points. Dragging turns it, a
/// click chooses a point.
class MotionPicture : public QWidget {
  Q_OBJECT
 public:
  explicit MotionPicture(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void setSpace(const PicturedSpace& space);
  void show(const PicturedFrame& frame);
  /// In the place of a frame, why there is none.
  void showNothing(const QString& why);
  void setNames(bool on);
  /// Position of a point in the view.
  QPointF placeOf(int point) const;
  /// Names that found room in the last drawing.
  int namesDrawn() const { return m_namesDrawn; }
  const PicturedSpace& space() const { return m_space; }
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
  double pixelsPerUnit() const;
  Vec3 middle() const;
  void paintGround(QPainter& painter) const;
  void paintHeight(QPainter& painter) const;
  void paintSkeleton(QPainter& painter) const;
  void paintPoints(QPainter& painter) const;
  void paintNames(QPainter& painter);

  Palette m_palette;
  PicturedSpace m_space;
  PicturedFrame m_frame;
  QString m_nothing;
  Vec3 m_ground = Vec3::Zero();  ///< place of the frame on the ground
  double m_yaw = 0.5, m_yawAtPress = 0;
  bool m_hasNames = true;
  int m_namesDrawn = 0;
  QPoint m_pressed;
};

}  // namespace abrazo::widgets
