#pragma once

#include <algorithm>

#include "core/video/camera_model.hpp"

namespace abrazo::widgets {

/// Where a picture lies in a view, both with x to the right and y down; view in its own pixels. The middle of
/// the picture's first pixel is (0, 0), so that its corner is at (-0.5, -0.5).
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

/// How near a person came to a picture, and to which place of it; stays when the view changes its size.
struct PictureZoom {
  static constexpr double nearest = 64;  ///< view pixels per picture pixel

  double factor = 1;   ///< of the scale at which the whole picture fits; not below 1
  Pixel middle{0, 0};  ///< of the view, in the picture; of no effect along an axis that is whole in view

  bool is_fitted() const { return factor <= 1; }
};

/// The largest scale at which all of it is in view.
inline double fitted_scale(PictureSize picture, PictureSize view) {
  return picture.empty() || view.empty() ? 1
                                         : std::min(view.width / picture.width, view.height / picture.height);
}

/// The picture never leaves more room at one side than it has to: what is whole in view is in the middle.
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

/// Nearer by a factor, or farther; what is at a place of the view stays there as far as it can.
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

/// The view moves by this number of its pixels.
inline PictureZoom panned(PictureSize picture, PictureSize view, const PictureZoom& zoom, double dx,
                          double dy) {
  PictureZoom next = zoom;
  const PictureFraming now = framing(picture, view, zoom);
  next.middle = now.to_picture(view.width / 2 - dx, view.height / 2 - dy);
  return next;
}

}  // namespace abrazo::widgets
