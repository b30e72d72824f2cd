#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// A remembered instant of a session.
struct Marker {
  int id = 0;  ///< of its list, never used twice in it
  double time_s = 0;
  std::string name;  ///< may be empty

  bool operator==(const Marker&) const = default;
};

/// The markers of a session, earliest first. A value: what an undo step keeps is a copy.
class Markers {
 public:
  const std::vector<Marker>& all() const { return markers_; }
  bool empty() const { return markers_.empty(); }
  const Marker* find(int id) const;

  /// @return its id
  int add(double time_s, std::string_view name = {});
  /// Without effect on an id that is not there.
  void move(int id, double time_s);
  void rename(int id, std::string_view name);
  void remove(int id);

  /// The last before, or the first after a time, by more than `apart_s`; null when there is none.
  const Marker* before(double time_s, double apart_s = 1e-6) const;
  const Marker* after(double time_s, double apart_s = 1e-6) const;
  /// The one nearest to a time within `reach_s`; null when there is none.
  const Marker* near(double time_s, double reach_s) const;

  /// As they were kept somewhere, with their ids; one that is there twice gets a new one.
  static Markers restored(std::vector<Marker> markers, int next_id);
  int next_id() const { return next_id_; }

  bool operator==(const Markers&) const = default;

 private:
  void sort();

  std::vector<Marker> markers_;
  int next_id_ = 1;
};

/// The name, or its number where it has none.
std::string marker_title(const Marker& marker);

/// [{"id":1,"name":"clap","time_s":0.7}], as the markers of a take stand in a session file.
std::string markers_json(const Markers& markers);
/// What is no marker is left out: the text is from a file, perhaps a stranger's.
Markers parse_markers(std::string_view json);

}  // namespace abrazo
