#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Checks every row of a mapped library on use, because other programs can change the file and it was not
/// read at opening. A damaged row is replaced by the first pair at opening, and remembered. Thread-safe.
class RowGuard {
 public:
  /// Keeps a copy of the first pair.
  /// @throws std::invalid_argument if that pair is damaged
  explicit RowGuard(const LibraryColumns& columns);

  const PairPose& pose(const LibraryColumns& columns, int pair) const;
  std::span<const MeshEdge> edges(const LibraryColumns& columns, int pair) const;
  std::span<const MeshTetrahedron> tetrahedra(const LibraryColumns& columns, int pair) const;

  /// None if no damage was found.
  std::optional<Error> damage(const std::string& library_name) const;

 private:
  void remember(int pair) const;

  std::shared_ptr<const MappedFile> mapping_;
  PairPose first_pose_;
  std::vector<MeshEdge> first_edges_;
  std::vector<MeshTetrahedron> first_tetrahedra_;
  mutable std::atomic<int> damaged_pair_ = -1;
};

}  // namespace abrazo
