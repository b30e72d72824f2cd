#include <fmt/format.h>

#include "app/python/frame.hpp"
#include "core/selection/candidate.hpp"

namespace abrazo::python {

RecordedFrame::RecordedFrame(FrameSnapshotPtr recorded)
    : Frame{std::shared_ptr<const FrameResult>(recorded, &recorded->result), recorded->library},
      snapshot(std::move(recorded)) {}

Source source_of(const MotionLibrary& library, int pair) {
  const PairSource& source = library.source(pair);
  return {pair, library.take_of(pair).name, static_cast<int>(source.frame), source.swapped,
          std::string(library.label(pair))};
}

namespace {

/// A candidate of a frame, which it keeps.
struct FrameCandidate {
  std::shared_ptr<const Candidate> candidate;
  std::shared_ptr<const MotionLibrary> library;
};

const FrameResult& result_of(py::handle frame) {
  return *frame.cast<const Frame&>().result;
}

std::optional<Source> source_in(const std::shared_ptr<const MotionLibrary>& library, int pair) {
  if (!library || pair < 0 || pair >= library->pair_count()) return std::nullopt;
  return source_of(*library, pair);
}

std::optional<Source> source_of_frame(const Frame& frame) {
  const FrameResult& result = *frame.result;
  if (result.selected < 0) return std::nullopt;
  return source_in(frame.library, result.candidates[static_cast<std::size_t>(result.selected)].pair);
}

std::vector<FrameCandidate> candidates_of(const Frame& frame) {
  std::vector<FrameCandidate> candidates;
  for (const Candidate& candidate : frame.result->candidates)
    candidates.push_back({std::shared_ptr<const Candidate>(frame.result, &candidate), frame.library});
  return candidates;
}

std::vector<std::string> foot_locks_of(const Frame& frame) {
  std::vector<std::string> locks;
  for (const FootLock& lock : frame.result->foot_locks)
    locks.push_back(std::string(lock.active_body ? "active." : "passive.") + (lock.left ? "left" : "right"));
  return locks;
}

/// A property of a frame that is an array without a copy.
template <typename Value>
auto pose_property(Value value) {
  return [value](py::handle frame) { return view_of(value(result_of(frame)), {joint_count, 3}, frame); };
}

void bind_measures(py::module_& module) {
  py::class_<FrameEnergy>(module, "Energy", "Energies of Eq. 11 at the result [m^2].")
      .def_readonly("deformation", &FrameEnergy::deformation,
                    "E_L: how far the spatial relations of the selected pair are distorted.")
      .def_readonly("velocity", &FrameEnergy::velocity, "E_V, not yet times velocity-weight.")
      .def_readonly("constraint", &FrameEnergy::constraint, "E_C: distance to the user's pose, weighted.");
  py::class_<FrameResidual>(module, "Residual",
                            "How far the nonlinear constraints are from being met: measured at the result.")
      .def_readonly("bone_length_max", &FrameResidual::bone_length_max,
                    "Largest |length - wanted| / wanted of a bone.")
      .def_readonly("foot_lock_max_m", &FrameResidual::foot_lock_max_m,
                    "Largest distance of a locked foot from its place [m].")
      .def_readonly("penetration_max_m", &FrameResidual::penetration_max_m,
                    "Deepest overlap of the two bodies [m].")
      .def_readonly("excess_penetration_max_m", &FrameResidual::excess_penetration_max_m,
                    "Deepest overlap beyond that of the selected pair [m].")
      .def_readonly("morph_rms_m", &FrameResidual::morph_rms_m,
                    "Of the active joints from the user's pose, root mean square [m].");
  py::class_<StepTiming>(module, "Timing", "Where the time of a step went [microseconds].")
      .def_readonly("retarget_us", &StepTiming::retarget_us)
      .def_readonly("select_us", &StepTiming::select_us)
      .def_readonly("mesh_us", &StepTiming::mesh_us)
      .def_readonly("solve_us", &StepTiming::solve_us)
      .def_readonly("total_us", &StepTiming::total_us);
  py::class_<CostBreakdown>(module, "Cost", "Eq. 7 term by term [m^2].")
      .def_readonly("pose", &CostBreakdown::pose,
                    "Sum over the joints of |user's pose - the pair's active pose|^2, normalised.")
      .def_readonly("temporal_active", &CostBreakdown::temporal_active,
                    "Sum over the joints from the predicted active pose, not yet times alpha.")
      .def_readonly("temporal_passive", &CostBreakdown::temporal_passive,
                    "Sum over the joints from the predicted passive pose, not yet times alpha.")
      .def_readonly("total", &CostBreakdown::total,
                    "pose + alpha (temporal_active + temporal_passive): the less the better.");
  py::class_<IntentCost>(module, "IntentCost", "The cost of the selection 'intent', term by term [m].")
      .def_readonly("partner", &IntentCost::partner)
      .def_readonly("leader", &IntentCost::leader)
      .def_readonly("move", &IntentCost::move)
      .def_readonly("meant", &IntentCost::meant)
      .def_readonly("change", &IntentCost::change)
      .def_readonly("temporal", &IntentCost::temporal)
      .def_readonly("total", &IntentCost::total);
}

void bind_sources(py::module_& module) {
  py::class_<Source>(module, "Source", "Where a pair of a library was recorded.")
      .def_readonly("pair", &Source::pair, "Number of the pair in the library.")
      .def_readonly("take", &Source::take)
      .def_readonly("frame", &Source::frame, "Of the take's own file, from 0.")
      .def_readonly("swapped", &Source::swapped, "Performer B is the active one.")
      .def_readonly("label", &Source::label, "The move at this frame; empty when it has none.")
      .def("__repr__", [](const Source& source) {
        return fmt::format("<abrazo.Source {} frame {}{}>", source.take, source.frame,
                           source.swapped ? " swapped" : "");
      });
  py::class_<FrameCandidate>(module, "Candidate", "A recorded pair that was considered for a frame.")
      .def_property_readonly(
          "pair", [](const FrameCandidate& self) { return self.candidate->pair; },
          "Number of the pair in the library.")
      .def_property_readonly(
          "source", [](const FrameCandidate& self) { return source_in(self.library, self.candidate->pair); },
          "Where it was recorded; None when the library is not at hand.")
      .def_property_readonly(
          "feature_distance", [](const FrameCandidate& self) { return self.candidate->feature_distance; },
          "Of the 15-dimensional features, Euclidean [m].")
      .def_property_readonly(
          "continuation", [](const FrameCandidate& self) { return self.candidate->continuation; },
          "It joined because it continues the current source.")
      .def_property_readonly(
          "cost", [](const FrameCandidate& self) { return self.candidate->cost; }, "Eq. 7 term by term.")
      .def_property_readonly(
          "intent", [](const FrameCandidate& self) { return self.candidate->intent; },
          "With the selection 'intent' its cost, which decides; else None.");
}

}  // namespace

void bind_frame(py::module_& module) {
  bind_measures(module);
  bind_sources(module);
  py::class_<Frame> frame(
      module, "Frame",
      "One solved frame, with its reasons. World space, metres, Y up; arrays are float64, read-only views.");
  frame
      .def_property_readonly("active", pose_property([](const FrameResult& r) { return r.result.data(); }),
                             "(25, 3) [m]: the body of the active role.")
      .def_property_readonly("passive",
                             pose_property([](const FrameResult& r) { return r.result.data() + 75; }),
                             "(25, 3) [m]: the body of the passive role.")
      .def_property_readonly("query_world",
                             pose_property([](const FrameResult& r) { return r.query_world.data(); }),
                             "(25, 3) [m]: the user, retargeted to the library's body.")
      .def_property_readonly("query_normalized",
                             pose_property([](const FrameResult& r) { return r.query_normalized.data(); }),
                             "(25, 3) [m]: the same from the user's root and heading (Eq. 1-2).")
      .def_property_readonly(
          "features", [](py::handle self) { return view_of(result_of(self).features.data(), {15}, self); },
          "(15,) [m]: what the nearest pairs were searched by.")
      .def_property_readonly(
          "selected_pair",
          [](py::handle self) {
            return view_of(result_of(self).selected_pair.data(), {2, joint_count, 3}, self);
          },
          "(2, 25, 3) [m]: the recorded pair that was edited, active then passive, at the user's place.")
      .def_property_readonly(
          "edges",
          [](py::handle self) {
            const auto& edges = result_of(self).edges;
            return view_of(edges.empty() ? nullptr : edges.front().data(),
                           {static_cast<py::ssize_t>(edges.size()), 2}, self);
          },
          "(E, 2) uint8: edges of the interaction mesh; vertices 0-24 are active, 25-49 passive.")
      .def_property_readonly(
          "tetrahedra",
          [](py::handle self) {
            const auto& tetrahedra = result_of(self).tetrahedra;
            return view_of(tetrahedra.empty() ? nullptr : tetrahedra.front().data(),
                           {static_cast<py::ssize_t>(tetrahedra.size()), 4}, self);
          },
          "(C, 4) uint8: tetrahedra of the interaction mesh.")
      .def_property_readonly(
          "edge_weights",
          [](py::handle self) {
            const auto& weights = result_of(self).edge_weights;
            return view_of(weights.data(), {static_cast<py::ssize_t>(weights.size())}, self);
          },
          "(E,): weight of each edge.")
      .def_property_readonly(
          "edge_residuals",
          [](py::handle self) {
            const auto& residuals = result_of(self).edge_residuals_m;
            return view_of(residuals.data(), {static_cast<py::ssize_t>(residuals.size())}, self);
          },
          "(E,) [m]: Laplacian residual of each edge, the mean of its ends.")
      .def_property_readonly(
          "morph_steps",
          [](py::handle self) {
            const auto& steps = result_of(self).morph_steps;
            return view_of(steps.empty() ? nullptr : steps.front().data(),
                           {static_cast<py::ssize_t>(steps.size()), 2, joint_count, 3}, self);
          },
          "(S, 2, 25, 3) [m]: both bodies after each morph and projection step; the last is the result.");
  frame.def_property_readonly("candidates", candidates_of, "Those considered, nearest feature first.")
      .def_property_readonly(
          "selected",
          [](const Frame& self) {
            return self.result->selected < 0 ? std::nullopt : std::optional<int>(self.result->selected);
          },
          "Index into candidates; None when nothing could be selected.")
      .def_property_readonly("source", source_of_frame, "Where the selected pair was recorded, or None.")
      .def_property_readonly(
          "source_changed", [](const Frame& self) { return self.result->source_changed; },
          "The selected pair does not continue the one of the frame before.")
      .def_property_readonly(
          "energy", [](const Frame& self) { return &self.result->energy; },
          py::return_value_policy::reference_internal, "Energies of Eq. 11.")
      .def_property_readonly(
          "residual", [](const Frame& self) { return &self.result->residual; },
          py::return_value_policy::reference_internal, "What of the constraints was not met.")
      .def_property_readonly("foot_locks", foot_locks_of,
                             "Feet that are held where they landed: 'active.left', ...")
      .def_property_readonly(
          "status", [](const Frame& self) { return self.result->status_text(); },
          "'ok', 'relaxed: why' or 'failed: why'; after a failure the last good poses are held.")
      .def_property_readonly(
          "timing", [](const Frame& self) { return &self.result->timing; },
          py::return_value_policy::reference_internal, "Where the time of the step went.")
      .def("__repr__", [](const Frame& self) {
        const auto source = source_of_frame(self);
        return fmt::format("<abrazo.Frame {}{}>", self.result->status_text(),
                           source ? fmt::format(", of {} frame {}", source->take, source->frame) : "");
      });
}

}  // namespace abrazo::python
