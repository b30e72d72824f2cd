#pragma once

#include <QString>
#include <span>

namespace abrazo::app {

/// Other words for a command: formats, names in other programs, what it is good for.
struct CommandWords {
  const char* id;  ///< of the action
  const char* words;
};
std::span<const CommandWords> command_words();

/// How well a command answers what was typed: more is better, 0 is not at all. Every typed word must be the
/// beginning of a word of its text, of its menu or of its other words; text counts most.
int command_match(const QString& typed, const QString& id, const QString& text, const QString& menu);

}  // namespace abrazo::app
