#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo::app {

/// Scope of a key. Two actions conflict over a key only in overlapping scopes.
enum class KeyPlace { Window, Scene, Timeline };

constexpr bool overlap(KeyPlace a, KeyPlace b) {
  return a == b || a == KeyPlace::Window || b == KeyPlace::Window;
}

/// " in the scene"; empty for the whole window.
std::string_view words_of(KeyPlace place);

/// An action and the keys that trigger it, as portable text: "Ctrl+Shift+Z".
struct Shortcut {
  std::string id;  ///< the same in every version: "play.play_or_pause"
  std::string menu;
  std::string text;
  std::vector<std::string> keys, usual;
  KeyPlace place = KeyPlace::Window;
  bool is_fixed = false;  ///< belongs to a view that handles it before any action

  bool is_changed() const { return keys != usual; }
};

/// Keys of all actions, and the user's changes. Independent of Qt.
class ShortcutTable {
 public:
  void add(Shortcut shortcut) { m_all.push_back(std::move(shortcut)); }
  const std::vector<Shortcut>& all() const { return m_all; }
  const Shortcut* find(std::string_view id) const;

  /// Other actions with this key in an overlapping scope; those of views come last.
  std::vector<const Shortcut*> clashes(std::string_view id, std::string_view key) const;
  /// Adds a key to an action. Conflicting actions lose it, except those of views.
  void give(std::string_view id, const std::string& key);
  void take(std::string_view id, std::string_view key);
  /// Restores the default keys; other actions that use them lose them.
  void reset(std::string_view id);
  void reset_all();

  /// Differences from the defaults as JSON, including unusable entries that were read.
  std::string text() const;
  /// Reads the JSON of text(). Unusable entries are skipped, reported, and kept for text().
  /// @param normal portable text of a key, empty if invalid
  /// @return one sentence per skipped entry
  using Normal = std::function<std::string(const std::string&)>;
  std::vector<std::string> read(const std::string& text, const Normal& normal);

 private:
  Shortcut* own(std::string_view id);
  std::string refuse(const std::string& id, const std::string& raw, const std::string& why);
  void settle(std::map<std::string, std::string> read, std::vector<std::string>& told);

  std::vector<Shortcut> m_all;
  std::map<std::string, std::string> m_unused;  ///< JSON of unusable entries, by id
};

}  // namespace abrazo::app
