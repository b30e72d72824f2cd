#include "widgets/scene/values/mesh_scalar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "core/mesh/laplacian.hpp"

namespace abrazo::widgets {
namespace {

// Sampled from matplotlib's viridis (CC0) at eighths.
constexpr std::array<Colour, 9> viridis = {{{68, 1, 84},
                                            {71, 44, 122},
                                            {59, 81, 139},
                                            {44, 113, 142},
                                            {33, 144, 141},
                                            {39, 173, 129},
                                            {92, 200, 99},
                                            {170, 220, 50},
                                            {253, 231, 37}}};
// As viridis, of matplotlib's cividis.
constexpr std::array<Colour, 9> cividis = {{{0, 34, 78},
                                            {26, 56, 111},
                                            {67, 78, 108},
                                            {97, 101, 111},
                                            {125, 124, 120},
                                            {155, 148, 118},
                                            {188, 174, 108},
                                            {222, 201, 88},
                                            {254, 232, 56}}};
// Blue and red would vanish on the bodies.
constexpr std::array<Colour, 5> green_to_purple = {
    {{30, 130, 60}, {112, 168, 124}, {190, 193, 198}, {172, 128, 186}, {140, 60, 160}}};

Colour sampled(std::span<const Colour> map, double share) {
  if (std::isnan(share)) return no_value_colour;
  share = std::max(share, 0.0);
  const double place = std::min(share, 1.0) * static_cast<double>(map.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), map.size() - 2);
  const double t = place - static_cast<double>(low);
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<unsigned char>(std::lround((1 - t) * map[low][c] + t * map[low + 1][c]));
  return colour;
}

double length(const PairPose& pose, const MeshEdge& edge) {
  return (pose.row(edge[0]) - pose.row(edge[1])).norm();
}

}  // namespace

ScalarInfo scalar_info(MeshScalar scalar) {
  switch (scalar) {
    case MeshScalar::Residual:
      return {"Laplacian residual", "mm", false};
    case MeshScalar::Weight:
      return {"Edge weight", "", false};
    case MeshScalar::LengthChange:
      return {"Length change", "mm", true};
    case MeshScalar::EnergyShare:
      return {"Deformation energy", "%", false};
  }
  return {"", "", false};
}

std::vector<double> edge_energies(const FrameSnapshot& frame) {
  const FrameResult& result = frame.result;
  Laplacian laplacian;
  laplacian.build(result.edges, result.selected_pair, frame.settings.edge_weights);
  const PairPose residuals = laplacian.apply(result.result - result.selected_pair);
  std::array<double, pair_vertex_count> weight_sums{};
  for (const MeshEdge& edge : result.edges) {
    weight_sums[edge[0]] += laplacian.weight(edge[0], edge[1]);
    weight_sums[edge[1]] += laplacian.weight(edge[1], edge[0]);
  }
  std::vector<double> energies;
  energies.reserve(result.edges.size());
  const auto part = [&](int vertex, int other) {
    return 0.5 * residuals.row(vertex).squaredNorm() * laplacian.weight(vertex, other) /
           weight_sums[static_cast<std::size_t>(vertex)];
  };
  for (const MeshEdge& edge : result.edges)
    energies.push_back(part(edge[0], edge[1]) + part(edge[1], edge[0]));
  return energies;
}

std::vector<double> edge_scalars(const FrameSnapshot& snapshot, MeshScalar scalar) {
  const FrameResult& frame = snapshot.result;
  std::vector<double> values(frame.edges.size(), std::numeric_limits<double>::quiet_NaN());
  const auto take = [&values](const std::vector<double>& from, double factor) {
    for (std::size_t e = 0; e < std::min(values.size(), from.size()); ++e) values[e] = factor * from[e];
  };
  if (scalar == MeshScalar::Residual) take(frame.edge_residuals_m, 1000);
  if (scalar == MeshScalar::Weight) take(frame.edge_weights, 1);
  if (scalar == MeshScalar::LengthChange)
    for (std::size_t e = 0; e < values.size(); ++e)
      values[e] = 1000 * (length(frame.result, frame.edges[e]) - length(frame.selected_pair, frame.edges[e]));
  if (scalar == MeshScalar::EnergyShare) {
    const std::vector<double> energies = edge_energies(snapshot);
    const double sum = std::accumulate(energies.begin(), energies.end(), 0.0);
    take(energies, sum > 0 ? 100 / sum : 0);  // a mesh that is not bent has nothing to share
  }
  return values;
}

double typical_upper(const std::vector<MeshEdge>& edges, const std::vector<double>& scalars) {
  std::vector<double> sizes;
  for (std::size_t e = 0; e < std::min(edges.size(), scalars.size()); ++e)
    if (is_inter_body(edges[e]) && std::isfinite(scalars[e])) sizes.push_back(std::abs(scalars[e]));
  if (sizes.empty()) return 0;
  const auto place = static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + place, sizes.end());
  return sizes[static_cast<std::size_t>(place)];
}

double ColourScale::share(double value) const {
  if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
  if (!(upper > 0)) return is_signed ? 0.5 : 0;
  const double of_upper = value / upper;
  if (is_signed) return std::clamp(0.5 + of_upper / 2, 0.0, 1.0);
  if (!is_logarithmic) return std::clamp((value - lower) / (upper - lower), 0.0, 1.0);
  return of_upper > 0 ? std::clamp(1 + std::log10(of_upper) / decades, 0.0, 1.0) : 0;
}

Colour ColourScale::colour(double value) const {
  return is_signed ? diverging_colour(share(value)) : sequential_colour(share(value), map, part);
}

Colour sequential_colour(double share, ColourMap map, const MapPart& part) {
  const double within = std::clamp(share, 0.0, 1.0);  // NaN stays one
  return sampled(map == ColourMap::Cividis ? cividis : viridis, part.from + (part.to - part.from) * within);
}
Colour diverging_colour(double share) {
  return sampled(green_to_purple, share);
}

}  // namespace abrazo::widgets
