#pragma once

#include <QWidget>
#include <vector>

#include "core/video/video_sync.hpp"
#include "widgets/common/palette.hpp"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace abrazo::widgets {

/// Synchronisation of the video with the timeline: sync points, offset, rate and drift.
class SyncSection : public QWidget {
  Q_OBJECT
 public:
  explicit SyncSection(QWidget* parent = nullptr);
  void show(const VideoSync& sync, bool usable);
  const VideoSync& shown() const { return m_sync; }
  QString text() const;

 signals:
  void pointRequested();
  void pointRemoveRequested(int index);
  void goToRequested(double subject_s);
  void offsetEntered(double seconds);
  void rateEntered(double rate);
  void clearRequested();

 private:
  void makeRows();
  QDoubleSpinBox* makeField(const QString& name, int decimals);

  VideoSync m_sync;
  QPushButton* m_same;
  QToolButton* m_clear;
  QVBoxLayout* m_points;
  std::vector<QWidget*> m_rows;
  QDoubleSpinBox *m_offset, *m_rate;
  QLabel *m_words, *m_advice;
};

}  // namespace abrazo::widgets
