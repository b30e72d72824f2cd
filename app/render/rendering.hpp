#pragma once

#include "app/render/frame_source.hpp"
#include "app/render/render_options.hpp"

namespace abrazo::app {

struct Rendered {
  std::string file;  ///< the first one of a series
  int pictures = 0;
};

/// Draws the frames off screen and writes them. The same frames and options give the same pictures. Leaves
/// nothing behind on failure or cancellation. Needs a QApplication.
Result<Rendered> render(const FrameSource& source, const RenderOptions& options, const Progress& progress);

}  // namespace abrazo::app
