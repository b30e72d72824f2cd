#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "core/library/store/motion_library.hpp"

namespace abrazo {

/// Looks at every row of a mapped library when it is used: the file is not ours alone, and it was not read
/// when it was opened. A damaged row is answered with the pair that stood first when the library was opened,
/// and remembered. Any thread.
class RowGuard {
 public:
  /// Keeps the first pair.
  /// @throws std::invalid_argument when that is damaged already
  explicit RowGuard(const LibraryColumns& columns);

  const PairPose& pose(const LibraryColumns& columns, int pair) const;
  std::span<const MeshEdge> edges(const LibraryColumns& columns, int pair) const;
  std::span<const MeshTetrahedron> tetrahedra(const LibraryColumns& columns, int pair) const;

  /// Nothing while all is well.
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
