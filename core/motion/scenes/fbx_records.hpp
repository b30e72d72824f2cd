#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace abrazo {

/// The hierarchy of the models of an FBX file.
struct FbxLinks {
  std::vector<std::uint64_t> models;  ///< numbers, as often as they occur
  std::vector<std::pair<std::uint64_t, std::uint64_t>>
      connections;  ///< child and parent, of objects of any kind
};

/// Read without recursion up to the first place where the file is damaged, from FBX text or binary.
FbxLinks fbx_links(std::string_view bytes);

}  // namespace abrazo
