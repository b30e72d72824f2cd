#pragma once

#include <optional>

#include "widgets/common/selection.hpp"
#include "widgets/plots/pane_arrangement.hpp"

namespace abrazo::widgets {

/// What a pane shows of a selection: of joints the one that was selected last. Nothing for a candidate.
PaneSeries series_of(const Selection& selection);
/// The series that depend on what is selected.
const PaneSeries& selection_series();

/// |delta - L(v')| of one vertex [m]: how far its neighbourhood is bent from the selected pair's, as the
/// residuals of the frame are the means of.
double vertex_residual_m(const FrameSnapshot& frame, int vertex);

/// Reads the series of one selection off frames that come in order; NaN where the mesh of a frame has not got
/// what is selected. A speed needs the frame before.
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
