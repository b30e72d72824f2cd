#include "core/library/build/saved_build.hpp"

#include <optional>

#include "core/base/atomic_file.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"

namespace abrazo {

namespace {

/// Writes the manifest beside its place; it moves there with the commit.
Status prepare(AtomicFile& file, const Manifest& manifest, const std::filesystem::path& target) {
  std::error_code ignored;
  if (std::filesystem::is_directory(target, ignored))
    return Error{"is a folder; name a file", target.string()};
  return file.write(manifest_json(manifest, target.parent_path()));
}

}  // namespace

Result<MotionLibrary> build_and_save(const Manifest& manifest, const BuildFiles& files,
                                     const Progress& progress, std::vector<std::string>& warnings) {
  // The manifest first: a place that cannot be written shows before the long work.
  std::optional<AtomicFile> manifest_file;
  if (!files.manifest.empty()) {
    manifest_file.emplace(files.manifest);
    if (const Status prepared = prepare(*manifest_file, manifest, files.manifest); !prepared)
      return prepared.error();
  }
  const double building_share = files.library.empty() ? 1.0 : 0.8;
  auto library = build_library(manifest, {}, part(progress, 0, building_share), warnings);
  if (!library) return library;
  if (!files.library.empty()) {
    const Status written = write_library(*library, files.library, part(progress, building_share, 1));
    if (!written) return written.error();
  }
  if (manifest_file)
    if (const Status committed = manifest_file->commit(); !committed) return committed.error();
  return library;
}

}  // namespace abrazo
