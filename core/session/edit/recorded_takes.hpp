#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// A stretch of a session that has a name.
struct RecordedTake {
  std::int64_t id = 0;  ///< of its session, never used twice in it
  std::string name;
  double from_s = 0, to_s = 0;  ///< session clock
  std::uint64_t frames = 0;
  std::vector<std::string> performers;

  double length_s() const { return to_s - from_s; }
  bool operator==(const RecordedTake&) const = default;
};

/// The takes of a session in the order they were recorded. A value: what an undo step keeps is a copy.
class RecordedTakes {
 public:
  RecordedTakes() = default;
  explicit RecordedTakes(std::vector<RecordedTake> takes) : takes_(std::move(takes)) {}

  const std::vector<RecordedTake>& all() const { return takes_; }
  bool empty() const { return takes_.empty(); }
  const RecordedTake* find(std::int64_t id) const;
  std::vector<std::string> names() const;

  /// In its place by id; replaces one of the same id.
  void put(const RecordedTake& take);
  /// @return why the take cannot be called so; empty when it can
  std::string why_not(std::int64_t id, std::string_view name) const;
  /// Without effect on an id that is not there.
  void rename(std::int64_t id, std::string_view name);
  void remove(std::int64_t id);

  bool operator==(const RecordedTakes&) const = default;

 private:
  std::vector<RecordedTake> takes_;
};

}  // namespace abrazo
