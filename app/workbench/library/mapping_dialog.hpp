#pragma once

#include <QDialog>
#include <array>
#include <vector>

#include "core/motion/files/import_clip.hpp"
#include "core/motion/joints/joint_guess.hpp"
#include "widgets/common/palette.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QTableWidget;

namespace abrazo::widgets {
class MappingPreview;
}

namespace abrazo::app {

/// Asks which of a file's points are which joints, where no joint map and no marker model fits. Begins with a
/// guess. Reads and writes no file but the joint maps that a person names.
class MappingDialog : public QDialog {
  Q_OBJECT
 public:
  MappingDialog(NamedMotion motion, QWidget* parent);
  void setColours(const widgets::Palette& palette);
  /// With a rule for each joint once it was accepted.
  const JointMap& map() const { return m_map; }
  /// Unit, rate and axis, where a person said so.
  ImportOptions said() const;
  QTableWidget& table() { return *m_table; }
  widgets::MappingPreview& preview() { return *m_preview; }
  QString state() const;

 public slots:
  /// "LASI" or "0.5 LASI + 0.5 RASI"; empty takes the joint's points away. Says what is wrong, and changes
  /// nothing then.
  void setPoints(int joint, const QString& text);
  /// Adds the point to the chosen joint, all with equal weight, or takes it away.
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

  NamedMotion m_motion;
  JointMap m_map;
  std::array<JointGuess::By, joint_count> m_by{};
  int m_joint = 0;
  QTableWidget* m_table;
  widgets::MappingPreview* m_preview;
  QSlider* m_frame;
  QComboBox *m_up = nullptr, *m_unit = nullptr;
  QLineEdit* m_rate = nullptr;
  QLabel *m_facts = nullptr, *m_state = nullptr;
  QPushButton* m_use = nullptr;
  widgets::Palette m_palette;
  bool m_filling = false;
};

}  // namespace abrazo::app
