#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/library/build_plan_model.hpp"

class QComboBox;
class QSpinBox;

namespace abrazo::app {

/// Form for the chosen performers. Applies changes immediately; requests reading the file again if necessary.
class BuildForm : public QWidget {
  Q_OBJECT
 public:
  explicit BuildForm(BuildPlanModel& model, QWidget* parent = nullptr);
  void show(const std::vector<int>& rows);
  /// Sets the available .asf files.
  void setSkeletons(const QStringList& files);

 signals:
  /// Requests reading the file with these options.
  void surveyRequested(const abrazo::Manifest::Performer& source, std::optional<double> fps);

 private:
  void connectParts();
  void showTakes();
  void showJoints(const PlannedPerformer& performer);
  void showSkeleton(const PlannedPerformer& performer);
  void reread(const std::function<bool(Manifest::Performer& source, std::optional<double>& fps)>& say);
  void chooseJoints();
  void chooseSkeleton();

  BuildPlanModel& m_model;
  std::vector<int> m_rows;
  QStringList m_skeletons;
  QComboBox *m_take, *m_role, *m_rate, *m_unit, *m_up, *m_joints, *m_skeleton;
  QSpinBox* m_start;
};

}  // namespace abrazo::app
