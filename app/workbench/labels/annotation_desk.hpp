#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "core/annotation/label_edits.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo::widgets {
class AnnotationPanel;
}

namespace abrazo::app {

class LibraryFeed;
class MainWindow;
class SubjectStage;

/// Shows the annotations of the document in their views, the timeline's lanes and the panel, whose requests
/// go to the document; changes the shown subject; knows where an edit takes place.
class AnnotationDesk : public QObject {
  Q_OBJECT
 public:
  explicit AnnotationDesk(MainWindow& window);
  ~AnnotationDesk() override;

  /// Whether lanes and keys of labels are active: for a take, if the session has annotations, and while the
  /// panel is open.
  bool isOpen() const;
  /// The present context of an edit.
  EditPlace place() const;

  /// Shows a take of the library instead of the session, or the session again (""). Errors are reported.
  void showSubject(const std::string& subject);

  /// Valid times of annotations of the shown subject.
  Annotations::Range range() const;
  /// Frame rate of the shown subject; 0 = no fixed rate.
  double fps() const;
  /// Library of the running session; null = none.
  std::shared_ptr<const MotionLibrary> library() const;

  /// The panel "Annotation"; a section below its lists is added with AnnotationPanel::addSection.
  widgets::AnnotationPanel& panel() const { return *m_panel; }
  LibraryFeed& feed() const { return *m_feed; }

 private:
  bool showsTake() const;
  void connectRequests();
  void show();

  MainWindow& m_window;
  widgets::AnnotationPanel* m_panel;
  LibraryFeed* m_feed;
  std::unique_ptr<SubjectStage> m_stage;
};

}  // namespace abrazo::app
