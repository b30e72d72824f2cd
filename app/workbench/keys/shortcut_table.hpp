#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo::app {

/// Where a key works. Two actions clash over a key only where both could be meant.
enum class KeyPlace { Window, Scene, Timeline };

constexpr bool overlap(KeyPlace a, KeyPlace b) {
  return a == b || a == KeyPlace::Window || b == KeyPlace::Window;
}

/// " in the scene"; nothing for the whole window.
std::string_view words_of(KeyPlace place);

/// An action and the keys that trigger it, as portable text: "Ctrl+Shift+Z".
struct Shortcut {
  std::string id;  ///< the same in every version: "play.play_or_pause"
  std::string menu;
  std::string text;
  std::vector<std::string> keys, usual;
  KeyPlace place = KeyPlace::Window;
  bool is_fixed = false;  ///< belongs to a view that takes it before any action

  bool is_changed() const { return keys != usual; }
};

/// Which key does what, and what of it a person has changed. Knows no toolkit.
class ShortcutTable {
 public:
  void add(Shortcut shortcut) { m_all.push_back(std::move(shortcut)); }
  const std::vector<Shortcut>& all() const { return m_all; }
  const Shortcut* find(std::string_view id) const;

  /// Others that have this key in a place where the action works too; those of views come last.
  std::vector<const Shortcut*> clashes(std::string_view id, std::string_view key) const;
  /// One key more for the action. Those that clash lose it, except a view's own.
  void give(std::string_view id, const std::string& key);
  void take(std::string_view id, std::string_view key);
  /// The usual keys again; who has one of them meanwhile loses it.
  void reset(std::string_view id);
  void reset_all();

  /// What differs from the usual, as JSON, and what was read and could not be used.
  std::string text() const;
  /// Of JSON as text() writes it. What cannot be used is left out, told, and kept for text().
  /// @param normal  the portable text of a key, empty where it is none
  /// @return a sentence for each entry that is left out
  using Normal = std::function<std::string(const std::string&)>;
  std::vector<std::string> read(const std::string& text, const Normal& normal);

 private:
  Shortcut* own(std::string_view id);
  std::string refuse(const std::string& id, const std::string& raw, const std::string& why);
  void settle(std::map<std::string, std::string> read, std::vector<std::string>& told);

  std::vector<Shortcut> m_all;
  std::map<std::string, std::string> m_unused;  ///< by id, the JSON of what could not be used
};

}  // namespace abrazo::app
