#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <string>

#include "core/annotation/annotations.hpp"

namespace abrazo {
class MotionLibrary;
}

namespace abrazo::widgets {
class AnnotationPanel;
}

namespace abrazo::app {

class LibraryFeed;
class MainWindow;
class SubjectStage;

/// What is annotated in the window: the annotations of every subject, and the one that is shown. Everything
/// that changes annotations comes by `change`, which makes it a step of undo.
///
/// A subject is the session ("") or a take of its library by name. A take's annotations begin as those that
/// the library has, with a tier for notes; what is said of its roles and moves goes into the library of the
/// running session a moment later.
class AnnotationDesk : public QObject {
  Q_OBJECT
 public:
  explicit AnnotationDesk(MainWindow& window);
  ~AnnotationDesk() override;

  /// "" = the session.
  const std::string& subject() const;
  bool showsTake() const { return !subject().empty(); }
  /// Lanes and keys of labels are there: for a take, once something is said of the session, and while the
  /// panel is open.
  bool isOpen() const;
  const Annotations& annotations() const { return annotations_of(subject()); }
  /// Of any subject; empty when nothing was said of it and it was not shown.
  const Annotations& annotations_of(const std::string& subject) const;
  /// Of the shown subject, as a step of undo. @param what  "draw turn": for the menu and the message
  void change(Annotations next, const QString& what);
  /// Of a subject that need not be shown.
  void change(const std::string& subject, Annotations next, const QString& what);
  /// As `change` when it was done, else reports why not. @return whether it was done
  bool changeOrTell(const Status& done, Annotations next, const QString& what);
  /// Suggestions only: not a step of undo.
  void suggest(Annotations next);

  /// Of the subjects of which something else is said than was when they were first shown.
  AnnotationBook book() const;
  /// In place of all there is: what a project had. Forgets steps of undo of what was there; the library is
  /// told of its takes.
  void setBook(AnnotationBook book);

  /// Shows a take of the library in place of the session, or the session again (""). What is in the way is
  /// told.
  void showSubject(const std::string& subject);

  /// Times of the shown subject that annotations may have.
  Annotations::Range range() const;
  /// Frames of the shown subject per second; 0 when they have no fixed rate.
  double fps() const;
  /// Of the running session; null when there is none.
  std::shared_ptr<const MotionLibrary> library() const;

  int activeTier() const { return m_activeTier; }
  void setActiveTier(int tier);
  /// Id of the selected annotation; 0 = none.
  int selected() const { return m_selected; }
  void select(int annotation);
  Conflict conflict() const { return m_conflict; }
  void setConflict(Conflict conflict);

  /// The panel "Annotation"; a section below its lists is added with AnnotationPanel::addSection.
  widgets::AnnotationPanel& panel() const { return *m_panel; }
  LibraryFeed& feed() const { return *m_feed; }

 signals:
  /// Of the shown subject: annotations, suggestions or vocabularies.
  void annotationsChanged();
  /// Another subject is shown, or a session began. annotationsChanged comes with it.
  void subjectChanged();
  void selectionChanged();
  void conflictChanged();

 private:
  friend class ChangeAnnotations;
  void connectViews();
  void set(const std::string& subject, const Annotations& annotations, const QString& what);
  Annotations begun(const std::string& subject) const;
  void beginIfNew(const std::string& subject);
  void onSessionStarted();
  void keep();
  void settleChosen();
  void show();
  void makeRoom();

  MainWindow& m_window;
  widgets::AnnotationPanel* m_panel;
  LibraryFeed* m_feed;
  std::unique_ptr<SubjectStage> m_stage;
  AnnotationBook m_book;
  AnnotationBook m_begun;  ///< as they were when they were first shown
  std::string m_library;   ///< name of the one that the book's takes are of
  int m_generation = 0;    ///< counts the books
  int m_activeTier = 0;
  int m_selected = 0;
  Conflict m_conflict = Conflict::Replace;
};

}  // namespace abrazo::app
