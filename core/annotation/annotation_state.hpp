#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/annotation/label_edits.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Initial annotations of a subject: those of the library for a take; for the session ("") empty tiers with
/// the library's vocabulary. With a tier for notes, and keys for the values of roles (a, b) and moves (1 to
/// 9) if none has a key.
Annotations begun_annotations(const MotionLibrary& library, const std::string& subject);

/// One undoable edit of the annotations of a subject, as a value.
struct AnnotationStep {
  std::uint64_t book = 0;  ///< number of its book; invalid in another
  std::string subject;     ///< "" = the session
  Annotations before, after;
  std::string what;  ///< "draw turn"
};

/// The annotations of a session and the takes of its library, the shown subject and the selection in it.
/// Subjects have names: "" is the session, others are takes.
class AnnotationState {
 public:
  const std::string& subject() const { return subject_; }
  bool shows_take() const { return !subject_.empty(); }
  const Annotations& annotations() const { return annotations_of(subject_); }
  /// Empty if it has no annotations and was not shown.
  const Annotations& annotations_of(const std::string& subject) const;
  /// All subjects that were shown or are in the book that was set.
  const AnnotationBook& all() const { return book_; }
  /// The subjects whose annotations changed since they were first shown.
  AnnotationBook changed() const;

  /// Begins a session on a library and shows it. Annotations of takes stay if the library has the same name
  /// and these takes. Invalidates previous steps.
  void start(const MotionLibrary& library);
  /// Replaces everything by the book of a project. Invalidates previous steps.
  /// @param library of the session; null if there is none
  void set_book(AnnotationBook book, const MotionLibrary* library);
  /// Shows a subject; its first tier of moves is active.
  void show(const std::string& subject, const MotionLibrary& library);

  int tier() const { return tier_; }          ///< id of the active one; 0 = none
  int selected() const { return selected_; }  ///< id of the selected annotation; 0 = none
  Conflict conflict() const { return conflict_; }
  /// Activates a tier and deselects an annotation of another tier. @return false if it does not exist or is
  /// active already
  bool choose_tier(int tier);
  /// Selects an annotation and activates its tier. @param annotation 0 = none. @return whether the selection
  /// changed
  bool select(int annotation);
  void set_conflict(Conflict conflict) { conflict_ = conflict; }

  /// The step to other annotations of a subject; none if nothing changes.
  std::optional<AnnotationStep> step(const std::string& subject, Annotations next, std::string what) const;
  enum class Direction { Do, Undo };
  /// @return false, without a change, if the step is of another book
  bool apply(const AnnotationStep& step, Direction direction);

 private:
  void begin_if_new(const std::string& subject, const MotionLibrary& library);
  void settle_chosen();

  AnnotationBook book_;
  AnnotationBook begun_;  ///< as first shown
  std::string subject_;
  std::string library_;       ///< name of the library of the book's takes
  std::uint64_t number_ = 0;  ///< counts the books
  int tier_ = 0;
  int selected_ = 0;
  Conflict conflict_ = Conflict::Replace;
};

}  // namespace abrazo
