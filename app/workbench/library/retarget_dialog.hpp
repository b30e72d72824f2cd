#pragma once

#include <QDialog>
#include <QStringList>
#include <vector>

#include "core/base/result.hpp"
#include "core/bodies/take_retargeting.hpp"
#include "widgets/common/palette.hpp"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace abrazo::app {

class BodyField;
class CharacterField;
class FactorField;
class RetargetPreview;

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

/// Dialog for recorded takes on other bodies: which takes and frames, the two bodies, a preview, and the
/// files. Reads no file and computes nothing itself.
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

  /// The take that is previewed, with its frames and bodies: the current one of those chosen. The Error says
  /// why there is none.
  Result<RetargetWish> previewed() const;
  RetargetPreview& preview() { return *m_preview; }
  void setColours(const widgets::Palette& palette);

  void showProgress(const QString& doing, double fraction);
  /// @param text  result or error; empty = nothing was done
  void endProgress(const QString& text);
  /// Cancels a running job, or closes.
  void reject() override;

 signals:
  /// What is previewed may be other now.
  void choiceChanged();
  void manifestChosen(const QString& file);
  void retargetRequested();
  void cancelRequested();

 private:
  QWidget* makeTakes();
  QWidget* makeChoices();
  QWidget* makeFoot();
  QLineEdit* addFile(QGridLayout* grid, int row, const QString& name, const QString& placeholder);
  void addBody(QGridLayout* grid, int row, const QString& name, BodyField*& field);
  void addFactor(QGridLayout* grid, int row, const QString& name, const QString& tip, FactorField*& field);
  Result<RetargetWish> pairs() const;
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
  BodyField *m_leader = nullptr, *m_follower = nullptr;
  FactorField *m_contacts = nullptr, *m_smoothness = nullptr;
  RetargetPreview* m_preview = nullptr;
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
