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

/// Connects annotations with their views: the timeline's lanes and the panel show the state, every edit
/// becomes an undo step, and annotations of takes go into the library of the running session shortly
/// afterwards.
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
  /// Whether lanes and keys of labels are active: for a take, if the session has annotations, and while the
  /// panel is open.
  bool isOpen() const;
  /// The present context of an edit.
  EditPlace place() const;

  /// Edits the shown subject as an undo step; errors are reported. @return whether it was done
  bool edit(const Result<LabelEdit>& edit);
  /// @param what "draw turn": for menu and message
  void change(Annotations next, const QString& what);
  void setActiveTier(int tier);
  /// @param annotation  0 = none
  void select(int annotation);
  void setConflict(Conflict conflict);

  /// Replaces all annotations by those of a project. Removes the undo steps of the previous ones; updates the
  /// takes of the library.
  void setBook(AnnotationBook book);

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

 signals:
  /// Any part of the state changed: annotations, suggestions, vocabularies, subject, selection.
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

  MainWindow& m_window;
  widgets::AnnotationPanel* m_panel;
  LibraryFeed* m_feed;
  std::unique_ptr<SubjectStage> m_stage;
  AnnotationState m_state;
};

}  // namespace abrazo::app
