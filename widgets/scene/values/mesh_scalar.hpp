#pragma once

#include <array>
#include <vector>

#include "core/session/frames/frame_snapshot.hpp"
#include "widgets/scene/values/scene_options.hpp"

namespace abrazo::widgets {

/// Values that colour the edges of the interaction mesh.
enum class MeshScalar { Residual, Weight, LengthChange, EnergyShare };
inline constexpr std::size_t mesh_scalar_count = 4;

struct ScalarInfo {
  const char* title;
  const char* unit;  ///< "" for a pure number
  bool is_signed;    ///< shown on a diverging map, symmetric about 0
};

ScalarInfo scalar_info(MeshScalar scalar);

/// One value per edge in the unit of `scalar_info`; NaN if the frame has none.
std::vector<double> edge_scalars(const FrameSnapshot& frame, MeshScalar scalar);

/// Deformation energy of each edge [m^2]: the energy of a vertex, 1/2 |delta_j - L(v'_j)|^2 (Eq. 11), is
/// divided among its edges by their weights. Sums to E_L of the frame.
std::vector<double> edge_energies(const FrameSnapshot& frame);

/// 90th percentile over the edges between the bodies: one stretched edge must not darken all others.
double typical_upper(const std::vector<MeshEdge>& edges, const std::vector<double>& scalars);

using Colour = std::array<unsigned char, 3>;

/// The part of a sequential map that is in use.
struct MapPart {
  double from = 0, to = 1;
  bool operator==(const MapPart&) const = default;
};
/// What of a map differs from the background in brightness, with a contrast above 2: without its dark end on
/// a dark one, without its bright end on a light one.
constexpr MapPart part_on(bool is_dark) {
  return is_dark ? MapPart{0.4, 1} : MapPart{0, 0.6};
}

/// Mapping of values to colours.
struct ColourScale {
  double upper = 0;        ///< value at the end of the map; 0 = no colouring
  bool is_signed = false;  ///< from -upper to upper on the diverging map
  ColourMap map = ColourMap::Viridis;
  bool is_logarithmic = false;  ///< `decades` below the upper end; not with signed values
  double lower = 0;             ///< value at the start of a linear map; below `upper`; not with signed values
  MapPart part = {};
  bool operator==(const ColourScale&) const = default;

  static constexpr double decades = 2;
  /// Position on the map, 0 to 1; NaN for NaN. On a logarithmic scale values up to 0 are at the lower end.
  double share(double value) const;
  Colour colour(double value) const;
};

/// Colour of NaN; on neither map.
inline constexpr Colour no_value_colour = {122, 122, 122};

/// Red, green, blue [0, 255] at `share` in [0, 1] of the part of the map.
Colour sequential_colour(double share, ColourMap map = ColourMap::Viridis, const MapPart& part = {});
Colour diverging_colour(double share);  ///< green - grey - purple: neither body has them

}  // namespace abrazo::widgets
