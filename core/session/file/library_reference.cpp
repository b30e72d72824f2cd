#include "core/session/file/library_reference.hpp"

#include <array>
#include <cstring>
#include <filesystem>

#include "core/base/checksum.hpp"

namespace abrazo {

namespace fs = std::filesystem;

namespace {

/// A library has some hundred megabytes, and is summed up while a session runs.
class Fingerprint : public ContentHash {
 public:
  template <typename Derived>
  void add_matrix(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index r = 0; r < matrix.rows(); ++r)
      for (Eigen::Index c = 0; c < matrix.cols(); ++c) add(static_cast<double>(matrix(r, c)));
  }
  template <typename Indices>
  void add_indices(const Indices& indices) {
    std::uint64_t word = 0;
    for (const std::uint8_t index : indices) word = (word << 8) | index;
    add(word);
  }
};

}  // namespace

std::string library_fingerprint(const MotionLibrary& library) {
  const LibraryColumns& columns = library.columns();
  Fingerprint motion, said;
  motion.add(columns.rate_hz);
  motion.add(std::uint64_t{columns.roles_exchanged});
  for (const LibraryTake& take : columns.takes) {
    motion.add(take.name);
    motion.add(take.fps);
    motion.add(static_cast<std::uint64_t>(take.frames));
    motion.add(static_cast<std::uint64_t>(take.frame_stride));
    said.add(static_cast<std::uint64_t>(take.labels.size()));
    for (const LabelInterval& label : take.labels) {
      said.add(static_cast<std::uint64_t>(label.start));
      said.add(static_cast<std::uint64_t>(label.end));
      said.add(label.label);
    }
  }
  for (const LibraryBody& body : columns.bodies) {
    for (const double length : body.body.bone_lengths) motion.add(length);
    for (const double length : body.body.pseudo_lengths) motion.add(length);
    for (const double radius : body.capsule_radii) motion.add(radius);
    motion.add(body.body.toe_rest_height);
  }
  for (const PairSource& source : columns.sources) {
    motion.add((std::uint64_t{source.take} << 40) ^ (std::uint64_t{source.frame} << 8) ^
               std::uint64_t{source.swapped});
    said.add(static_cast<std::uint64_t>(source.annotated));
  }
  for (const RootFrame& root : columns.roots) {
    motion.add_matrix(root.position);
    motion.add(root.heading_rad);
  }
  for (const PairPose& pose : columns.poses) motion.add_matrix(pose);
  for (const MeshEdge& edge : columns.edges) motion.add_indices(edge);
  for (const MeshTetrahedron& tetrahedron : columns.tetrahedra) motion.add_indices(tetrahedron);
  said.add(motion.text());
  return said.text() + " " + motion.text();
}

bool is_comparable(std::string_view fingerprint) {
  return !fingerprint.empty();
}

bool is_same_motion(std::string_view fingerprint, std::string_view other) {
  const auto motion = [](std::string_view of) { return of.substr(of.find(' ') + 1); };
  return is_comparable(fingerprint) && is_comparable(other) && motion(fingerprint) == motion(other);
}

Status check_session_library(const SessionLibrary& reference, const MotionLibrary& library) {
  if (!is_comparable(reference.fingerprint)) {
    if (reference.pairs == static_cast<std::uint64_t>(library.pair_count())) return Done{};
  } else if (reference.fingerprint == library_fingerprint(library)) {
    return Done{};
  }
  return Error{"the session was recorded with the library '" + reference.name + "' of " +
                   std::to_string(reference.pairs) + " pairs; this one has " +
                   std::to_string(library.pair_count()) +
                   " and other content: it was built again since, or is another one",
               library.name()};
}

bool has_motion_of(const SessionLibrary& reference, const MotionLibrary& library) {
  return is_same_motion(reference.fingerprint, library_fingerprint(library));
}

std::vector<std::string> places_of(const SessionLibrary& reference, const std::string& session_path) {
  std::error_code failure;
  std::vector<std::string> places;
  if (!reference.relative_path.empty())
    places.push_back((fs::absolute(session_path, failure).parent_path() / reference.relative_path)
                         .lexically_normal()
                         .string());
  const std::string absolute = fs::path(reference.absolute_path).lexically_normal().string();
  if (!absolute.empty() && (places.empty() || places.front() != absolute)) places.push_back(absolute);
  return places;
}

}  // namespace abrazo
