#pragma once

#include <QImage>

namespace abrazo::widgets {
class SceneView;
}

namespace abrazo::app {

/// A picture with transparent background from two pictures on black and on white: their difference gives the
/// transparency of each pixel.
QImage without_background(const QImage& on_black, const QImage& on_white);

/// The scene with transparent background.
QImage transparent_picture(widgets::SceneView& scene);

}  // namespace abrazo::app
