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

/// Of what, how large and how fast a film is to be made of what was recorded.
class RenderDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RenderDialog(QWidget* parent);
  /// @param range  between in and out, where both make one  @param view  size of the scene [pixels]
  void offer(const Playback& playback, const std::optional<Playback::Range>& range, QSize view);
  /// That the reference video can be rendered too. @param size  empty: there is none
  void offerVideo(QSize size, double rate_hz);
  /// Without the file.
  RangeRequest request() const;
  bool isOfVideo() const;

 signals:
  void renderRequested();
  /// In its place where it is to be of the reference video.
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
