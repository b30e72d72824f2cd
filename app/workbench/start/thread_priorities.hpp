#pragma once

namespace abrazo::app {

/// The threads with which Mesa draws where there is no graphics card stand back behind all others of the
/// program: they take every core for milliseconds at a time, in which a packet would wait for its answer. To
/// be called once there is a picture, since they begin with it.
/// @return how many there are; 0 with a graphics card
int make_software_renderer_stand_back();

}  // namespace abrazo::app
