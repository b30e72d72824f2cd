#pragma once

namespace abrazo::app {

class MainWindow;

/// Connects the window's views with its document: they show it and request changes of it.
void show_document(MainWindow& window);

/// Ticker and transport on the session's own frames: those of a clip are played once, from the beginning.
void show_frames_of_session(MainWindow& window);

}  // namespace abrazo::app
