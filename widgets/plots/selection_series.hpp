#pragma once

#include <optional>

#include "widgets/common/selection.hpp"
#include "widgets/plots/pane_arrangement.hpp"

namespace abrazo::widgets {

/// The series of a selection; for joints of the one selected last. Empty for a candidate.
PaneSeries series_of(const Selection& selection);
/// The series that depend on the selection.
const PaneSeries& selection_series();

/// |delta - L(v')| of one vertex [m]: the deformation of its neighbourhood relative to the selected pair. The
/// edge residuals of the frame are means of these.
double vertex_residual_m(const FrameSnapshot& frame, int vertex);

/// Computes the series of one selection for frames in order; NaN if the mesh of a frame does not have the
/// item. A speed needs the previous frame.
class SelectionReader {
 public:
  SelectionReader() = default;
  explicit SelectionReader(Selection selection) : selection_(std::move(selection)) {}
  void read(const FrameSnapshot& frame, SeriesValues& values);

 private:
  void read_joint(const FrameSnapshot& frame, SeriesValues& values);

  struct Previous {
    std::uint64_t index;
    double time_s;
    Vec3 position;
  };
  Selection selection_;
  std::optional<Previous> previous_;
};

}  // namespace abrazo::widgets
