#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"

class QComboBox;
class QLabel;
class QSplitter;
class QToolButton;

namespace abrazo::widgets {

class CameraSection;
class OverlaySection;
class SectionHeader;
class StepBar;
class SyncSection;
class VideoView;

/// The reference video: its picture and, below or beside it depending on the panel's shape, file,
/// synchronisation, overlay and camera.
class VideoPanel : public QWidget {
  Q_OBJECT
 public:
  explicit VideoPanel(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// @param names  of the videos of the subject  @param current  -1 = none
  void showFiles(const QStringList& names, int current);
  /// @param warning wrong statements of the file's header; may be empty
  void showFacts(const QString& facts, const QString& warning);
  QString facts() const;

  VideoView& view() { return *m_view; }
  StepBar& steps() { return *m_steps; }
  SyncSection& sync() { return *m_sync; }
  OverlaySection& overlay() { return *m_overlay; }
  CameraSection& camera() { return *m_camera; }

 signals:
  void openRequested();
  void closeRequested();
  void chosen(int index);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makePicture();
  QWidget* makeSections();
  QWidget* makeFile();
  QWidget* section(const QString& title);

  QSplitter* m_split;
  bool m_isArranged = false;  ///< by the user
  VideoView* m_view;
  StepBar* m_steps;
  QComboBox* m_files;
  QToolButton* m_close;
  QLabel *m_facts, *m_warning;
  SyncSection* m_sync;
  OverlaySection* m_overlay;
  CameraSection* m_camera;
  std::vector<SectionHeader*> m_heads;
};

}  // namespace abrazo::widgets
