#pragma once

#include <optional>
#include <string>

#include "core/video/camera_model.hpp"

namespace abrazo::widgets {

/// A picked joint, marked on the picture and listed beside it.
struct PickMark {
  Pixel pixel;
  std::string name;                ///< "leader lhand"
  double subject_s = 0;            ///< when
  bool is_here = true;             ///< in the shown picture; others are only listed
  std::optional<Pixel> projected;  ///< by the solved camera
  std::optional<double> error_px;
  bool is_outlier = false;  ///< left out by the solution

  bool operator==(const PickMark&) const = default;
};

}  // namespace abrazo::widgets
