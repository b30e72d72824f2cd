#pragma once

#include "widgets/common/palette.hpp"
#include "widgets/video/picture_framing.hpp"
#include "widgets/video/video_overlay.hpp"

class QPainter;

namespace abrazo::widgets {

/// Appearance of the lines, in views and films: leader solid, follower dashed, mesh thin.
struct OverlayLook {
  double opacity = 0.9;
  double thickness = 1;  ///< of all lines; 2 for a film twice as large
};

void paint_overlay(QPainter& painter, const VideoOverlay& overlay, const PictureFraming& framing,
                   const Palette& palette, const OverlayLook& look);

}  // namespace abrazo::widgets
