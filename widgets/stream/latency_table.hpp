#pragma once

#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/stream/latency_rows.hpp"

namespace abrazo::widgets {

/// Latency by stage from packet to packet, in milliseconds: of the shown frame, and over recent frames.
class LatencyTable : public QWidget {
  Q_OBJECT
 public:
  explicit LatencyTable(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// @param over range of the percentiles: "last 5 s"
  void show(std::vector<LatencyRow> rows, const QString& over);
  const std::vector<LatencyRow>& rows() const { return m_rows; }
  /// Tab-separated text, one line per stage, for the clipboard.
  QString text() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  Palette m_palette;
  std::vector<LatencyRow> m_rows;
  QString m_over;
};

}  // namespace abrazo::widgets
