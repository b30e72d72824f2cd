#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// A file that a project refers to without containing it.
struct DataReference {
  enum class Use { Library, Manifest, Motion, Skeleton, Video, Intrinsics, JointMap, Take };
  Use use = Use::Library;
  std::string relative_path;  ///< to the session file's folder, with '/'; empty if there is none
  std::string absolute_path;  ///< at the last save
  std::uint64_t bytes = 0;
  std::string
      hash;  ///< 16 hexadecimal digits of the content (whole up to 64 MiB; else size, begin, middle, end)

  bool operator==(const DataReference&) const = default;
};

/// A reference with the path only; `reference_to` reads the file and completes it.
DataReference unread_reference(DataReference::Use use, const std::string& file);

/// A reference to the present content of a file.
Result<DataReference> reference_to(const std::string& file, DataReference::Use use,
                                   const std::string& session_path);

/// Where the file is: at the path relative to the session, else at the absolute path. A file with other
/// content counts as found and is flagged.
struct FoundData {
  enum class State { Found, Changed, Missing };
  State state = State::Missing;
  std::string path;                 ///< empty when missing
  std::vector<std::string> looked;  ///< paths searched, in order
};
FoundData find_data(const DataReference& reference, const std::string& session_path);

/// After the user located one missing file: the others at the same relative position to it.
/// @return existing paths, by index into `data`
std::map<std::size_t, std::string> relocated(const std::vector<DataReference>& data, std::size_t pointed_out,
                                             const std::string& path);

/// "library", "manifest", ...: used in the session file and in messages.
std::string_view text_of(DataReference::Use use);
Result<DataReference::Use> parse_data_use(std::string_view text);

}  // namespace abrazo
