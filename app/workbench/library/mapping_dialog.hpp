#pragma once

#include <QDialog>
#include <array>
#include <vector>

#include "core/motion/files/motion_reading.hpp"
#include "core/motion/joints/joint_guess.hpp"
#include "widgets/common/palette.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QTableWidget;

namespace abrazo::widgets {
class MotionPicture;
struct PicturedSpace;
}  // namespace abrazo::widgets

namespace abrazo::app {

/// Dialog that assigns a file's points to joints if no joint map or marker model fits. Starts from a guess.
/// Reads and writes only the joint maps that the user names.
class MappingDialog : public QDialog {
  Q_OBJECT
 public:
  MappingDialog(NamedMotion motion, QWidget* parent);
  void setColours(const widgets::Palette& palette);
  /// The map; complete after the dialog was accepted.
  const JointMap& map() const { return m_map; }
  /// Unit, rate and axis, if set by the user.
  MotionReading said() const;
  QTableWidget& table() { return *m_table; }
  widgets::MotionPicture& preview() { return *m_preview; }
  QString state() const;

 public slots:
  /// "LASI" or "0.5 LASI + 0.5 RASI"; empty removes the joint's points. On an error it shows the reason and
  /// changes nothing.
  void setPoints(int joint, const QString& text);
  /// Adds the point to the chosen joint (all with equal weight), or removes it.
  void togglePoint(int point);
  void chooseJoint(int joint);

 private:
  QWidget* makeFacts();
  QWidget* makeFoot();
  void connectParts();
  void guessAgain();
  void changed();
  void showRow(int joint);
  void showFrame();
  void showFacts();
  void saveMap();
  void loadMap();
  Positions upright(const Positions& points) const;
  widgets::PicturedSpace spaceOf() const;

  NamedMotion m_motion;
  JointMap m_map;
  std::array<JointGuess::By, joint_count> m_by{};
  int m_joint = 0;
  QTableWidget* m_table;
  widgets::MotionPicture* m_preview;
  QSlider* m_frame;
  QComboBox *m_up = nullptr, *m_unit = nullptr;
  QLineEdit* m_rate = nullptr;
  QLabel *m_facts = nullptr, *m_state = nullptr;
  QPushButton* m_use = nullptr;
  widgets::Palette m_palette;
  bool m_filling = false;
};

}  // namespace abrazo::app
