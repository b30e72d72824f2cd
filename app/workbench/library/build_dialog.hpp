#pragma once

#include <QDialog>
#include <QStringList>
#include <vector>

#include "app/workbench/library/build_plan_model.hpp"

class QGridLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QTableView;
class QToolButton;

namespace abrazo::widgets {
class PairPreview;
}

namespace abrazo::app {

class BuildForm;

/// Output files of a build; empty = not written.
struct BuildOutputs {
  QString library;   ///< .h5
  QString manifest;  ///< .json
};

/// Dialog for facts that motion files do not state, before a library is built: who danced with whom, who
/// leads, units, axes, rates. Reads no file and builds nothing itself.
class BuildDialog : public QDialog {
  Q_OBJECT
 public:
  explicit BuildDialog(QWidget* parent = nullptr);
  void setColours(const widgets::Palette& palette);
  BuildPlanModel& model() { return m_model; }
  BuildForm& form() { return *m_form; }
  QTableView& table() { return *m_table; }
  widgets::PairPreview& preview() { return *m_preview; }
  QStringList remarks() const;
  BuildOutputs outputs() const;
  void setOutputs(const BuildOutputs& outputs);
  std::vector<int> chosenRows() const;

 public slots:
  void setSkeletons(const QStringList& files);
  void showProgress(const QString& doing, double fraction);
  void endProgress();
  void showError(const QString& text);
  /// Cancels a running job, or closes. The plan stays.
  void reject() override;

 signals:
  void filesOffered(const QStringList& files);
  void surveyRequested(const abrazo::Manifest::Performer& source, std::optional<double> fps);
  void labelsRequested(const QString& file);
  void buildRequested();
  void cancelRequested();
  /// Discard the plan.
  void startOverRequested();
  /// Use this file as the user's motion instead of building a library.
  void userChosen(const QString& motion, const QString& skeleton);

 protected:
  /// Return ends text input; it does not start the build.
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* makeUserRow();
  QWidget* makeOverview();
  QWidget* makeOutputs();
  QWidget* makeFoot();
  QLineEdit* addPath(QGridLayout* grid, int row, const QString& name, const QString& tip,
                     const QString& filter, const QString& ending = {});
  void connectParts();
  void offerLabels();
  void showPlan();
  void showChosen();
  void showUserRow();
  void chooseFiles();

  BuildPlanModel m_model;
  QTableView* m_table;
  BuildForm* m_form;
  widgets::PairPreview* m_preview;
  QListWidget* m_remarks;
  QWidget* m_userRow = nullptr;
  QLabel *m_userQuestion = nullptr, *m_state = nullptr, *m_previewHead = nullptr;
  QToolButton* m_userButtons[2] = {nullptr, nullptr};
  QLineEdit *m_name = nullptr, *m_labels = nullptr, *m_library = nullptr, *m_manifest = nullptr;
  QProgressBar* m_progress;
  QPushButton *m_add = nullptr, *m_startOver = nullptr, *m_build = nullptr, *m_cancel = nullptr;
  widgets::Palette m_palette;
  bool m_busy = false;
};

}  // namespace abrazo::app
