#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// A named stretch of a session.
struct RecordedTake {
  std::int64_t id = 0;  ///< unique in its session, never reused
  std::string name;
  double from_s = 0, to_s = 0;  ///< session clock
  std::uint64_t frames = 0;
  std::vector<std::string> performers;

  double length_s() const { return to_s - from_s; }
  bool operator==(const RecordedTake&) const = default;
};

/// The takes of a session in the order of recording. A value type: undo steps keep copies.
class RecordedTakes {
 public:
  RecordedTakes() = default;
  explicit RecordedTakes(std::vector<RecordedTake> takes) : takes_(std::move(takes)) {}

  const std::vector<RecordedTake>& all() const { return takes_; }
  bool empty() const { return takes_.empty(); }
  const RecordedTake* find(std::int64_t id) const;
  std::vector<std::string> names() const;

  /// Inserts in the order of ids; replaces a take of the same id.
  void put(const RecordedTake& take);
  /// @return why the take cannot have this name; empty if it can
  std::string why_not(std::int64_t id, std::string_view name) const;
  /// No effect on an unknown id.
  void rename(std::int64_t id, std::string_view name);
  void remove(std::int64_t id);

  bool operator==(const RecordedTakes&) const = default;

 private:
  std::vector<RecordedTake> takes_;
};

}  // namespace abrazo
