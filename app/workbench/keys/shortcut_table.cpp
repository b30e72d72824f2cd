#include "app/workbench/keys/shortcut_table.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/base/limits.hpp"

namespace abrazo::app {
namespace {

using Json = nlohmann::ordered_json;

bool has(const std::vector<std::string>& keys, std::string_view key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

void drop(std::vector<std::string>& keys, std::string_view key) {
  keys.erase(std::remove(keys.begin(), keys.end(), key), keys.end());
}

bool clash(const Shortcut& a, const Shortcut& b, std::string_view key) {
  return &a != &b && overlap(a.place, b.place) && has(a.keys, key) && has(b.keys, key);
}

std::string named(const std::string& text) {
  return "'" + text + "'";
}

/// @return the keys; `why` has the reason if they are invalid
std::vector<std::string> keys_of(const Json& entry, const ShortcutTable::Normal& normal, std::string& why) {
  std::vector<std::string> keys;
  if (!entry.is_array()) why = "its keys are not a list such as [\"Ctrl+K\"]";
  for (const Json& each : why.empty() ? entry : Json::array()) {
    const std::string key = each.is_string() ? normal(each.get<std::string>()) : std::string();
    if (key.empty())
      why = named(each.is_string() ? each.get<std::string>() : each.dump()) + " is not a key";
    else if (!has(keys, key))
      keys.push_back(key);
  }
  return keys;
}

}  // namespace

std::string_view words_of(KeyPlace place) {
  switch (place) {
    case KeyPlace::Scene:
      return " in the scene";
    case KeyPlace::Timeline:
      return " in the timeline";
    case KeyPlace::Window:
      break;
  }
  return "";
}

const Shortcut* ShortcutTable::find(std::string_view id) const {
  const auto found = std::find_if(m_all.begin(), m_all.end(), [id](const Shortcut& s) { return s.id == id; });
  return found == m_all.end() ? nullptr : &*found;
}

Shortcut* ShortcutTable::own(std::string_view id) {
  const auto found = std::find_if(m_all.begin(), m_all.end(), [id](const Shortcut& s) { return s.id == id; });
  return found == m_all.end() || found->is_fixed ? nullptr : &*found;
}

std::vector<const Shortcut*> ShortcutTable::clashes(std::string_view id, std::string_view key) const {
  std::vector<const Shortcut*> found;
  const Shortcut* self = find(id);
  if (!self) return found;
  for (const Shortcut& other : m_all)
    if (&other != self && has(other.keys, key) && overlap(self->place, other.place)) found.push_back(&other);
  std::stable_partition(found.begin(), found.end(), [](const Shortcut* s) { return !s->is_fixed; });
  return found;
}

void ShortcutTable::give(std::string_view id, const std::string& key) {
  Shortcut* self = own(id);
  if (!self) return;
  for (const Shortcut* other : clashes(id, key))
    if (!other->is_fixed) take(other->id, key);
  if (!has(self->keys, key)) self->keys.push_back(key);
  m_unused.erase(self->id);
}

void ShortcutTable::take(std::string_view id, std::string_view key) {
  Shortcut* self = own(id);
  if (!self) return;
  drop(self->keys, key);
  m_unused.erase(self->id);
}

void ShortcutTable::reset(std::string_view id) {
  Shortcut* self = own(id);
  if (!self) return;
  self->keys.clear();
  for (const std::string& key : self->usual) give(id, key);
  m_unused.erase(self->id);
}

void ShortcutTable::reset_all() {
  for (Shortcut& each : m_all) {
    each.keys = each.usual;
    m_unused.erase(each.id);
  }
}

std::string ShortcutTable::text() const {
  Json keys = Json::object();
  for (const Shortcut& each : m_all)
    if (each.is_changed()) keys[each.id] = each.keys;
  for (const auto& [id, raw] : m_unused) keys[id] = Json::parse(raw);
  return Json{{"abrazo_shortcuts", 1}, {"keys", keys}}.dump(2) + "\n";
}

std::string ShortcutTable::refuse(const std::string& id, const std::string& raw, const std::string& why) {
  m_unused[id] = raw;
  return "shortcut of " + named(id) + ": " + why;
}

std::vector<std::string> ShortcutTable::read(const std::string& text, const Normal& normal) {
  std::vector<std::string> told;
  const Json json = json_beyond_bounds(text) ? Json() : Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("abrazo_shortcuts") || !json.contains("keys") ||
      !json.at("keys").is_object())
    return {"is not a list of shortcuts, or is damaged; the default keys are in use"};
  std::map<std::string, std::string> used;
  for (const auto& [id, entry] : json.at("keys").items()) {
    Shortcut* self = own(id);
    std::string why;
    const std::vector<std::string> keys = keys_of(entry, normal, why);
    if (!self)
      told.push_back(refuse(id, entry.dump(), "there is no such action in this version"));
    else if (!why.empty())
      told.push_back(refuse(id, entry.dump(), why + "; its default keys are in use"));
    else
      self->keys = keys, used[id] = entry.dump();
  }
  settle(used, told);
  return told;
}

/// Of two changed actions with the same key the later one is skipped; a changed key overrides a default key.
void ShortcutTable::settle(std::map<std::string, std::string> read, std::vector<std::string>& told) {
  for (Shortcut& self : m_all) {
    if (!read.contains(self.id)) continue;
    const auto first = std::find_if(m_all.begin(), m_all.end(), [&](const Shortcut& other) {
      return &other < &self && read.contains(other.id) &&
             std::any_of(self.keys.begin(), self.keys.end(),
                         [&](const std::string& key) { return clash(self, other, key); });
    });
    if (first == m_all.end()) continue;
    told.push_back(
        refuse(self.id, read.at(self.id),
               "one of its keys belongs to " + named(first->text) + "; its default keys are in use"));
    self.keys = self.usual;
    read.erase(self.id);
  }
  for (const Shortcut& self : m_all)
    for (Shortcut& other : m_all)
      if (read.contains(self.id) && !read.contains(other.id) && !other.is_fixed)
        for (const std::string& key : self.keys)
          if (clash(self, other, key)) drop(other.keys, key);
}

}  // namespace abrazo::app
