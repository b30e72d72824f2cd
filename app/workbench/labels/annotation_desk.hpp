#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <string>

#include "core/annotation/annotation_state.hpp"

namespace abrazo::widgets {
class AnnotationPanel;
}

namespace abrazo::app {

class LibraryFeed;
class MainWindow;
class SubjectStage;

/// Shows what is annotated and passes on what is asked of it: the timeline's lanes and the panel show the
/// state, every edit becomes a step of undo, and what is said of takes goes into the library of the running
/// session a moment later.
class AnnotationDesk : public QObject {
  Q_OBJECT
 public:
  explicit AnnotationDesk(MainWindow& window);
  ~AnnotationDesk() override;

  /// "" = the session.
  const std::string& subject() const { return m_state.subject(); }
  bool showsTake() const { return m_state.shows_take(); }
  const Annotations& annotations() const { return m_state.annotations(); }
  const Annotations& annotations_of(const std::string& subject) const {
    return m_state.annotations_of(subject);
  }
  int activeTier() const { return m_state.tier(); }
  int selected() const { return m_state.selected(); }
  Conflict conflict() const { return m_state.conflict(); }
  /// Lanes and keys of labels are there: for a take, once something is said of the session, and while the
  /// panel is open.
  bool isOpen() const;
  /// Where an edit takes place now.
  EditPlace place() const;

  /// Of the shown subject, as a step of undo; what prevents it is reported. @return whether it was done
  bool edit(const Result<LabelEdit>& edit);
  /// @param what  "draw turn": for the menu and the message
  void change(Annotations next, const QString& what);
  void setActiveTier(int tier);
  /// @param annotation  0 = none
  void select(int annotation);
  void setConflict(Conflict conflict);

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

  /// The panel "Annotation"; a section below its lists is added with AnnotationPanel::addSection.
  widgets::AnnotationPanel& panel() const { return *m_panel; }
  LibraryFeed& feed() const { return *m_feed; }

 signals:
  /// Anything of the state: annotations, suggestions, vocabularies, the subject, what is chosen.
  void changed();
  /// Another subject is shown, or a session or project began; `changed` comes with it.
  void subjectChanged();

 private:
  friend class AnnotationCommand;
  void connectViews();
  bool apply(const AnnotationStep& step, AnnotationState::Direction direction);
  void onSessionStarted();
  void onOtherBook();
  void keep();
  void tell();
  void show();
  void makeRoom();

  MainWindow& m_window;
  widgets::AnnotationPanel* m_panel;
  LibraryFeed* m_feed;
  std::unique_ptr<SubjectStage> m_stage;
  AnnotationState m_state;
};

}  // namespace abrazo::app
