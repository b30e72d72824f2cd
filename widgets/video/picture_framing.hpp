#pragma once

#include <algorithm>

#include "core/video/camera_model.hpp"

namespace abrazo::widgets {

/// Position of a picture in a view, both with x to the right and y down, each in its own pixels. The middle
/// of the picture's first pixel is (0, 0), so that its corner is at (-0.5, -0.5).
struct PictureFraming {
  double scale = 1;          ///< view pixels per picture pixel
  double left = 0, top = 0;  ///< corner of the picture in the view

  double x(double picture_x) const { return left + (picture_x + 0.5) * scale; }
  double y(double picture_y) const { return top + (picture_y + 0.5) * scale; }
  Pixel to_picture(double view_x, double view_y) const {
    return {(view_x - left) / scale - 0.5, (view_y - top) / scale - 0.5};
  }
};

struct PictureSize {
  double width = 0, height = 0;
  bool empty() const { return !(width > 0 && height > 0); }
};

/// Zoom and centre of a picture; independent of the view's size.
struct PictureZoom {
  static constexpr double nearest = 64;  ///< view pixels per picture pixel

  double factor = 1;   ///< relative to the scale at which the whole picture fits; at least 1
  Pixel middle{0, 0};  ///< centre of the view, in the picture; ignored along an axis that fits

  bool is_fitted() const { return factor <= 1; }
};

/// The largest scale at which the whole picture is visible.
inline double fitted_scale(PictureSize picture, PictureSize view) {
  return picture.empty() || view.empty() ? 1
                                         : std::min(view.width / picture.width, view.height / picture.height);
}

/// The picture never leaves unnecessary room at one side; an axis that fits is centred.
inline PictureFraming framing(PictureSize picture, PictureSize view, const PictureZoom& zoom) {
  PictureFraming frame;
  frame.scale = fitted_scale(picture, view) * std::max(1.0, zoom.factor);
  const auto placed = [scale = frame.scale](double size, double room, double middle) {
    const double wide = size * scale;
    if (wide <= room) return (room - wide) / 2;
    return std::clamp(room / 2 - (middle + 0.5) * scale, room - wide, 0.0);
  };
  frame.left = placed(picture.width, view.width, zoom.middle.x());
  frame.top = placed(picture.height, view.height, zoom.middle.y());
  return frame;
}

/// Zooms by a factor about a point of the view, as far as possible.
inline PictureZoom zoomed(PictureSize picture, PictureSize view, const PictureZoom& zoom, double by,
                          double view_x, double view_y) {
  const double fit = fitted_scale(picture, view);
  const Pixel held = framing(picture, view, zoom).to_picture(view_x, view_y);
  PictureZoom next;
  next.factor = std::clamp(zoom.factor * by, 1.0, std::max(1.0, PictureZoom::nearest / fit));
  const double scale = fit * next.factor;
  next.middle = {held.x() + (view.width / 2 - view_x) / scale, held.y() + (view.height / 2 - view_y) / scale};
  return next;
}

/// Moves the view by this number of its pixels.
inline PictureZoom panned(PictureSize picture, PictureSize view, const PictureZoom& zoom, double dx,
                          double dy) {
  PictureZoom next = zoom;
  const PictureFraming now = framing(picture, view, zoom);
  next.middle = now.to_picture(view.width / 2 - dx, view.height / 2 - dy);
  return next;
}

}  // namespace abrazo::widgets
