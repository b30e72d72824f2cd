#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <vector>

#include "core/library/build/library_plan.hpp"
#include "widgets/common/palette.hpp"

Q_DECLARE_METATYPE(abrazo::Manifest::Performer)

namespace abrazo::app {

/// The performers of a library plan, one per row. All changes go through it, so that the remarks always match
/// the shown plan.
class BuildPlanModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Take, Performer, Role, Frames, Rate, Unit, Height, Up, Joints, Pairing, ColumnCount };

  explicit BuildPlanModel(QObject* parent = nullptr);
  const LibraryPlan& plan() const { return m_plan; }
  const PlannedPerformer& performer(int row) const {
    return m_plan.performers[static_cast<std::size_t>(row)];
  }
  const std::vector<PlanRemark>& remarks() const { return m_remarks; }
  bool canBuild() const;
  void setColours(const widgets::Palette& palette);

  /// Replaces the contents read from files. Decisions about their performers stay.
  void setSurveyed(const std::vector<std::vector<PlannedPerformer>>& files);
  /// Guesses pairs among performers without a take.
  void pairUp();
  void setTake(const std::vector<int>& rows, const QString& take);
  void setRole(const std::vector<int>& rows, PlannedRole role);
  void setStart(const std::vector<int>& rows, int frame);
  void setName(const QString& name);
  void setLabels(const QString& file, std::vector<std::string> takes);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  void planChanged();

 private:
  void change(const std::function<void()>& edit);
  bool isKnown(const std::vector<PlannedPerformer>& of_one_file) const;
  void readAnew(const std::vector<PlannedPerformer>& of_one_file);
  void replace(const std::vector<PlannedPerformer>& of_one_file);
  QString text(int row, int column) const;
  QString tip(int row, int column) const;
  bool isGuess(int row, int column) const;
  bool isTrouble(int row, int column) const;

  void refresh();

  LibraryPlan m_plan;
  std::vector<bool> m_shaded;  ///< every other take
  std::vector<PlanRemark> m_remarks;
  widgets::Palette m_palette;
};

}  // namespace abrazo::app
