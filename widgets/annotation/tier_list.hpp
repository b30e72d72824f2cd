#pragma once

#include <QWidget>
#include <set>
#include <string>

#include "widgets/common/annotation_types.hpp"
#include "widgets/common/palette.hpp"

class QListWidget;
class QToolButton;

namespace abrazo::widgets {

/// The tiers of a subject in the order of their lanes, with active tier, visibility and names. Emits
/// requests; shows what it is given.
class TierList : public QWidget {
  Q_OBJECT
 public:
  explicit TierList(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const Annotations& annotations, int active, const std::set<std::string>& hidden);

 signals:
  void tierChosen(int tier);
  void changeRequested(const abrazo::Annotations& next, const QString& what);
  void refused(const QString& why);
  void visibilityRequested(const QString& tier, bool on);

 private:
  void add(TierKind kind, const QString& name);
  void rename(int row, const QString& name);
  void removeActive();
  void moveActive(int by);
  void settle(const Status& done, const Annotations& next, const QString& what);

  Annotations m_annotations;
  int m_active = 0;
  bool m_filling = false;
  QListWidget* m_list;
  QToolButton *m_remove, *m_up, *m_down;
};

}  // namespace abrazo::widgets
