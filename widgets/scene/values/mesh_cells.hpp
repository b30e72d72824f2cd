#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo::widgets {

/// Change of volume of one tetrahedron of the interaction mesh.
struct CellVolume {
  double volume_m3 = 0;     ///< at the result, never negative
  double reference_m3 = 0;  ///< in the selected pair
  double ratio = 1;         ///< signed volume of the result / that of the selected pair; negative: inverted
  /// Thinner than `flat_m` in the selected pair: its sign is meaningless, so it is neither coloured nor
  /// counted.
  bool is_flat = false;
  bool is_inverted = false;
};

inline constexpr double flat_m = 0.001;

CellVolume cell_volume(const PairPose& result, const PairPose& reference, const MeshTetrahedron& cell);
/// One per tetrahedron of the frame.
std::vector<CellVolume> cell_volumes(const FrameResult& frame);
int inverted_count(std::span<const CellVolume> cells);

/// Whether it has vertices of both bodies.
bool joins_bodies(const MeshTetrahedron& cell);

/// 90th percentile of |log2 ratio|, without flat and inverted cells. 1 = halved or doubled.
double typical_doublings(std::span<const CellVolume> cells);

/// Corners of each cell, 12 numbers per cell, world [m]. A cell's centre c moves to c + apart (c - m), m
/// being the mean of the vertices at the height of the lowest, so that no cell gets below that; its corners
/// move towards it by the share `shrink`.
std::vector<double> spread_cells(const PairPose& pair, std::span<const MeshTetrahedron> cells, double apart,
                                 double shrink);

/// Corners of a face, indices into a cell's four.
inline constexpr std::array<std::array<int, 3>, 4> cell_faces = {
    {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};

/// Faces 4 c + f of the cells, farthest from the eye first, for blending.
std::vector<int> faces_back_to_front(std::span<const double> corners, const Vec3& eye, const Vec3& direction);

}  // namespace abrazo::widgets
