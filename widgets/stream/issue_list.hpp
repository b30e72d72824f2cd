#pragma once

#include <QTreeWidget>
#include <map>

#include "core/stream/protocol/stream_health.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// Diagnoses with what to do, then the kinds of issues with how often; an issue opens to its latest text.
/// Scrolls in a height of its own, and keeps what is open and selected while the numbers run.
class IssueList : public QTreeWidget {
  Q_OBJECT
 public:
  explicit IssueList(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const StreamHealth* health);
  /// The selected lines, or all of them.
  QString text() const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  QTreeWidgetItem& itemOf(const QString& key);
  QIcon signOf(StreamDiagnosis::Severity severity) const;
  void showDiagnosis(const StreamDiagnosis& diagnosis);
  void showIssue(const IssueCount& issue);
  void copy() const;

  Palette m_palette;
  std::map<QString, QTreeWidgetItem*> m_items;  ///< by "diagnosis kind" or "issue kind"
  QTreeWidgetItem* m_calm;                      ///< says that there is nothing
};

}  // namespace abrazo::widgets
