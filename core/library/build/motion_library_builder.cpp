#include "core/library/build/motion_library_builder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/library/build/capsule_calibration.hpp"
#include "core/library/store/library_bodies.hpp"
#include "core/library/takes/interval_check.hpp"

namespace abrazo {

namespace {

constexpr double farthest_capture_m = 1e6;  // of a body; a pair of two is then well within farthest_m

Error cancelled() {
  return {"cancelled", ""};
}

// ---- what a take must be ----

std::optional<Error> check_frames(const Clip& clip, const std::string& where) {
  for (std::size_t frame = 0; frame < clip.poses.size(); ++frame)
    for (int joint = 0; joint < joint_count; ++joint)
      if (const auto position = clip.poses[frame].row(joint); !position.allFinite())
        return Error{
            fmt::format("the position of {} at frame {} is not a finite number; repair or cut the frame",
                        joint_names[static_cast<std::size_t>(joint)], frame),
            where};
      else if (position.squaredNorm() > farthest_capture_m * farthest_capture_m)
        return Error{
            fmt::format("{} at frame {} is more than {:.0f} km from the origin; check the unit "
                        "(metres_per_unit), or cut the frame",
                        joint_names[static_cast<std::size_t>(joint)], frame, farthest_capture_m / 1000),
            where};
  return std::nullopt;
}

std::optional<Error> check_take(const PairedTake& take) {
  const std::string where = "take " + take.name;
  if (take.a.poses.size() != take.b.poses.size())
    return Error{
        fmt::format(
            "performer a has {} frames and b {}; both must have been captured together, frame for frame",
            take.a.poses.size(), take.b.poses.size()),
        where};
  if (take.a.poses.size() < 2)
    return Error{fmt::format("has {} frames; at least 2 are needed", take.a.poses.size()), where};
  if (!(take.fps > 0) || !std::isfinite(take.fps))
    return Error{fmt::format("{} frames per second; give a number above 0", take.fps), where};
  if (auto refusal = check_frames(take.a, where + "/a")) return refusal;
  if (auto refusal = check_frames(take.b, where + "/b")) return refusal;
  if (const Status roles = check_intervals(take.roles, "role", where); !roles) return roles.error();
  if (const Status labels = check_intervals(take.labels, "label", where); !labels) return labels.error();
  return std::nullopt;
}

std::string joined_names(const auto& takes) {
  std::vector<std::string_view> names;
  names.reserve(takes.size());
  for (const auto& take : takes) names.push_back(take.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Removes the excluded takes; refuses an unknown name, and an empty rest.
template <typename Take>
std::optional<Error> exclude(std::vector<Take>& takes, const std::vector<std::string>& excluded) {
  for (const std::string& name : excluded)
    if (std::none_of(takes.begin(), takes.end(), [&](const Take& take) { return take.name == name; }))
      return Error{fmt::format("there is no take \"{}\" to exclude; there are {}", name, joined_names(takes)),
                   ""};
  std::erase_if(takes, [&](const Take& take) {
    return std::find(excluded.begin(), excluded.end(), take.name) != excluded.end();
  });
  if (takes.empty()) return Error{"no take is left to build a library of; exclude fewer", ""};
  return std::nullopt;
}

std::optional<Error> check_options(const std::vector<PairedTake>& takes, const LibraryBuildOptions& options) {
  if (options.rate_hz && !(*options.rate_hz > 0 && std::isfinite(*options.rate_hz)))
    return Error{fmt::format("a rate of {} Hz is not possible; give a number above 0", *options.rate_hz), ""};
  std::set<std::string_view> names;
  for (const PairedTake& take : takes) {
    if (!names.insert(take.name).second)
      return Error{"two takes have this name; rename one", "take " + take.name};
    if (auto refusal = check_take(take)) return refusal;
  }
  return std::nullopt;
}

// ---- takes and bodies ----

int frame_stride(double fps, const std::optional<double>& rate_hz) {
  return rate_hz ? static_cast<int>(std::clamp(std::round(fps / *rate_hz), 1.0, 1e6)) : 1;
}

void add_takes(const std::vector<PairedTake>& takes, const LibraryBuildOptions& options,
               LibraryColumns& columns) {
  for (const PairedTake& take : takes) {
    LibraryTake entry;
    entry.name = take.name;
    entry.fps = take.fps;
    entry.frames = static_cast<int>(take.a.poses.size());
    entry.frame_stride = frame_stride(take.fps, options.rate_hz);
    entry.body_a = find_or_add_body(columns.bodies, body_of(std::span(take.a.poses)), take.name + "/a");
    entry.body_b = find_or_add_body(columns.bodies, body_of(std::span(take.b.poses)), take.name + "/b");
    entry.roles = take.roles;
    entry.labels = take.labels;
    columns.takes.push_back(std::move(entry));
  }
  columns.rate_hz = 0;
  for (const LibraryTake& take : columns.takes)
    columns.rate_hz = std::max(columns.rate_hz, take.fps / take.frame_stride);
}

void calibrate(const std::vector<PairedTake>& takes, LibraryColumns& columns) {
  std::vector<TakeBodies> take_bodies;
  for (const LibraryTake& take : columns.takes) take_bodies.push_back({take.body_a, take.body_b});
  std::vector<Body> bodies;
  for (const LibraryBody& body : columns.bodies) bodies.push_back(body.body);
  const auto radii = calibrate_capsules(takes, take_bodies, bodies);
  for (std::size_t b = 0; b < radii.size(); ++b) columns.bodies[b].capsule_radii = radii[b];
}

// ---- pairs ----

/// Roots of every frame of a performer, also of those that thinning leaves out: a heading that is taken over
/// from the frame before must not depend on the rate.
std::vector<RootFrame> root_frames(const Clip& clip) {
  std::vector<RootFrame> roots;
  roots.reserve(clip.poses.size());
  for (const Pose& pose : clip.poses)
    roots.push_back(root_frame(pose, roots.empty() ? std::nullopt : std::optional(roots.back().heading_rad)));
  return roots;
}

void add_sources(const std::vector<PairedTake>& takes, bool both_roles, LibraryColumns& columns) {
  for (std::uint32_t t = 0; t < takes.size(); ++t) {
    const std::vector<RootFrame> roots_a = root_frames(takes[t].a);
    const std::vector<RootFrame> roots_b = root_frames(takes[t].b);
    for (const bool swapped : {false, true}) {
      const ActivePerformer other = swapped ? ActivePerformer::A : ActivePerformer::B;
      for (int frame = 0; frame < columns.takes[t].frames; frame += columns.takes[t].frame_stride) {
        const ActivePerformer annotated = active_at(takes[t], frame);
        if (annotated == other && !both_roles) continue;
        columns.sources.push_back({t, static_cast<std::uint32_t>(frame), swapped, annotated});
        columns.roots.push_back((swapped ? roots_b : roots_a)[static_cast<std::size_t>(frame)]);
      }
    }
  }
}

/// Fills row `pair` from its source and root.
void fill_pair(const std::vector<PairedTake>& takes, std::size_t pair, LibraryColumns& columns) {
  const PairSource& source = columns.sources[pair];
  const PairedTake& take = takes[source.take];
  const Pose& active = (source.swapped ? take.b : take.a).poses[source.frame];
  const Pose& passive = (source.swapped ? take.a : take.b).poses[source.frame];
  PairPose& pose = columns.poses[pair];
  pose.topRows<joint_count>() = to_normalized(active, columns.roots[pair]);
  pose.bottomRows<joint_count>() = to_normalized(passive, columns.roots[pair]);
  columns.features[pair] = pose_features(pose.topRows<joint_count>());
}

/// Meshes of neighbouring pairs, end to end: what one core makes without asking the other.
struct MeshBlock {
  std::vector<MeshEdge> edges;
  std::vector<MeshTetrahedron> tetrahedra;
};
constexpr std::size_t pairs_of_block = 64;

/// Offsets hold the sizes of each mesh until all are known.
void add_mesh(std::size_t pair, MeshBlock& block, LibraryColumns& columns) {
  const InteractionMesh mesh = tetrahedralize(std::as_const(columns.poses)[pair]);
  block.edges.insert(block.edges.end(), mesh.edges.begin(), mesh.edges.end());
  block.tetrahedra.insert(block.tetrahedra.end(), mesh.tetrahedra.begin(), mesh.tetrahedra.end());
  columns.edge_offsets[pair + 1] = mesh.edges.size();
  columns.tetrahedron_offsets[pair + 1] = mesh.tetrahedra.size();
  columns.mesh_quality[pair] = static_cast<std::uint8_t>(mesh.quality);
}

void join_meshes(std::vector<MeshBlock>& blocks, LibraryColumns& columns) {
  const auto sum_up = [](Column<std::uint64_t>& sizes) {
    std::partial_sum(sizes.begin(), sizes.end(), sizes.begin());
    return sizes.back();
  };
  columns.edges.reserve(sum_up(columns.edge_offsets));
  columns.tetrahedra.reserve(sum_up(columns.tetrahedron_offsets));
  for (MeshBlock& block : blocks) {
    columns.edges.insert(columns.edges.end(), block.edges.begin(), block.edges.end());
    columns.tetrahedra.insert(columns.tetrahedra.end(), block.tetrahedra.begin(), block.tetrahedra.end());
    block = {};  // a large library should not be in memory twice
  }
}

/// Poses, features and meshes of all sources. @return false when progress asked to stop
bool fill_pairs(const std::vector<PairedTake>& takes, const Progress& progress, LibraryColumns& columns) {
  const std::size_t pairs = columns.sources.size();
  columns.poses.resize(pairs);
  columns.features.resize(pairs);
  columns.edge_offsets.assign(pairs + 1, 0);
  columns.tetrahedron_offsets.assign(pairs + 1, 0);
  columns.mesh_quality.assign(pairs, 0);
  std::vector<MeshBlock> blocks((pairs + pairs_of_block - 1) / pairs_of_block);
  const auto fill_block = [&](std::size_t block) {
    const std::size_t begin = block * pairs_of_block;
    for (std::size_t pair = begin; pair < std::min(pairs, begin + pairs_of_block); ++pair) {
      fill_pair(takes, pair, columns);
      add_mesh(pair, blocks[block], columns);
    }
  };
  if (!for_each_row(blocks.size(), 1, progress, "building interaction meshes", fill_block)) return false;
  join_meshes(blocks, columns);
  return true;
}

/// From every core; warnings in the order of the manifest, and of several errors the first.
Result<std::vector<PairedTake>> load_takes(const std::vector<Manifest::Take>& wanted,
                                           const Progress& progress, std::vector<std::string>& warnings) {
  struct Loaded {
    std::optional<Result<PairedTake>> take;
    std::vector<std::string> warnings;
  };
  std::vector<Loaded> loaded(wanted.size());
  // Only this thread may ask; the others hear of it.
  std::atomic<bool> stopped = false;
  double reached = 0;
  const Progress asked = [&](double fraction, std::string_view doing) {
    reached = fraction;
    if (!report(progress, fraction, doing)) stopped = true;
    return !stopped;
  };
  const Progress while_loading = [&, asking = std::this_thread::get_id()](double, std::string_view) {
    return std::this_thread::get_id() == asking ? asked(reached, "reading takes") : !stopped;
  };
  const auto load = [&](std::size_t t) {
    loaded[t].take = load_take(wanted[t], loaded[t].warnings, while_loading);
  };
  if (!asked(0, "reading takes") || !for_each_row(wanted.size(), 1, asked, "reading takes", load) || stopped)
    return cancelled();
  std::vector<PairedTake> takes;
  for (Loaded& one : loaded) {
    warnings.insert(warnings.end(), one.warnings.begin(), one.warnings.end());
    if (!*one.take) return one.take->error();
    takes.push_back(std::move(**one.take));
  }
  return takes;
}

double rate_of(const LibraryTake& take) {
  return take.fps / take.frame_stride;
}

bool has_rate_of(const MotionLibrary& library, const LibraryTake& take) {
  return std::abs(rate_of(take) - library.rate_hz()) <= 0.01 * library.rate_hz();
}

void warn_of_unequal_rates(const MotionLibrary& library, std::vector<std::string>& warnings) {
  for (const LibraryTake& take : library.takes()) {
    if (!has_rate_of(library, take))
      warnings.push_back(
          fmt::format("take {}: its pairs come at {:.4g} Hz, those of the fastest take at {:.4g} Hz; build "
                      "at one rate to bring them together",
                      take.name, rate_of(take), library.rate_hz()));
  }
}

}  // namespace

bool has_one_rate(const MotionLibrary& library) {
  return std::ranges::all_of(library.takes(),
                             [&](const LibraryTake& take) { return has_rate_of(library, take); });
}

Result<MotionLibrary> build_library(std::string name, std::vector<PairedTake> takes,
                                    const LibraryBuildOptions& options, const Progress& progress) {
  if (auto refusal = exclude(takes, options.excluded_takes)) return *refusal;
  if (auto refusal = check_options(takes, options)) return *refusal;
  if (!report(progress, 0, "measuring bodies")) return cancelled();
  LibraryColumns columns;
  columns.name = std::move(name);
  add_takes(takes, options, columns);
  calibrate(takes, columns);
  add_sources(takes, options.both_roles, columns);
  if (!fill_pairs(takes, part(progress, 0.05, 0.98), columns)) return cancelled();
  if (!report(progress, 1, "library built")) return cancelled();
  return MotionLibrary(std::move(columns));
}

Result<MotionLibrary> build_library(const Manifest& manifest, const LibraryBuildOptions& options,
                                    const Progress& progress, std::vector<std::string>& warnings) {
  warnings.insert(warnings.end(), manifest.warnings.begin(), manifest.warnings.end());
  std::vector<Manifest::Take> wanted = manifest.takes;
  if (auto refusal = exclude(wanted, options.excluded_takes)) return *refusal;
  constexpr double reading_share = 0.4;
  auto takes = load_takes(wanted, part(progress, 0, reading_share), warnings);
  if (!takes) return takes.error();
  LibraryBuildOptions rest = options;
  rest.excluded_takes.clear();
  auto library = build_library(manifest.name, std::move(*takes), rest, part(progress, reading_share, 1));
  if (library) warn_of_unequal_rates(*library, warnings);
  if (library && options.rate_hz && std::abs(library->rate_hz() - *options.rate_hz) > 0.01 * *options.rate_hz)
    warnings.push_back(
        fmt::format("the library has {:.4g} Hz, not {:.4g}: only every n-th frame of a take can be taken",
                    library->rate_hz(), *options.rate_hz));
  return library;
}

}  // namespace abrazo
