#include "core/session/run/save_session.hpp"

#include <filesystem>

#include "core/base/atomic_file.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/session/run/recorder.hpp"

namespace abrazo {
namespace {

namespace fs = std::filesystem;

/// Completed references for the session file; for missing files the saved ones.
Project with_contents(const SessionToSave& what) {
  Project project = what.project;
  for (DataReference& data : project.data) {
    if (auto completed = reference_to(data.absolute_path, data.use, what.to)) {
      data = std::move(*completed);
      continue;
    }
    for (const DataReference& old : what.saved.data)
      if (old.use == data.use && old.absolute_path == data.absolute_path) data = old;
  }
  return project;
}

Status save_copy(const SessionToSave& what, const Project& project) {
  std::error_code trouble;
  if (fs::exists(what.to + "-wal", trouble))
    return Error{"another program or window is recording into this file; choose another name", what.to};
  if (what.recorder)
    if (const Status flushed = what.recorder->flush(); !flushed) return flushed;
  AtomicFile copy(what.to);
  const std::string partial = copy.partial().string();
  const bool has_frames = !what.file.empty() && fs::exists(what.file, trouble);
  Status done = has_frames ? copy_session(what.file, partial) : Status(Done{});
  if (done) done = save_project(partial, project);
  if (done) done = edit_session_takes(partial, what.takes);
  if (done) done = copy.commit();
  if (!done) return Error{done.error().message, what.to};
  return done;
}

Status save_to(const SessionToSave& what, const Project& project) {
  if (what.to != what.file) return save_copy(what, project);
  if (!what.recorder) return save_project(what.to, project);
  what.recorder->save_project(std::make_shared<const Project>(project));
  return what.recorder->flush();
}

}  // namespace

Result<Project> save_session(const SessionToSave& what, const Progress& progress) {
  const bool with_library = !what.library_file.empty();
  std::error_code ignored;
  const bool was_there = with_library && fs::exists(what.library_file, ignored);
  if (with_library)
    if (const Status written = write_library(*what.library, what.library_file, progress); !written)
      return written.error();
  Project project = with_contents(what);
  const Status saved = save_to(what, project);
  if (saved) return project;
  if (with_library && !was_there) fs::remove(what.library_file, ignored);
  return saved.error();
}

}  // namespace abrazo
