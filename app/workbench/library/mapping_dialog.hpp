#pragma once

#include <QDialog>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/workbench/base/job.hpp"
#include "core/motion/files/motion_reading.hpp"
#include "core/motion/joints/joint_guess.hpp"
#include "core/motion/joints/marker_guess.hpp"
#include "widgets/common/palette.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;
class QTableWidget;
class QTabWidget;

namespace abrazo::widgets {
class MotionPicture;
struct PicturedSpace;
}  // namespace abrazo::widgets

namespace abrazo::app {

class MarkerTable;

/// Dialog that assigns a file's points to joints, or markers to places on the body, if no joint map or marker
/// model fits. Starts from a guess. Reads and writes only the files that the user names.
class MappingDialog : public QDialog {
  Q_OBJECT
 public:
  MappingDialog(NamedMotion motion, QWidget* parent);
  ~MappingDialog() override;
  void setColours(const widgets::Palette& palette);
  /// Stores the joint map or marker model for files with the same points. @return its file
  Result<std::string> keep(const QString& folder) const;
  /// Unit, rate and axis, if set by the user.
  MotionReading said() const;
  QTableWidget& table() { return *m_table; }
  MarkerTable& markers() { return *m_markers; }
  /// Whether the page of markers is shown and used instead of that of joints.
  bool namesMarkers() const;
  widgets::MotionPicture& preview() { return *m_preview; }
  /// What was said last, in full; the dialog shows two lines of it.
  QString state() const { return m_said; }

 public slots:
  /// Asks first if joints or places that the user gave would be lost.
  void reject() override;
  /// "LASI" or "0.5 LASI + 0.5 RASI"; empty removes the joint's points. On an error it shows the reason and
  /// changes nothing.
  void setPoints(int joint, const QString& text);
  /// Adds the point to the chosen joint (all with equal weight), or removes it.
  void togglePoint(int point);
  void chooseJoint(int joint);
  /// Guesses the places of the markers from their motion on a worker thread, and then shows them.
  void guessFromMotion();
  void saveTo(const QString& file);
  /// A joint map or a marker model. On an error it shows the reason and changes nothing.
  void loadFrom(const QString& file);

 private:
  QWidget* makeFacts();
  QWidget* makeState();
  QWidget* makeFoot();
  void connectParts();
  void guessAgain();
  void changed();
  void showRow(int joint);
  void showFrame();
  void showFacts();
  void showPage();
  void showGuess(const Result<MarkerGuess>& guess);
  MarkerModel model() const;
  QStringList missing() const;
  int assigned() const;
  void tell(const QString& text);
  void refuse(const QString& why);
  void leaveRefusal();
  void save();
  void load();
  Positions upright(const Positions& points) const;
  widgets::PicturedSpace spaceOf() const;

  NamedMotion m_motion;
  JointMap m_map;
  std::array<JointGuess::By, joint_count> m_by{};
  int m_joint = 0;
  QTableWidget* m_table;
  MarkerTable* m_markers;
  QTabWidget* m_pages;
  widgets::MotionPicture* m_preview;
  QSlider* m_frame;
  QComboBox *m_up = nullptr, *m_unit = nullptr;
  QLineEdit* m_rate = nullptr;
  QLabel *m_facts = nullptr, *m_state = nullptr;
  QPushButton *m_use = nullptr, *m_save = nullptr, *m_again = nullptr, *m_from_motion = nullptr;
  widgets::Palette m_palette;
  QString m_said;
  bool m_isRefusal = false;            ///< it is about an edit that was not taken
  std::set<int> m_given;               ///< joints whose points the user gave, in no file yet
  std::optional<MarkerModel> m_saved;  ///< in a file
  bool m_filling = false;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
