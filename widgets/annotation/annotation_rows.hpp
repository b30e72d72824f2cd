#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/annotation/annotations.hpp"

namespace abrazo::widgets {

/// A time as typed: "12.5" or "12.5 s", "1:05.2" (minutes), "750 f" or "#750" (a frame, if there is a frame
/// rate). None for other text. Independent of Qt.
std::optional<double> typed_time(std::string_view text, double fps);

/// "12.517", and "751" if there is a frame rate.
std::string seconds_text(double time_s);
std::string frame_text(double time_s, double fps);

/// "3 labels, 92 % of 35.0 s".
std::string coverage_text(const AnnotationTier& tier, const Annotations::Range& range);

}  // namespace abrazo::widgets
