#pragma once

#include <QAbstractListModel>
#include <QPixmap>
#include <QSortFilterProxyModel>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/library/take_belief.hpp"
#include "widgets/library/take_coverage.hpp"
#include "widgets/library/take_rows.hpp"

namespace abrazo::widgets {

/// The takes of a library as rows. Pictures are created on demand.
class TakeModel : public QAbstractListModel {
  Q_OBJECT
 public:
  explicit TakeModel(QObject* parent = nullptr);
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  /// Counts from the first frame again: they were solved anew.
  void beginCoverage();
  void setColours(const Palette& palette);
  const std::shared_ptr<const MotionLibrary>& library() const { return m_library; }
  const TakeRow& row(int take) const { return m_rows[static_cast<std::size_t>(take)]; }
  const PairsOfTakes& pairs() const { return m_pairs; }
  TakeCoverage& coverage() { return m_coverage; }
  const TakeCoverage& coverage() const { return m_coverage; }
  const TakeBelief& belief() const { return m_belief; }

  /// Names of excluded takes: vetoed, or playing the user.
  void setVetoed(const std::set<std::string>& takes);
  void setUsersTake(const std::string& take);
  bool isVetoed(int take) const { return m_vetoed.contains(row(take).name); }
  bool isUsers(int take) const { return !m_users.empty() && row(take).name == m_users; }
  /// Source of the shown frame; take -1 = none.
  void setSource(int take, int frame);
  int sourceTake() const { return m_source_take; }
  int sourceFrame() const { return m_source_frame; }
  /// Browsing position in a take; take -1 = none.
  void setCursor(int take, int frame);
  int cursorTake() const { return m_cursor_take; }
  int cursorFrame() const { return m_cursor_frame; }
  void coverageChanged();
  /// The belief of the shown frame; only changed takes are redrawn.
  void setBelief(const FrameIntent& intent);

  /// The belief in a take, and at a frame of it, as text; empty without a belief.
  QString beliefText(int take, std::optional<int> frame = {}) const;
  QPixmap picture(int take, double pixel_ratio) const;
  int picturesMade() const { return static_cast<int>(m_pictures.size()); }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  void changed(int take);
  QString spoken(const TakeRow& row) const;

  std::shared_ptr<const MotionLibrary> m_library;
  std::vector<TakeRow> m_rows;
  PairsOfTakes m_pairs;
  TakeCoverage m_coverage;
  TakeBelief m_belief;
  std::shared_ptr<const IntentModel> m_model;  ///< model of the belief's blocks
  Palette m_palette;
  std::set<std::string> m_vetoed;
  std::string m_users;
  int m_source_take = -1, m_source_frame = 0;
  int m_cursor_take = -1, m_cursor_frame = 0;
  mutable std::map<int, QPixmap> m_pictures;
};

enum class TakeOrder { AsRecorded, Name, Longest, MostMoves, MostSelected };

/// Filtered and sorted rows.
class TakeFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  TakeFilter(TakeModel* model, QObject* parent = nullptr);
  void setWanted(const QString& text);
  void setOrder(TakeOrder order);
  int takeAt(const QModelIndex& index) const;
  QModelIndex indexOf(int take) const;

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  TakeModel* m_model;
  std::string m_wanted;
  TakeOrder m_order = TakeOrder::AsRecorded;
};

}  // namespace abrazo::widgets
