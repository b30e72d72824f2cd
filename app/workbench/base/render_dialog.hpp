#pragma once

#include <QDialog>
#include <optional>

#include "app/workbench/base/range_rendering.hpp"
#include "core/session/frames/playback.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace abrazo::app {

/// Options of a film of the recording: range, size and rate.
class RenderDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RenderDialog(QWidget* parent);
  /// @param range between in and out, if set @param view size of the scene [pixels]
  void offer(const Playback& playback, const std::optional<Playback::Range>& range, QSize view);
  /// Offers to render the reference video too. @param size empty: there is none
  void offerVideo(QSize size, double rate_hz);
  /// The request without the file.
  RangeRequest request() const;
  bool isOfVideo() const;

 signals:
  void renderRequested();
  /// Emitted instead if the film is of the reference video.
  void videoRenderRequested();

 private:
  void estimate();
  void chooseWhat();

  QLabel* m_whatTitle;
  QComboBox *m_what, *m_span, *m_size;
  QDoubleSpinBox* m_rate;
  QCheckBox* m_captions;
  QLabel* m_estimate;
  QPushButton* m_render;
  Playback::Range m_whole, m_range;
  QSize m_video;
  double m_videoRate = 0, m_sceneRate = 30;
  bool m_wasOfVideo = false;
};

}  // namespace abrazo::app
