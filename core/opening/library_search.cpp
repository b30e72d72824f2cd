#include "app/workbench/document/recorded_session.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>

#include "app/workbench/document/generated_material.hpp"
#include "core/annotation/annotated_library.hpp"
#include "core/session/file/library_reference.hpp"
#include "core/session/file/recorded_frames.hpp"
#include "core/session/frames/frame_history.hpp"

namespace abrazo::app {
namespace {

using LibraryPtr = std::shared_ptr<const MotionLibrary>;

/// What the frames of the file were solved with last.
Result<SessionLibrary> reference_of(const SessionContents& contents, const std::string& file) {
  if (contents.libraries.empty()) return Error{"does not say which library it was solved with", file};
  return contents.libraries.back();
}

/// The session's library and where it is from.
struct Found {
  LibraryPtr library;
  std::string file;
  std::vector<std::string> warnings;
  /// As it was before takes of it were annotated in the window: earlier frames may be of that. Or null.
  LibraryPtr before = nullptr;
};

/// With what a person said of its takes, as the window puts it in; null when there is nothing of that.
LibraryPtr annotated(const LibraryPtr& library, const AnnotationBook& book) {
  LibraryPtr done;
  for (const auto& [name, annotations] : book) {
    const int index = library->find_take(name);
    if (index < 0) continue;
    const LibraryTake& take = library->takes()[static_cast<std::size_t>(index)];
    const auto said = take_annotation(annotations, take.fps, take.frames);
    if (!said) continue;
    auto next = with_annotation(done ? *done : *library, name, *said);
    if (!next) return nullptr;
    done = std::make_shared<const MotionLibrary>(std::move(*next));
  }
  return done;
}

/// The library of the reference made of one that may be it: as it is, or with what was said of its takes.
std::optional<Found> made_of(const Found& base, const SessionLibrary& reference, const AnnotationBook& book) {
  if (check_session_library(reference, *base.library)) return base;
  const LibraryPtr library = annotated(base.library, book);
  if (!library || !check_session_library(reference, *library)) return std::nullopt;
  return Found{library, base.file, base.warnings, base.library};
}

/// Another in its place.
Found instead_of(const SessionLibrary& reference, Found other) {
  const Status same = check_session_library(reference, *other.library);
  if (!same)
    other.warnings.push_back(same.error().text() +
                             "; meshes and selected pairs of the recorded frames may be wrong");
  return other;
}

Result<Found> given_library(const SessionLibrary& reference, const std::string& given,
                            const AnnotationBook& book, const Progress& progress) {
  auto opened = load_material({given}, {}, progress);
  if (!opened) return opened.error();
  const Found base{opened->library, given, {}};
  if (auto found = made_of(base, reference, book)) return *found;
  return instead_of(reference, base);
}

/// Files that the recording names for a library of this name, the newest first. What takes of it were
/// annotated with while it was recorded is a library that was no file.
std::vector<std::string> session_files_of(const SessionContents& contents, const std::string& name,
                                          const std::string& session) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  std::error_code ignored;
  for (auto each = contents.libraries.rbegin(); each != contents.libraries.rend(); ++each) {
    if (each->name != name) continue;
    for (const fs::path& place :
         {each->relative_path.empty() ? fs::path()
                                      : fs::absolute(session).parent_path() / each->relative_path,
          fs::path(each->absolute_path)}) {
      const std::string file = place.lexically_normal().string();
      if (!file.empty() && fs::exists(file, ignored) && std::ranges::find(files, file) == files.end())
        files.push_back(file);
    }
  }
  return files;
}

/// What may be the library, by its name: what is open, what the recording names, or what can be generated.
std::vector<Found> of_that_name(const SessionContents& contents, const OpenedProject& project,
                                const Material& open, const Progress& progress) {
  const SessionLibrary& reference = contents.libraries.back();
  std::vector<Found> bases;
  const auto add = [&](const LibraryPtr& library, const std::string& file) {
    if (library && library->name() == reference.name) bases.push_back({library, file, {}});
  };
  for (const std::string& file : session_files_of(contents, reference.name, project.file))
    if (const auto read = load_material({file}, {}, progress)) add(read->library, file);
  const bool was_a_file = std::ranges::any_of(contents.libraries, [&](const SessionLibrary& each) {
    return each.name == reference.name && !(each.relative_path.empty() && each.absolute_path.empty());
  });
  if (was_a_file) return bases;
  for (const auto make : {make_demo, make_fight})
    if (const auto made = make(progress)) add(made->library, "");
  add(open.library, open.library_file);  // built in the window and never saved, say
  return bases;
}

double rate_of(const SessionContents& contents) {
  double lasted_s = 0;
  std::uint64_t frames = 0;
  for (const SessionRun& run : contents.runs)
    if (run.frames > 1) {
      lasted_s += run.last_s - run.first_s;
      frames += run.frames - 1;
    }
  return lasted_s > 0 ? static_cast<double>(frames) / lasted_s : 0;
}

}  // namespace

Markers RecordedSession::markers() const {
  Markers markers;
  for (const SessionMarker& marker : contents.markers) markers.add(marker.time_s, marker.name);
  return markers;
}

namespace {

Error not_found(const SessionLibrary& reference, const std::string& file) {
  if (reference.relative_path.empty() && reference.absolute_path.empty())
    return {"was solved with the library \"" + reference.name +
                "\", which was not saved as a file; open the session together with that library "
                "(both files at once)",
            file};
  const auto opened = open_session_library(reference, file);
  const Error why = opened ? Error{"its library has changed", file} : opened.error();
  return {why.message + "; open the session together with its library (both files at once)", why.where};
}

/// The library that the frames were solved with; another one where that is all there is of its name, or where
/// a person said that it will do.
Result<Found> library_of(const SessionContents& contents, const OpenedProject& project,
                         const std::string& given, const Material& open, const Progress& progress,
                         bool may_be_another) {
  const SessionLibrary& reference = contents.libraries.back();
  const AnnotationBook& book = project.project().annotations;
  if (!given.empty()) return given_library(reference, given, book, progress);
  if (open.library)
    if (auto found = made_of({open.library, open.library_file, {}}, reference, book)) return *found;
  const std::vector<Found> bases = of_that_name(contents, project, open, progress);
  for (const Found& base : bases)
    if (auto found = made_of(base, reference, book)) return *found;
  for (const auto use : {DataReference::Use::Library, DataReference::Use::Manifest})
    if (const std::string place = project.place_of(use); !place.empty())
      return given_library(reference, place, book, progress);
  if (!bases.empty()) return instead_of(reference, bases.front());
  if (!may_be_another) return not_found(reference, project.file);
  auto demo = make_demo(progress);
  if (!demo) return demo.error();
  return Found{demo->library,
               "",
               {"its library '" + reference.name +
                "' is not there: the generated dance stands in for it; the "
                "bodies are as recorded, meshes and selected pairs of the recorded frames are wrong"}};
}

Result<Material> load_recorded(const std::shared_ptr<const SessionFile>& session,
                               const OpenedProject& project, const std::string& library, const Material& open,
                               const Progress& progress, bool may_be_another) {
  const std::string& file = project.file;
  const SessionContents& contents = session->contents();
  const auto reference = reference_of(contents, file);
  if (!reference) return reference.error();
  auto found = library_of(contents, project, library, open, progress, may_be_another);
  if (!found) return found.error();
  auto frames = RecordedFrames::open(file, found->library);
  if (!frames) return frames.error();
  if (found->before) (*frames)->add_library(found->before);
  // Timeline and plots ask for it as soon as it is open, on the window's thread: then it is there.
  const FrameStore::Span span = (*frames)->span();
  report(progress, 0.8, "Reading the recorded frames");
  (*frames)->between(span.first_index, span.last_index, FrameHistory::overview_frames);
  auto recorded = std::make_shared<RecordedSession>();
  recorded->file = file;
  recorded->frames = *frames;
  recorded->contents = contents;
  Material material;
  material.library = found->library;
  material.library_file = found->file;
  material.excluded_takes = reference->excluded_takes;
  material.input.name = std::filesystem::path(file).stem().string();
  material.input.fps = rate_of(contents);
  material.warnings = session->recovery();
  const auto& damage = project.reading.damage;
  std::ranges::copy_if(damage, std::back_inserter(material.warnings), [&](const std::string& sentence) {
    return std::ranges::find(session->recovery(), sentence) == session->recovery().end();
  });
  material.warnings.insert(material.warnings.end(), found->warnings.begin(), found->warnings.end());
  material.recorded = std::move(recorded);
  return material;
}

}  // namespace

Result<Material> load_session(const std::string& file, const std::string& library, const Material& open,
                              const Progress& progress, const Places& places) {
  report(progress, 0, "Opening " + std::filesystem::path(file).filename().string());
  auto project = open_project(file, places);
  if (!project) return project.error();
  std::error_code ignored;
  std::shared_ptr<const SessionFile> session;
  if (!(*project)->file.empty() && std::filesystem::exists((*project)->file, ignored)) {
    auto opened = SessionFile::open((*project)->file);
    if (!opened) return opened.error();
    session = *opened;
  }
  auto material = session && session->contents().frames > 0
                      ? load_recorded(session, **project, library, open, progress, !places.empty())
                  : (*project)->reading.is_saved
                      ? material_of(**project, progress)
                      : Result<Material>(Error{"has no frames: nothing was recorded into it", file});
  if (!material) return material.error();
  material->project = *project;
  return material;
}

}  // namespace abrazo::app
