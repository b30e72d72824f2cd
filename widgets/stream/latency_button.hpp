#pragma once

#include <QAbstractButton>

#include "widgets/common/palette.hpp"
#include "widgets/stream/latency_rows.hpp"

namespace abrazo::widgets {

/// The latency in the status bar: sign, "in → out", median and 95th percentile. Constant width; a click
/// requests the breakdown.
class LatencyButton : public QAbstractButton {
  Q_OBJECT
 public:
  explicit LatencyButton(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// @param row in to out; null for an input without latency
  void show(const LatencyRow* row, LatencyVerdict verdict);
  /// "in → out 2.14 / 3.90 ms"
  QString words() const;
  LatencyVerdict verdict() const { return m_verdict; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Palette m_palette;
  QString m_name, m_value;
  LatencyVerdict m_verdict = LatencyVerdict::None;
};

}  // namespace abrazo::widgets
