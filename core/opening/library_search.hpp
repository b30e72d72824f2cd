#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.hpp"
#include "core/opening/material.hpp"
#include "core/session/export/export_source.hpp"

namespace abrazo {

/// A library file, or a manifest (.json) that is built. @return an Error when there are no pairs in it
Result<Material> open_library(const std::string& file, const Progress& progress);

/// What is known of where the library of a session may be.
struct LibraryClues {
  std::string session;                     ///< path of its file, for relative paths and messages
  std::vector<SessionLibrary> references;  ///< that its frames were solved with, oldest first
  /// Its data, the manifest that its library was built from, and what was said of takes.
  std::shared_ptr<const OpenedProject> project;
  std::string given;  ///< library or manifest that a person named; empty = none
  Material open;      ///< without a library where nothing is open
};

struct FoundLibrary {
  Material material;  ///< library and where it is from; of a generated set the input as well
  /// As it was before takes of it were annotated in the window: earlier frames may be of that. Or null.
  std::shared_ptr<const MotionLibrary> before;
  Status fits = Done{};  ///< an Error when frames were solved with other content than it has
};

/// The one way to the library of a session, for the window and the command line: the one that was given, else
/// the first that has the content the frames were solved with of
///   1. what is open,
///   2. the files that the recording names for it: beside the session, then where they were,
///   3. the library or manifest among the project's data, likewise,
///   4. what the manifest builds that the project keeps,
///   5. what can be generated under its name,
/// each as it is, or with what the project says of its takes. Where none has that content, the first that has
/// its name or is named by the project.
class LibrarySearch {
 public:
  explicit LibrarySearch(LibraryClues clues) : clues_(std::move(clues)) {}

  /// @param reference  null: of a project in which nothing was recorded
  /// @return an Error that says where it was looked for
  Result<FoundLibrary> find(const SessionLibrary* reference, const Progress& progress = {});

  /// All that the references name, each once, with a warning for each that was not found or is another. One
  /// that was given comes last, and with a warning where it is none of them.
  /// @return an Error when the given one cannot be read
  Result<std::vector<std::shared_ptr<const MotionLibrary>>> all(std::vector<std::string>& warnings,
                                                                const Progress& progress = {});

 private:
  struct Place;
  std::vector<Place> places(const SessionLibrary* reference) const;
  Result<FoundLibrary> search(const SessionLibrary* reference, const Progress& progress) const;
  FoundLibrary made_of(Material base, const SessionLibrary* reference) const;
  Error not_found(const SessionLibrary* reference) const;

  LibraryClues clues_;
  std::optional<Material> given_;     ///< once it was read
  std::optional<FoundLibrary> last_;  ///< of `last_reference_`
  const SessionLibrary* last_reference_ = nullptr;
};

/// For what goes through a session file and needs its libraries: the one of the reference or an Error, also
/// where only another is at hand.
/// @param given  as LibraryClues::given   @param hint  ends the errors of one that is not found: what to do
LibraryOpener library_opener(std::shared_ptr<const SessionFile> file, const std::string& given,
                             const std::string& hint);

/// Of a session file that is gone through, and not opened: all that it says of its libraries.
Result<LibraryClues> library_clues(const SessionFile& file, const std::string& given);

}  // namespace abrazo
