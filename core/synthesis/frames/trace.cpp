#include "core/synthesis/frames/trace.hpp"

#include "core/synthesis/frames/recording_trace.hpp"

#include "core/base/version.hpp"
#include "core/motion/body/joint_set.hpp"
#include "core/selection/intent_model.hpp"

namespace abrazo {

namespace {

template <typename Indices>
void write_indices(JsonText& json, const Indices& indices) {
  json.begin_array();
  for (const auto index : indices) json.value(static_cast<int>(index));
  json.end_array();
}

void write_candidates(JsonText& json, const FrameResult& frame, const MotionLibrary& library) {
  json.key("candidates").begin_array();
  for (const Candidate& candidate : frame.candidates) {
    const PairSource& source = library.source(candidate.pair);
    const std::string_view label = library.label(candidate.pair);
    json.begin_object();
    json.key("take").value(library.take_of(candidate.pair).name);
    json.key("frame").value(static_cast<int>(source.frame));
    json.key("swapped").value(source.swapped);
    json.key("label");
    if (label.empty())
      json.null();
    else
      json.value(label);
    json.key("feature_distance").value(candidate.feature_distance);
    json.key("continuation").value(candidate.continuation);
    json.key("cost").begin_object();
    json.key("pose").value(candidate.cost.pose);
    json.key("temporal_active").value(candidate.cost.temporal_active);
    json.key("temporal_passive").value(candidate.cost.temporal_passive);
    json.key("total").value(candidate.cost.total);
    json.end_object();
    if (const auto& intent = candidate.intent) {
      json.key("intent").begin_object();
      json.key("partner").value(intent->partner);
      json.key("leader").value(intent->leader);
      json.key("move").value(intent->move);
      json.key("meant").value(intent->meant);
      json.key("change").value(intent->change);
      json.key("temporal").value(intent->temporal);
      json.key("total").value(intent->total);
      json.end_object();
    }
    json.end_object();
  }
  json.end_array();
}

/// Moves and what would have gone on; the belief is a picture's matter and large.
void write_intent(JsonText& json, const FrameIntent& intent, const MotionLibrary& library) {
  json.key("intent").begin_object();
  json.key("moves").begin_object();
  for (std::size_t m = 0; m < intent.moves.size(); ++m)
    json.key(intent.model->labels()[m]).value(static_cast<double>(intent.moves[m]));
  json.end_object();
  json.key("continued");
  if (intent.continued < 0) {
    json.null();
  } else {
    const PairSource& source = library.source(intent.continued);
    json.begin_object();
    json.key("take").value(library.take_of(intent.continued).name);
    json.key("frame").value(static_cast<int>(source.frame));
    json.key("swapped").value(source.swapped);
    json.end_object();
  }
  json.end_object();
}

void write_contacts(JsonText& json, const FrameResult& frame) {
  json.key("foot_locks").begin_array();
  for (const FootLock& lock : frame.foot_locks)
    json.value(std::string(lock.active_body ? "active." : "passive.") + (lock.left ? "left" : "right"));
  json.end_array();
  json.key("collisions").begin_array();
  for (const CapsuleContact& contact : frame.collisions) {
    json.begin_object();
    write_indices(json.key("a"), contact.a);
    write_indices(json.key("b"), contact.b);
    json.key("depth_m").value(contact.depth_m);
    json.key("allowed_depth_m").value(contact.allowed_depth_m);
    json.end_object();
  }
  json.end_array();
}

void write_measures(JsonText& json, const FrameResult& frame) {
  json.key("energy").begin_object();
  json.key("deformation").value(frame.energy.deformation);
  json.key("velocity").value(frame.energy.velocity);
  json.key("constraint").value(frame.energy.constraint);
  json.end_object();
  json.key("residual").begin_object();
  json.key("bone_length_max").value(frame.residual.bone_length_max);
  json.key("foot_lock_max_m").value(frame.residual.foot_lock_max_m);
  json.key("penetration_max_m").value(frame.residual.penetration_max_m);
  json.key("excess_penetration_max_m").value(frame.residual.excess_penetration_max_m);
  json.key("morph_rms_m").value(frame.residual.morph_rms_m);
  json.end_object();
}

/// @param library  null for a frame without candidates
std::string frame_line(const FrameResult& frame, const MotionLibrary* library, long long input_frame,
                       double time_s) {
  JsonText json;
  json.begin_object();
  json.key("frame").value(input_frame);
  json.key("time").value(time_s);
  json.key("query").begin_object();
  json.key("world").rows(frame.query_world);
  json.key("normalized").rows(frame.query_normalized);
  json.key("features").begin_array();
  for (const double feature : frame.features) json.value(feature);
  json.end_array().end_object();
  if (library) write_candidates(json, frame, *library);
  if (library && frame.intent.model) write_intent(json, frame.intent, *library);
  if (library) json.key("selected").value(frame.selected);
  json.key("source_changed").value(frame.source_changed);
  json.key("selected_pair").begin_object();
  json.key("active").rows(frame.selected_pair.topRows<joint_count>());
  json.key("passive").rows(frame.selected_pair.bottomRows<joint_count>());
  json.end_object();
  json.key("mesh").begin_object();
  json.key("edges").begin_array();
  for (const MeshEdge& edge : frame.edges) write_indices(json, edge);
  json.end_array();
  json.key("tetrahedra").begin_array();
  for (const MeshTetrahedron& tetrahedron : frame.tetrahedra) write_indices(json, tetrahedron);
  json.end_array().end_object();
  json.key("active").rows(frame.active());
  json.key("passive").rows(frame.passive());
  write_measures(json, frame);
  write_contacts(json, frame);
  json.key("status").value(frame.status_text());
  json.key("timing_us").begin_object();
  json.key("retarget").value(frame.timing.retarget_us);
  json.key("select").value(frame.timing.select_us);
  json.key("mesh").value(frame.timing.mesh_us);
  json.key("solve").value(frame.timing.solve_us);
  json.key("total").value(frame.timing.total_us);
  json.end_object().end_object();
  return json.take();
}

}  // namespace

std::string trace_header_line(const TraceHeader& header) {
  JsonText json;
  json.begin_object();
  json.key("abrazo_trace").value(1);
  json.key("version").value(version());
  json.key("library").value(header.library);
  json.key("input").value(header.input);
  std::string line = json.take();
  line += ",\"settings\":" + settings_json(header.settings);
  JsonText rest;
  rest.begin_object();
  rest.key("joints").begin_array();
  for (const std::string_view name : joint_names) rest.value(name);
  rest.end_array();
  rest.key("units").value("m");
  rest.key("fps").value(header.fps);
  rest.end_object();
  return line + "," + rest.text().substr(1);
}

std::string trace_frame_line(const FrameResult& frame, const MotionLibrary& library, long long input_frame,
                             double time_s) {
  return frame_line(frame, &library, input_frame, time_s);
}

std::string trace_frame_line(const FrameResult& frame, long long input_frame, double time_s) {
  return frame_line(frame, nullptr, input_frame, time_s);
}

}  // namespace abrazo
