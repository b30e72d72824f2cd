#pragma once

namespace abrazo::app {

class MainWindow;

/// Connects the window's views with its document: they show it and request changes of it.
void show_document(MainWindow& window);

}  // namespace abrazo::app
