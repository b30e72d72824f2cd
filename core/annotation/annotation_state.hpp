#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/annotation/label_edits.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// The annotations that a subject begins with: of a take those that the library has; of the session ("") its
/// words, with nothing said. With a tier for notes, and a key for every value of roles (a, b) and moves (1 to
/// 9) where none has one.
Annotations begun_annotations(const MotionLibrary& library, const std::string& subject);

/// One edit of the annotations of a subject, as a value that can be taken back.
struct AnnotationStep {
  std::uint64_t book = 0;  ///< of which book; in another it is of no use
  std::string subject;     ///< "" = the session
  Annotations before, after;
  std::string what;  ///< "draw turn"
};

/// What is annotated in a session and the takes of its library, which subject is shown, and what of it is
/// chosen. Subjects have names: "" is the session, others are takes.
class AnnotationState {
 public:
  const std::string& subject() const { return subject_; }
  bool shows_take() const { return !subject_.empty(); }
  const Annotations& annotations() const { return annotations_of(subject_); }
  /// Empty when nothing was said of it and it was not shown.
  const Annotations& annotations_of(const std::string& subject) const;
  /// Of every subject that was shown or is in the book that was set.
  const AnnotationBook& all() const { return book_; }
  /// Of the subjects of which something else is said than was when they were first shown.
  AnnotationBook changed() const;

  /// A session on a library begins and is shown. What was said of takes stays when the library has the same
  /// name and the takes. Steps before are of no use.
  void start(const MotionLibrary& library);
  /// In place of all there is: what a project had. Steps before are of no use.
  /// @param library  of the session; null when there is none
  void set_book(AnnotationBook book, const MotionLibrary* library);
  /// Shows a subject; its first tier of moves is active.
  void show(const std::string& subject, const MotionLibrary& library);

  int tier() const { return tier_; }          ///< id of the active one; 0 = none
  int selected() const { return selected_; }  ///< id of the selected annotation; 0 = none
  Conflict conflict() const { return conflict_; }
  /// A label of another tier is not selected any more. @return whether there is such a tier, not active yet
  bool choose_tier(int tier);
  /// Its tier is active then. @param annotation  0 = none. @return whether the selection is another
  bool select(int annotation);
  void set_conflict(Conflict conflict) { conflict_ = conflict; }

  /// The step that leads to other annotations of a subject; nothing when they are as they are.
  std::optional<AnnotationStep> step(const std::string& subject, Annotations next, std::string what) const;
  enum class Direction { Do, Undo };
  /// @return whether the step is of this book; if not, nothing changes
  bool apply(const AnnotationStep& step, Direction direction);

 private:
  void begin_if_new(const std::string& subject, const MotionLibrary& library);
  void settle_chosen();

  AnnotationBook book_;
  AnnotationBook begun_;  ///< as they were when they were first shown
  std::string subject_;
  std::string library_;       ///< name of the one that the book's takes are of
  std::uint64_t number_ = 0;  ///< counts the books
  int tier_ = 0;
  int selected_ = 0;
  Conflict conflict_ = Conflict::Replace;
};

}  // namespace abrazo
