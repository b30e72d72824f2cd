#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/annotation/annotated_library.hpp"
#include "core/choreography/demo_set.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/opening/material.hpp"
#include "core/opening/opened_session.hpp"
#include "tests/core/session/recorded_session.hpp"

namespace abrazo::test {

using LibraryPtr = std::shared_ptr<const MotionLibrary>;

/// Motions of two takes, their labels and a manifest in a folder. @return path of the manifest
inline std::string two_takes(const TemporaryFolder& folder, const std::string& name = "captures") {
  const auto manifest = write_demo_set({swinging_take("take_01", 60, 1), swinging_take("take_02", 60, 2)},
                                       name, folder.file(name), {});
  return manifest->string();
}

/// What the window has after a library was built of them and not saved.
inline Material built_of(const std::string& manifest_file) {
  const Manifest manifest = *read_manifest(manifest_file);
  std::vector<std::string> warnings;
  auto library = std::make_shared<const MotionLibrary>(*build_library(manifest, {}, {}, warnings));
  return built_material(library, manifest, "", {});
}

/// Half a second that was solved with a library, in a session file.
inline void record(const std::string& path, const LibraryPtr& library, const std::string& library_file,
                   const std::vector<std::string>& excluded = {}) {
  DrivenSession session;
  auto synthesizer = std::move(*PartnerSynthesizer::create(library, responsive_by_pose(), excluded));
  auto source = std::make_unique<ClipSource>(swinging_take("user", 300, 4).a);
  session.loop = std::make_unique<LiveLoop>(std::move(synthesizer), std::move(source), session.commands,
                                            session.history, session.latest);
  RecordingFacts facts = session_facts();
  facts.library = library;
  facts.library_name = library->name();
  facts.library_pairs = static_cast<std::uint64_t>(library->pair_count());
  facts.library_path = library_file;
  facts.excluded_takes = excluded;
  session.keeper->recorder = *Recorder::open(path, facts);
  session.run_until(0.5);
  (void)session.keeper->recorder->finish();
}

/// An interval of the first move tier of a take that the library has.
inline Annotations said_of(const MotionLibrary& library, const std::string& take, const std::string& move) {
  Annotations annotations = annotations_of_take(library, take);
  const int tier = annotations.first_of(TierKind::Move)->id;
  (void)annotations.draw(tier, 0.1, 0.4, move, Conflict::Replace, {0, 1});
  return annotations;
}

inline void save(const std::string& path, const Material& material, const AnnotationBook& book = {}) {
  Project project;
  describe(material, project);
  for (DataReference& data : project.data) data = *reference_to(data.absolute_path, data.use, path);
  project.annotations = book;
  (void)save_project(path, project);
}

}  // namespace abrazo::test
