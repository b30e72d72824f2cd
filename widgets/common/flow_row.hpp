#pragma once

#include <QLayout>
#include <vector>

namespace abrazo::widgets {

/// A row of widgets that goes on in another line where the width ends, so that nothing of it is cut in a
/// narrow panel. It owns its items.
class FlowRow : public QLayout {
 public:
  /// @param gap  between widgets and between lines [px]
  explicit FlowRow(QWidget* parent, int gap);
  ~FlowRow() override;

  void addItem(QLayoutItem* item) override;
  int count() const override { return static_cast<int>(m_items.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  /// As wide as the widest of its widgets.
  QSize minimumSize() const override;
  void setGeometry(const QRect& place) override;

 private:
  /// @return the height
  int lay(const QRect& place, bool is_moving) const;

  std::vector<QLayoutItem*> m_items;
};

}  // namespace abrazo::widgets
