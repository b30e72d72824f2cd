#pragma once

#include <string>
#include <utility>

#include "core/annotation/annotations.hpp"
#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Initial annotations of a subject: those of the library for a take; for the session ("") empty tiers with
/// the library's vocabulary. With a tier for notes, and keys for the values of roles (a, b) and moves (1 to
/// 9) if none has a key.
Annotations begun_annotations(const MotionLibrary& library, const std::string& subject);

/// The annotations of a session ("") and of the takes of its library, by name. A library is that of the files
/// here: one with the annotations in it would have its words in another order, and so other keys.
class LiveAnnotations {
 public:
  /// Empty if it has no annotations and was not begun.
  const Annotations& of(const std::string& subject) const;
  /// All subjects that were begun or are in the book that was opened.
  const AnnotationBook& all() const { return book_; }
  /// The subjects whose annotations changed since they were begun.
  AnnotationBook changed() const;
  /// Counts the books: an edit is invalid in another one.
  int number() const { return number_; }

  /// Begins a session on a library. Annotations of takes that are saved stay if the library has the same name
  /// and these takes; all others are dropped.
  void start(const MotionLibrary& library);
  /// Replaces everything by the book of a project.
  /// @param is_saved  it is in the session's file; false for work that was restored after a crash
  void open(AnnotationBook book, const MotionLibrary& library, bool is_saved);
  /// The book is in a session file now.
  void note_saved(AnnotationBook book) { saved_ = std::move(book); }
  /// Before a subject is shown: gives it its initial annotations, if it has none, with the words of the
  /// others.
  void begin(const std::string& subject, const MotionLibrary& library);
  void put(const std::string& subject, const Annotations& annotations) { book_[subject] = annotations; }

 private:
  AnnotationBook book_;
  AnnotationBook begun_;  ///< as first shown
  AnnotationBook saved_;  ///< as the last saved or opened file has them
  std::string library_;   ///< name of the library of the book's takes
  int number_ = 0;
};

}  // namespace abrazo
