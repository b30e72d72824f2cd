#pragma once

namespace abrazo::app {

/// Lowers the priority of Mesa's software rendering threads: they use all processor cores for milliseconds at
/// a time, which would delay the answer to a packet. Call after the first picture, which starts them.
/// @return their number; 0 with a graphics card
int make_software_renderer_stand_back();

}  // namespace abrazo::app
