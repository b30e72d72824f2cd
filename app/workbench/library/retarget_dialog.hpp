#pragma once

#include <QDialog>
#include <QStringList>
#include <vector>

#include "core/base/result.hpp"
#include "core/bodies/take_retargeting.hpp"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace abrazo::widgets {
class BodyBox;
}

namespace abrazo::app {

class CharacterField;

/// Takes of a library or manifest that can be retargeted.
struct RetargetOffer {
  struct Take {
    QString name;
    int frames = 0;      ///< 0 = not known before the take is read
    double rate_hz = 0;  ///< likewise
  };
  QString name;      ///< "demo (open)", "manifest.json"
  QString manifest;  ///< its file; empty = the open library
  std::vector<Take> takes;
};

/// Dialog for recorded takes on other bodies: which takes and frames, the two bodies, and the files. Reads no
/// file and computes nothing itself.
class RetargetDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RetargetDialog(QWidget* parent);
  /// Offers the takes of the open library, or of one more manifest, and shows them. Keeps the choices.
  void offer(const RetargetOffer& offer);
  /// Selects these takes alone.
  void chooseTakes(const QStringList& names);
  void setFolder(const QString& folder);
  QString folder() const;

  /// The manifest of the takes; empty = the open library.
  QString manifest() const;
  /// The choices. The Error is in the words of core: a body or number that is none.
  Result<RetargetWish> wish() const;

  void showProgress(const QString& doing, double fraction);
  /// @param text  result or error; empty = nothing was done
  void endProgress(const QString& text);
  /// Cancels a running job, or closes.
  void reject() override;

 signals:
  void manifestChosen(const QString& file);
  void retargetRequested();
  void cancelRequested();

 private:
  QWidget* makeTakes();
  QWidget* makeChoices();
  QWidget* makeFoot();
  QLineEdit* addFile(QGridLayout* grid, int row, const QString& name, const QString& placeholder);
  void addBody(QGridLayout* grid, int row, const QString& name, widgets::BodyBox*& box);
  void chooseBodyFile(widgets::BodyBox& box);
  const RetargetOffer* source() const;
  void showTakes();
  void showTypes();
  void settle();
  QString trouble() const;
  QString outcome(const RetargetWish& wish) const;

  std::vector<RetargetOffer> m_offers;
  QComboBox *m_source = nullptr, *m_type = nullptr;
  QListWidget* m_takes = nullptr;
  QSpinBox *m_from = nullptr, *m_to = nullptr;
  widgets::BodyBox *m_leader = nullptr, *m_follower = nullptr;
  CharacterField* m_character = nullptr;
  QLineEdit *m_folder = nullptr, *m_name = nullptr;
  QCheckBox* m_trace = nullptr;
  QLabel *m_about = nullptr, *m_state = nullptr;
  QProgressBar* m_progress = nullptr;
  QPushButton *m_start = nullptr, *m_cancel = nullptr;
  bool m_busy = false;
  bool m_filling = true;  ///< what is shown is being set; also until all parts are there
};

}  // namespace abrazo::app
