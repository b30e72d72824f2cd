#pragma once

namespace abrazo::app {

class MainWindow;

/// The window's views show its document, and what they ask for is asked there.
void show_document(MainWindow& window);

}  // namespace abrazo::app
