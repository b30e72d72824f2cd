#include "core/annotation/annotated_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/library/takes/interval_check.hpp"
#include "core/library/takes/take_labels.hpp"
#include "core/mesh/other_body.hpp"

namespace abrazo {

namespace {

constexpr const char* role_tier = "role";
constexpr const char* move_tier = "move";

std::vector<VocabularyEntry> labels_in(const MotionLibrary& library) {
  std::vector<TierInterval> all;
  for (const LibraryTake& take : library.takes())
    for (const LabelInterval& label : take.labels) all.push_back({0, 0, label.label});
  return vocabulary_of(all);
}

Error no_such_take(const MotionLibrary& library, std::string_view take) {
  std::string names;
  for (const LibraryTake& other : library.takes()) names += (names.empty() ? "" : ", ") + other.name;
  return {fmt::format("the library has no take '{}'; it has {}", take, names), library.name()};
}

/// Frames that seconds mean, within the take.
struct FrameSpan {
  int start = 0, end = 0;
};

FrameSpan frames_of(const Annotation& annotation, double fps, int frames) {
  const auto frame = [&](double time_s) {
    return static_cast<int>(std::clamp(std::round(time_s * fps), 0.0, static_cast<double>(frames)));
  };
  return {frame(annotation.start_s), frame(annotation.end_s)};
}

// ---- new pairs of a take ----

template <typename Interval>
const Interval* holding(const std::vector<Interval>& intervals, int frame) {
  const auto found = std::find_if(intervals.begin(), intervals.end(), [&](const Interval& interval) {
    return interval.start <= frame && frame < interval.end;
  });
  return found == intervals.end() ? nullptr : &*found;
}

/// A library may have both bodies of a frame as active even if the roles name one.
bool has_both_roles(const MotionLibrary& library) {
  return std::any_of(library.columns().sources.begin(), library.columns().sources.end(),
                     [](const PairSource& source) {
                       return source.annotated == (source.swapped ? ActivePerformer::A : ActivePerformer::B);
                     });
}

/// Grows row by row out of another library's rows.
class PairRows {
 public:
  PairRows(const MotionLibrary& from, LibraryColumns& to) : from_(from), to_(to) {}
  void copy(int pair, ActivePerformer annotated);
  void copy(int pair) { copy(pair, from_.source(pair).annotated); }
  /// The same frame with the other performer active.
  void exchange(int pair, ActivePerformer annotated, std::optional<double> previous_heading_rad);

 private:
  void end_row(int pair);

  const MotionLibrary& from_;
  LibraryColumns& to_;
};

void PairRows::end_row(int pair) {
  to_.edge_offsets.push_back(to_.edges.size());
  to_.tetrahedron_offsets.push_back(to_.tetrahedra.size());
  to_.mesh_quality.push_back(from_.columns().mesh_quality[static_cast<std::size_t>(pair)]);
}

void PairRows::copy(int pair, ActivePerformer annotated) {
  PairSource source = from_.source(pair);
  source.annotated = annotated;
  to_.sources.push_back(source);
  to_.roots.push_back(from_.root(pair));
  to_.poses.push_back(from_.pose(pair));
  to_.features.push_back(from_.features(pair));
  const auto edges = from_.edges(pair);
  const auto tetrahedra = from_.tetrahedra(pair);
  to_.edges.insert(to_.edges.end(), edges.begin(), edges.end());
  to_.tetrahedra.insert(to_.tetrahedra.end(), tetrahedra.begin(), tetrahedra.end());
  end_row(pair);
}

void PairRows::exchange(int pair, ActivePerformer annotated, std::optional<double> previous_heading_rad) {
  PairSource source = from_.source(pair);
  source.swapped = !source.swapped;
  source.annotated = annotated;
  const PairPose& pose = from_.pose(pair);
  const Pose active = to_world(pose.bottomRows<joint_count>(), from_.root(pair));
  const Pose passive = to_world(pose.topRows<joint_count>(), from_.root(pair));
  const RootFrame root = root_frame(active, previous_heading_rad);
  PairPose exchanged;
  exchanged.topRows<joint_count>() = to_normalized(active, root);
  exchanged.bottomRows<joint_count>() = to_normalized(passive, root);
  to_.sources.push_back(source);
  to_.roots.push_back(root);
  to_.poses.push_back(exchanged);
  to_.features.push_back(pose_features(exchanged.topRows<joint_count>()));
  const auto first = static_cast<std::ptrdiff_t>(to_.edges.size());
  for (const MeshEdge& edge : from_.edges(pair)) to_.edges.push_back(edge_of_other_body(edge));
  std::sort(to_.edges.begin() + first, to_.edges.end());
  for (const MeshTetrahedron& tetrahedron : from_.tetrahedra(pair))
    to_.tetrahedra.push_back(tetrahedron_of_other_body(tetrahedron));
  end_row(pair);
}

/// The pairs of a take as its new roles want them.
void add_take(const MotionLibrary& library, const LibraryTake& take, const std::vector<RoleInterval>& roles,
              bool both_roles, PairRows& rows) {
  for (const bool swapped : {false, true}) {
    const ActivePerformer other = swapped ? ActivePerformer::A : ActivePerformer::B;
    std::optional<double> heading_rad;
    for (int frame = 0; frame < take.frames; frame += take.frame_stride) {
      const int own = library.find_pair(take.name, frame, swapped),
                others = library.find_pair(take.name, frame, !swapped);
      if (own < 0 && others < 0) continue;
      const RoleInterval* role = holding(roles, frame);
      const ActivePerformer annotated = role ? role->active : ActivePerformer::Unknown;
      const bool wanted = annotated != other || both_roles;
      if (wanted && own >= 0)
        rows.copy(own, annotated);
      else if (wanted)
        rows.exchange(others, annotated, heading_rad);
      // A frame with an unreliable hip axis has the heading of the previous frame, which need not be a pair.
      if (own >= 0)
        heading_rad = library.root(own).heading_rad;
      else
        heading_rad =
            root_frame(to_world(library.pose(others).bottomRows<joint_count>(), library.root(others)),
                       heading_rad)
                .heading_rad;
    }
  }
}

LibraryColumns columns_without_pairs(const MotionLibrary& library) {
  LibraryColumns columns;
  const LibraryColumns& from = library.columns();
  columns.name = from.name;
  columns.rate_hz = from.rate_hz;
  columns.takes = from.takes;
  columns.bodies = from.bodies;
  columns.edge_offsets.assign(1, 0);
  columns.tetrahedron_offsets.assign(1, 0);
  return columns;
}

}  // namespace

Annotations annotations_of_take(const MotionLibrary& library, std::string_view take) {
  const int index = library.find_take(take);
  if (index < 0) throw std::invalid_argument("the library has no take " + std::string(take));
  const LibraryTake& from = library.takes()[static_cast<std::size_t>(index)];
  Tier roles{role_tier, {}, {{"a"}, {"b"}}, TierKind::Role};
  for (const RoleInterval& role : from.roles)
    if (role.active != ActivePerformer::Unknown)
      roles.intervals.push_back(
          {role.start / from.fps, role.end / from.fps, role.active == ActivePerformer::A ? "a" : "b"});
  Tier moves{move_tier, {}, labels_in(library), TierKind::Move};
  for (const LabelInterval& label : from.labels) moves.intervals.push_back(interval_of(label, from.fps));
  const auto annotations = annotations_of(std::vector<Tier>{std::move(roles), std::move(moves)});
  if (!annotations) throw std::invalid_argument(annotations.error().text());
  return *annotations;
}

Result<TakeAnnotation> take_annotation(const Annotations& annotations, double fps, int frames) {
  if (!(fps > 0) || !std::isfinite(fps) || frames < 0)
    throw std::invalid_argument("a take has frames and a frame rate");
  TakeAnnotation taken;
  if (const AnnotationTier* roles = annotations.first_of(TierKind::Role))
    for (const Annotation& annotation : roles->annotations) {
      const FrameSpan span = frames_of(annotation, fps, frames);
      if (annotation.value != "a" && annotation.value != "b")
        return Error{fmt::format("'{}' at {:.3f} s is not a role; say a or b, the performer who leads or "
                                 "attacks there",
                                 annotation.value, annotation.start_s),
                     roles->name};
      if (span.end > span.start)
        taken.roles.push_back(
            {span.start, span.end, annotation.value == "a" ? ActivePerformer::A : ActivePerformer::B});
    }
  if (const AnnotationTier* moves = annotations.first_of(TierKind::Move))
    for (const Annotation& annotation : moves->annotations) {
      const FrameSpan span = frames_of(annotation, fps, frames);
      // A move without a value does not count.
      if (span.end > span.start && !annotation.value.empty())
        taken.labels.push_back(label_over(annotation, span.start, span.end));
    }
  return taken;
}

Result<MotionLibrary> with_annotations(const MotionLibrary& library, const TakeAnnotations& takes) {
  for (const auto& [take, annotation] : takes) {
    if (library.find_take(take) < 0) return no_such_take(library, take);
    const std::string where = fmt::format("take {}", take);
    if (const Status checked = check_intervals(annotation.roles, "role", where); !checked)
      return checked.error();
    if (const Status checked = check_intervals(annotation.labels, "label", where); !checked)
      return checked.error();
  }
  if (library.columns().roles_exchanged) {
    const auto annotated = with_annotations(with_roles_exchanged(library), takes);
    if (!annotated) return annotated.error();
    return with_roles_exchanged(*annotated);
  }
  LibraryColumns columns = columns_without_pairs(library);
  std::vector<const TakeAnnotation*> waiting(columns.takes.size());  // whose pairs are not in `rows` yet
  for (const auto& [take, annotation] : takes) {
    const auto index = static_cast<std::size_t>(library.find_take(take));
    columns.takes[index].roles = annotation.roles;
    columns.takes[index].labels = annotation.labels;
    waiting[index] = &annotation;
  }
  const auto annotated = waiting;
  PairRows rows(library, columns);
  const bool both_roles = has_both_roles(library);
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const std::uint32_t take = library.source(pair).take;
    if (!annotated[take])
      rows.copy(pair);
    else if (const auto* annotation = std::exchange(waiting[take], nullptr))
      add_take(library, library.takes()[take], annotation->roles, both_roles, rows);
  }
  return MotionLibrary(std::move(columns));
}

}  // namespace abrazo
