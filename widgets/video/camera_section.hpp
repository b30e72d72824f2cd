#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/video/pick_mark.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace abrazo::widgets {

class PickList;

/// State of the camera of a video.
struct CameraStatus {
  bool usable = false;     ///< a video is open
  std::string intrinsics;  ///< "calibrated: 1280 × 720, f 1100.0 px"; empty = guessed
  double guessed_fov_deg = 60;
  bool free_focal_length = true;
  bool has_camera = false;
  std::vector<PickMark> picks;
  int picks_needed = 6;          ///< for a solution
  std::optional<double> rms_px;  ///< over the used points
  int used = 0;
  std::string trouble;                ///< why there is no solution
  std::vector<std::string> warnings;  ///< of the solution
  std::string place;                  ///< "3.2 m away, 1.6 m high"

  bool operator==(const CameraStatus&) const = default;
};
/// "Reprojection error 0.42 px over 11 of 12 points", or what is missing.
std::string camera_words(const CameraStatus& status);

/// The camera of the overlay: lens, picked joints, and reprojection error.
class CameraSection : public QWidget {
  Q_OBJECT
 public:
  explicit CameraSection(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const CameraStatus& status);
  const CameraStatus& shown() const { return m_status; }
  void setPicking(bool on);
  bool isPicking() const;
  /// The next joint to pick, a vertex of the pair.
  void setJoint(int vertex);
  int joint() const;
  void selectPick(int index);
  QString text() const;
  PickList& list() { return *m_list; }

 signals:
  void intrinsicsRequested();
  void guessRequested(double horizontal_deg);
  void freeFocalRequested(bool on);
  void pickingRequested(bool on);
  void jointChosen(int vertex);
  void pickSelected(int index);
  void pickRemoveRequested(int index);
  void clearRequested();
  void saveRequested();
  void loadRequested();

 private:
  void present();
  void makeLens(QVBoxLayout& column);
  void makePicking(QVBoxLayout& column);

  Palette m_palette;
  CameraStatus m_status;
  QLabel *m_lens, *m_result, *m_warnings;
  QToolButton *m_intrinsics, *m_clear, *m_save, *m_load;
  QDoubleSpinBox* m_fov;
  QCheckBox* m_focal;
  QPushButton* m_pick;
  QComboBox* m_joint;
  PickList* m_list;
};

}  // namespace abrazo::widgets
