#pragma once

#include <QTreeWidget>
#include <map>

#include "core/stream/protocol/stream_health.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// Diagnoses with advice, then the kinds of issues with counts; an issue expands to its latest text. Scrolls
/// at a fixed height, and keeps expanded and selected items while the counts change.
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
  QTreeWidgetItem* m_calm;                      ///< shown if there are no issues
};

}  // namespace abrazo::widgets
