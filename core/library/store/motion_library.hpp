#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/base/error.hpp"
#include "core/library/store/column.hpp"
#include "core/library/store/normalization.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/mesh/capsules.hpp"
#include "core/mesh/interaction_mesh.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// The recorded frame of a library pair.
struct PairSource {
  std::uint32_t take = 0;                                ///< index into takes()
  std::uint32_t frame = 0;                               ///< 0-based frame of the take's own file
  bool swapped = false;                                  ///< performer B is the active one
  ActivePerformer annotated = ActivePerformer::Unknown;  ///< from the take's roles at this frame
};

/// Sort key of the pairs of a library.
inline auto order_of(const PairSource& source) {
  return std::tuple(source.take, source.swapped, source.frame);
}

/// A take as kept in the library.
struct LibraryTake {
  std::string name;
  double fps = 60;
  int frames = 0;            ///< frames of the take's file
  int frame_stride = 1;      ///< every n-th frame is in the library
  std::uint32_t body_a = 0;  ///< index into bodies()
  std::uint32_t body_b = 0;
  std::vector<RoleInterval> roles;
  std::vector<LabelInterval> labels;

  double pairs_per_second() const { return fps / frame_stride; }
};

/// Bone lengths and capsule radii of a performer.
struct LibraryBody {
  std::string name;  ///< "salsa_01/a": its first take
  Body body;
  CapsuleRadii capsule_radii{};  ///< [m], calibrated: recorded contact counts as contact, not as penetration
};

class MappedFile;
class RowGuard;

/// The content of a motion library in columns, one row per pair; pairs of a take are contiguous, in frame
/// order, those with swapped = false first. Filled by the builder or the file reader, then read-only.
struct LibraryColumns {
  std::string name;
  bool roles_exchanged = false;  ///< "active" holds the passive performer: see with_roles_exchanged
  double rate_hz = 60;           ///< of the pairs (fastest take after thinning)
  std::vector<LibraryTake> takes;
  std::vector<LibraryBody> bodies;  ///< performers whose bones differ by less than 0.5 % are one body
  std::vector<PairSource> sources;
  Column<RootFrame> roots;  ///< of the active body, world of the take
  Column<PairPose> poses;   ///< normalised (Eq. 1-2), active then passive
  Column<Features> features;
  Column<std::uint64_t> edge_offsets;  ///< pairs + 1
  Column<MeshEdge> edges;
  Column<std::uint64_t> tetrahedron_offsets;  ///< pairs + 1
  Column<MeshTetrahedron> tetrahedra;
  std::vector<std::uint8_t> mesh_quality;     ///< InteractionMesh::Quality
  std::shared_ptr<const MappedFile> mapping;  ///< the file of columns that are views; null if all is in
                                              ///< memory
  std::optional<Error> damage;                ///< of the mapped library from which these were copied
};

/// Recorded pairs, normalised, with their features and interaction meshes (paper 3.2). Immutable; shared
/// between threads. Poses and meshes may be pages of a file (LibraryColumns::mapping) that another program
/// can damage while it is in use: a damaged pair is then replaced by pair 0, nothing throws, and damage()
/// reports it.
class MotionLibrary {
 public:
  /// @throws std::invalid_argument if the columns are inconsistent
  explicit MotionLibrary(LibraryColumns columns);

  const std::string& name() const { return columns_.name; }
  double rate_hz() const { return columns_.rate_hz; }
  int pair_count() const { return static_cast<int>(columns_.sources.size()); }
  const std::vector<LibraryTake>& takes() const { return columns_.takes; }
  const std::vector<LibraryBody>& bodies() const { return columns_.bodies; }
  const LibraryColumns& columns() const { return columns_; }

  const PairSource& source(int pair) const { return columns_.sources[static_cast<std::size_t>(pair)]; }
  const PairPose& pose(int pair) const {
    return guard_ ? guarded_pose(pair) : columns_.poses[static_cast<std::size_t>(pair)];
  }
  const RootFrame& root(int pair) const { return columns_.roots[static_cast<std::size_t>(pair)]; }
  const Features& features(int pair) const { return columns_.features[static_cast<std::size_t>(pair)]; }
  std::span<const MeshEdge> edges(int pair) const;
  std::span<const MeshTetrahedron> tetrahedra(int pair) const;

  /// Damage of the file of a mapped library: it changed, or a pair is damaged. For a copy with exchanged
  /// roles: the damage at the time of copying.
  std::optional<Error> damage() const;
  /// Whether poses and meshes are pages of a file.
  bool is_mapped() const { return guard_ != nullptr; }

  const LibraryTake& take_of(int pair) const { return columns_.takes[source(pair).take]; }
  const LibraryBody& active_body(int pair) const;
  const LibraryBody& passive_body(int pair) const;
  std::string_view label(int pair) const;

  /// q''_A, q''_S of Eq. 5-6: a recorded pair placed at the user. Translated horizontally to the user's root
  /// and rotated to the user's heading; heights stay those of the recording, so that feet stay on the floor
  /// (the equations omit the translation, but Eq. 7 compares world positions).
  /// @param user_root  of the body that plays the user: the active one, or the passive one when
  /// `user_is_passive`
  PairPose pair_in_world(int pair, const RootFrame& user_root, bool user_is_passive = false) const;

  /// The pair recorded `steps` pairs later in the same take with the same roles, without a gap; -1 if there
  /// is none.
  int later_pair(int pair, int steps) const;

  /// The pair of a take's frame; -1 if it is not in the library.
  int find_pair(std::string_view take, int frame, bool swapped) const;

  /// Index of a take by name; -1 if there is none.
  int find_take(std::string_view name) const;

  /// The most frequent active and passive bodies: the user is retargeted to one, the partner has the other.
  const LibraryBody& usual_active_body() const { return columns_.bodies[usual_active_]; }
  const LibraryBody& usual_passive_body() const { return columns_.bodies[usual_passive_]; }

 private:
  const PairPose& guarded_pose(int pair) const;

  LibraryColumns columns_;
  std::shared_ptr<const RowGuard> guard_;  ///< null if all is in memory
  std::uint32_t usual_active_ = 0;
  std::uint32_t usual_passive_ = 0;
};

/// The same pairs with the two bodies exchanged: normalised by the passive root, with its features, for a
/// user in the passive role. Pair numbers stay; sources still give the recorded active performer.
MotionLibrary with_roles_exchanged(const MotionLibrary& library);

}  // namespace abrazo
