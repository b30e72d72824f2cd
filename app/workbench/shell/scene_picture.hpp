#pragma once

#include <QImage>

namespace abrazo::widgets {
class SceneView;
}

namespace abrazo::app {

/// What stands on black in one picture and on white in the other, alone: how much of the background is seen
/// through each pixel is what differs between the two.
QImage without_background(const QImage& on_black, const QImage& on_white);

/// The scene alone, on nothing.
QImage transparent_picture(widgets::SceneView& scene);

}  // namespace abrazo::app
