#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/motion/body/clip.hpp"
#include "core/motion/files/motion_reading.hpp"
#include "core/session/file/project.hpp"
#include "core/session/file/session_file.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

struct OpenedProject;

/// A session that was opened from its file. Its times and indices are those of the file.
struct RecordedSession {
  std::string file;
  std::shared_ptr<const FrameStore> frames;
  SessionContents contents;

  double last_s() const { return contents.last_s; }
  Markers markers() const;
};

/// What plays the user of a session.
enum class InputUse {
  Clip,        ///< the input, solved once over its length: nothing is live
  ClipAsLive,  ///< the input in a loop in real time, as if it were performed
  Stream,      ///< nobody, until a stream is connected
};

/// The data of a live session: a library, and a clip that plays the user. After a recorded session the clip
/// continues, or has a name and a rate but no poses.
struct Material {
  std::shared_ptr<const MotionLibrary> library;
  /// The library without the annotations that a session put into its takes since it was read, built or
  /// written. Null: it has none of them.
  std::shared_ptr<const MotionLibrary> unannotated;
  std::string library_file;  ///< library or manifest; empty if the library is not a file
  /// The manifest of a library that is not a file; null if it has none, or was changed since.
  std::shared_ptr<const Manifest> manifest;
  bool is_generated = false;  ///< the library can be generated again, by its name
  bool stands_in = false;     ///< the library replaces that of the project, which was not found
  Clip input;
  InputUse use = InputUse::Clip;
  /// The user asked for this input: it plays the user where a stream did. An input that came with a library
  /// does not.
  bool is_input_asked = false;
  /// How the input was read; without a file if it is a take of the library.
  MotionReading reading;
  /// The input's file is ambiguous (ImportReport::asks, or several performers), and the user was not asked
  /// yet.
  bool is_doubtful = false;
  std::vector<std::string> excluded_takes;  ///< the input's own take, where it comes from the library
  std::vector<std::string> warnings;
  std::shared_ptr<const RecordedSession> recorded;  ///< null: nothing was recorded before
  std::shared_ptr<const OpenedProject> project;     ///< null: not opened from a session file

  /// The library that its files have.
  const std::shared_ptr<const MotionLibrary>& library_of_files() const {
    return unannotated ? unannotated : library;
  }
  /// There is nothing but what was recorded.
  bool is_only_recorded() const { return recorded && input.poses.empty(); }
  /// The session is a clip: finite, and solved once over its length. What was recorded is a document already.
  bool is_clip() const { return use == InputUse::Clip && !recorded; }
  /// Longer clips are played as live: solved frames of this many take some 2 GB of memory.
  static constexpr std::uint64_t most_frames_solved = 120'000;
  bool is_too_long_to_solve() const { return input.poses.size() > most_frames_solved; }
  /// The input plays the user; otherwise nobody does until a stream is connected.
  bool input_plays() const { return is_clip() || (use == InputUse::ClipAsLive && !input.poses.empty()); }
  /// Motion, skeleton and joint map of the input; none if it is a take of the library.
  std::vector<std::string> input_files() const;
  /// The library is neither a file nor generated: closing the session loses it, except for its manifest.
  bool has_unsaved_library() const;
};

/// The active performer of a take in the library, world.
Clip clip_of_take(const MotionLibrary& library, int take);

/// What another session on the open library begins with: no recording, no project, and no annotations of its
/// takes, of which those that are saved are put in again.
Material for_next_session(const Material& open);

/// Another session on the open library, with its clip; with the last take where the session had none.
Material fresh_session(const Material& open);

/// The open material with a take of its library as the user; that take is then excluded from selection.
Material danced_with(const Material& open, int take);

/// Another session on the open library, with a take of it that the user asked for.
Material asked_dance(const Material& open, int take);

/// A library that was just built: its last take plays the user.
/// @param file  written library or manifest; empty: none
Material built_material(std::shared_ptr<const MotionLibrary> library, Manifest manifest, std::string file,
                        std::vector<std::string> warnings);

/// Writes the material into a project, so that it can be opened again: `data`, `library`, `manifest`,
/// `input`. References have only a path and a use; those of a library that another one replaces are
/// unchanged.
void describe(const Material& material, Project& project);

/// A project whose library is now in a file.
Project with_library_file(Project project, const std::string& file);

/// An unused file name for a library, in the folder of its session: "NAME.h5", "NAME (2).h5", ...
std::string library_file_beside(const std::string& session_file, const std::string& library_name);

/// Annotations of takes that the library does not have stay in the project.
/// @return names of annotated takes that the library does not have, with the number of annotations
std::vector<std::pair<std::string, std::size_t>> annotated_elsewhere(const AnnotationBook& book,
                                                                     const MotionLibrary& library);

}  // namespace abrazo
