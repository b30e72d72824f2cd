#include "core/opening/library_search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "core/annotation/library_updates.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/opening/file_kinds.hpp"
#include "core/opening/generated_set.hpp"
#include "core/opening/opened_session.hpp"
#include "core/session/file/library_reference.hpp"

namespace abrazo {
namespace {

using LibraryPtr = std::shared_ptr<const MotionLibrary>;
using Use = DataReference::Use;

/// The library with the annotations of the session put into its takes; null without such annotations.
LibraryPtr annotated(const LibraryPtr& library, const AnnotationBook& book) {
  TakeAnnotations takes;
  for (const auto& [name, annotations] : book) {
    const int index = library->find_take(name);
    if (index < 0) continue;
    const LibraryTake& take = library->takes()[static_cast<std::size_t>(index)];
    if (auto said = take_annotation(annotations, take.fps, take.frames)) takes[name] = std::move(*said);
  }
  const auto done = with_updates(library, *library, takes);
  return done && *done != library ? *done : nullptr;
}

/// Of what is open the library alone, and where it is from.
Material library_of(const Material& open) {
  Material material;
  material.library = open.library_of_files();
  material.library_file = open.library_file;
  material.manifest = open.manifest;
  material.is_generated = open.is_generated;
  return material;
}

bool was_a_file(const SessionLibrary& library) {
  return !library.relative_path.empty() || !library.absolute_path.empty();
}

bool same(const SessionLibrary& a, const SessionLibrary& b) {
  return a.fingerprint == b.fingerprint && a.pairs == b.pairs && a.absolute_path == b.absolute_path &&
         a.relative_path == b.relative_path && a.name == b.name;
}

Result<Material> built_from(const Manifest& manifest, const Progress& progress) {
  Material material;
  auto library = build_library(manifest, {}, progress, material.warnings);
  if (!library) return library.error();
  material.library = std::make_shared<const MotionLibrary>(std::move(*library));
  return material;
}

Result<Material> built_again(const OpenedProject& project, const Progress& progress) {
  auto manifest = kept_manifest(project);
  if (!manifest) return manifest.error();
  auto material = built_from(*manifest, progress);
  if (material) material->manifest = std::make_shared<const Manifest>(std::move(*manifest));
  return material;
}

Result<Material> read_from(const std::string& file, const Progress& progress) {
  if (kind_of_file(file) == FileKind::Manifest) {
    const auto manifest = read_manifest(file);
    return manifest ? built_from(*manifest, progress) : Result<Material>(manifest.error());
  }
  auto library = read_library(file);
  if (!library) return library.error();
  Material material;
  material.library = std::make_shared<const MotionLibrary>(std::move(*library));
  return material;
}

}  // namespace

Result<Material> open_library(const std::string& file, const Progress& progress) {
  report(progress, 0, "Opening " + std::filesystem::path(file).filename().string());
  auto material = read_from(file, progress);
  if (!material) return material;
  if (material->library->pair_count() == 0)
    return Error{"has no pairs; open one with at least one take", file};
  material->library_file = file;
  return material;
}

/// Where it may be.
struct LibrarySearch::Place {
  /// Whether what is there will do where nothing has the content of the reference.
  enum class Otherwise { No, IfOfThatName, Yes };
  std::function<Result<Material>(const Progress&)> open;
  Otherwise otherwise = Otherwise::IfOfThatName;
};

std::vector<LibrarySearch::Place> LibrarySearch::places(const SessionLibrary* reference) const {
  using Otherwise = Place::Otherwise;
  std::vector<Place> places;
  std::vector<std::string> files;
  const auto add_file = [&](const std::string& file, Otherwise otherwise) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored) || std::ranges::find(files, file) != files.end()) return;
    files.push_back(file);
    places.push_back({[file](const Progress& progress) { return open_library(file, progress); }, otherwise});
  };
  const Project& project = clues_.project->project();
  const std::string name = reference ? reference->name : project.library;
  const bool named_a_file = reference && std::ranges::any_of(clues_.references, [&](const auto& each) {
                              return each.name == name && was_a_file(each);
                            });
  if (reference && clues_.open.library)
    places.push_back({[this](const Progress&) { return library_of(clues_.open); },
                      named_a_file ? Otherwise::No : Otherwise::IfOfThatName});
  // The newest first. What takes of it were annotated with while it was recorded is a library that was no
  // file.
  for (auto each = clues_.references.rbegin(); reference && each != clues_.references.rend(); ++each)
    if (each->name == name)
      for (const std::string& file : places_of(*each, clues_.session))
        add_file(file, Otherwise::IfOfThatName);
  // The project's is the one that was used last, whatever stood in for it since.
  const bool is_last = !reference || clues_.references.empty() ||
                       (project.library.empty() ? clues_.references.back().name : project.library) == name;
  const Otherwise of_project = is_last ? Otherwise::Yes : Otherwise::IfOfThatName;
  for (const Use use : {Use::Library, Use::Manifest})
    if (const std::string file = clues_.project->place_of(use); !file.empty()) add_file(file, of_project);
  if (!project.manifest.empty())
    places.push_back(
        {[this](const Progress& progress) { return built_again(*clues_.project, progress); }, of_project});
  if (const auto generate = generated_of_name(name); generate && !named_a_file) places.push_back({generate});
  return places;
}

/// The library of the reference made of one that may be it: as it is, or with what was said of its takes.
FoundLibrary LibrarySearch::made_of(Material base, const SessionLibrary* reference) const {
  FoundLibrary found{std::move(base), Done{}};
  if (!reference) return found;
  found.fits = check_session_library(*reference, *found.material.library);
  if (found.fits) return found;
  const LibraryPtr library = annotated(found.material.library, clues_.project->project().annotations);
  if (!library || !check_session_library(*reference, *library)) return found;
  found.fits = Done{};
  found.material.unannotated = std::exchange(found.material.library, library);
  return found;
}

Error LibrarySearch::not_found(const SessionLibrary* reference) const {
  const OpenedProject& project = *clues_.project;
  for (const std::size_t index : project.missing())
    if (!reference && is_of_library(project.project().data[index].use))
      return {std::filesystem::path(project.project().data[index].absolute_path).filename().string() +
                  " is not there",
              clues_.session};
  if (!reference)
    return {fmt::format("its library \"{}\" was not saved as a file", project.project().library),
            clues_.session};
  if (!was_a_file(*reference))
    return {fmt::format("was solved with the library \"{}\", which was not a file", reference->name),
            clues_.session};
  return {
      fmt::format("its library \"{}\" was looked for as {} and is not there; put it beside the session file",
                  reference->name, fmt::join(places_of(*reference, clues_.session), " and ")),
      clues_.session};
}

Result<FoundLibrary> LibrarySearch::search(const SessionLibrary* reference, const Progress& progress) const {
  std::optional<FoundLibrary> other;
  std::optional<Error> trouble;
  for (const Place& place : places(reference)) {
    auto base = place.open(progress);
    if (!base) {
      if (!trouble) trouble = base.error();
      continue;
    }
    FoundLibrary found = made_of(std::move(*base), reference);
    if (found.fits) return found;
    const bool will_do =
        place.otherwise == Place::Otherwise::Yes || (place.otherwise == Place::Otherwise::IfOfThatName &&
                                                     found.material.library->name() == reference->name);
    if (!other && will_do) other = std::move(found);
  }
  if (other) return *std::move(other);
  return trouble ? *trouble : not_found(reference);
}

Result<FoundLibrary> LibrarySearch::find(const SessionLibrary* reference, const Progress& progress) {
  if (last_ && reference == last_reference_) return *last_;
  if (!clues_.given.empty() && !given_) {
    auto given = open_library(clues_.given, progress);
    if (!given) return given.error();
    given_ = std::move(*given);
  }
  auto found = given_ ? Result<FoundLibrary>(made_of(*given_, reference)) : search(reference, progress);
  if (!found) return found;
  last_ = *found;
  last_reference_ = reference;
  return found;
}

Result<std::vector<LibraryPtr>> LibrarySearch::all(std::vector<std::string>& warnings,
                                                   const Progress& progress) {
  std::vector<LibraryPtr> libraries;
  const auto& references = clues_.references;
  bool given_fits = references.empty();
  if (!clues_.given.empty()) {
    auto given = open_library(clues_.given, progress);
    if (!given) return given.error();
    given_ = std::move(*given);
  }
  for (auto reference = references.begin(); reference != references.end(); ++reference) {
    if (std::any_of(references.begin(), reference, [&](const auto& one) { return same(one, *reference); }))
      continue;
    if (given_ && (made_of(*given_, &*reference).fits || has_motion_of(*reference, *given_->library))) {
      given_fits = true;
      continue;
    }
    const auto found = search(&*reference, progress);
    const Status there = found ? found->fits : Status(found.error());
    if (there || (found && has_motion_of(*reference, *found->material.library)))
      libraries.push_back(found->material.library);
    else
      warnings.push_back(there.error().text() + "; frames solved with it have no mesh");
  }
  if (given_ && !given_fits)
    warnings.push_back(check_session_library(references.back(), *given_->library).error().text() +
                       "; meshes may be wrong");
  if (given_) libraries.push_back(given_->library);
  return libraries;
}

LibraryOpener library_opener(std::shared_ptr<const SessionFile> file, const std::string& given,
                             const std::string& hint) {
  struct Lazy {
    std::optional<LibrarySearch> search;
  };
  return [file = std::move(file), given, hint,
          lazy = std::make_shared<Lazy>()](const SessionLibrary* reference) -> Result<LibraryAtHand> {
    if (!reference && given.empty())
      return Error{"does not say which library it was solved with" + hint, file->path()};
    if (!lazy->search) {
      auto clues = library_clues(*file, given);
      if (!clues) return clues.error();
      lazy->search.emplace(std::move(*clues));
    }
    const auto found = lazy->search->find(reference);
    if (!found)
      return given.empty() ? Error{found.error().message + hint, found.error().where} : found.error();
    const Material& material = found->material;
    if (!found->fits)
      return Error{found->fits.error().message + (given.empty() ? hint : ""),
                   material.library_file.empty() ? material.library->name() : material.library_file};
    return LibraryAtHand{material.library, given.empty() ? reference->name : given};
  };
}

Result<LibraryClues> library_clues(const SessionFile& file, const std::string& given) {
  auto project = file.project();
  if (!project) return project.error();
  return LibraryClues{file.path(),
                      file.contents().libraries,
                      std::make_shared<const OpenedProject>(located(file.path(), std::move(*project))),
                      given,
                      {}};
}

}  // namespace abrazo
