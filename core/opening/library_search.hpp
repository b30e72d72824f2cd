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
  Material material;     ///< library and its origin; for a generated set also the input
  Status fits = Done{};  ///< an Error if frames were solved with a library of other content
};

/// Finds the library of a session, for the window and the command line: the given one, otherwise
/// the first of these that has the content with which the frames were solved:
///   1. the open library,
///   2. the files that the recording names: by their relative, then by their absolute path,
///   3. the library or manifest among the project's data, likewise,
///   4. the library built from the project's manifest,
///   5. a generated library of its name,
/// each unchanged, or with the project's annotations of its takes. If none has that content, the first with
/// its name or named by the project.
class LibrarySearch {
 public:
  explicit LibrarySearch(LibraryClues clues) : clues_(std::move(clues)) {}

  /// @param reference  null for a project without a recording
  /// @return an Error that lists the searched places
  Result<FoundLibrary> find(const SessionLibrary* reference, const Progress& progress = {});

  /// All libraries that the references name, each once, with a warning for each that was not found or
  /// differs. A given library comes last, with a warning if it is none of them.
  /// @return an Error if the given one cannot be read
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

/// For readers of a session file that need its libraries: the referenced library, or an Error, even if
/// a library of other content was found.
/// @param given  as LibraryClues::given   @param hint  advice at the end of the error for a library that is
/// not found
LibraryOpener library_opener(std::shared_ptr<const SessionFile> file, const std::string& given,
                             const std::string& hint);

/// Everything that a session file says about its libraries, without opening the session.
Result<LibraryClues> library_clues(const SessionFile& file, const std::string& given);

}  // namespace abrazo
