#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// A marked instant of a session.
struct Marker {
  int id = 0;  ///< unique in its list, never reused
  double time_s = 0;
  std::string name;  ///< may be empty

  bool operator==(const Marker&) const = default;
};

/// The markers of a session, earliest first. A value type: undo steps keep copies.
class Markers {
 public:
  const std::vector<Marker>& all() const { return markers_; }
  bool empty() const { return markers_.empty(); }
  const Marker* find(int id) const;

  /// @return its id
  int add(double time_s, std::string_view name = {});
  /// No effect on an unknown id.
  void move(int id, double time_s);
  void rename(int id, std::string_view name);
  void remove(int id);

  /// The last marker before or the first after a time, by more than `apart_s`; null if there is none.
  const Marker* before(double time_s, double apart_s = 1e-6) const;
  const Marker* after(double time_s, double apart_s = 1e-6) const;
  /// The marker nearest to a time within `reach_s`; null if there is none.
  const Marker* near(double time_s, double reach_s) const;

  /// Stored markers with their ids; a duplicate id is replaced by a new one.
  static Markers restored(std::vector<Marker> markers, int next_id);
  int next_id() const { return next_id_; }

  bool operator==(const Markers&) const = default;

 private:
  void sort();

  std::vector<Marker> markers_;
  int next_id_ = 1;
};

/// The name, or the number if it has no name.
std::string marker_title(const Marker& marker);

/// [{"id":1,"name":"clap","time_s":0.7}], the format of a take's markers in a session file.
std::string markers_json(const Markers& markers);
/// Invalid entries are left out: the text comes from a file of unknown origin.
Markers parse_markers(std::string_view json);

}  // namespace abrazo
