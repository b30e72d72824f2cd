#include "core/motion/scenes/gltf_values.hpp"

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "core/base/little_endian.hpp"
#include "core/motion/scenes/glb_file.hpp"
#include "core/motion/scenes/gltf_json.hpp"

namespace abrazo {

namespace {

using Json = nlohmann::json;

const Json* entry(const Json& json, const char* list, std::uint64_t index) {
  const auto found = json.find(list);
  if (found == json.end() || !found->is_array() || index >= found->size()) return nullptr;
  const Json& at = (*found)[static_cast<std::size_t>(index)];
  return at.is_object() ? &at : nullptr;
}

/// A count or index; absent: `otherwise`. None for anything else.
std::optional<std::uint64_t> whole(const Json& of, const char* key, std::optional<std::uint64_t> otherwise) {
  const auto found = of.find(key);
  if (found == of.end()) return otherwise;
  if (!found->is_number_unsigned()) return std::nullopt;
  return found->get<std::uint64_t>();
}

}  // namespace

std::optional<GltfValues> GltfValues::find(const GlbFile& glb, std::uint64_t index, std::string_view type) {
  const Json* accessor = entry(glb.json, "accessors", index);
  if (!accessor || accessor->contains("sparse") || accessor->value("type", Json()) != type)
    return std::nullopt;
  const auto number = whole(*accessor, "bufferView", std::nullopt);
  const Json* view = number ? entry(glb.json, "bufferViews", *number) : nullptr;
  const auto component = whole(*accessor, "componentType", std::nullopt);
  const auto count = whole(*accessor, "count", std::nullopt);
  const auto skipped = whole(*accessor, "byteOffset", 0);
  if (!view || !component || !count || !skipped || whole(*view, "buffer", std::nullopt) != 0)
    return std::nullopt;
  const auto from = whole(*view, "byteOffset", 0), length = whole(*view, "byteLength", std::nullopt);
  if (!from || !length || *from > glb.binary.size() || *length > glb.binary.size() - *from)
    return std::nullopt;
  GltfValues values;
  values.component_ = static_cast<std::int64_t>(*component);
  values.component_bytes_ = gltf::bytes_of_component(values.component_);
  const std::uint64_t value_bytes = values.component_bytes_ * gltf::components_of(type);
  const auto stride = whole(*view, "byteStride", value_bytes);
  const auto normalized = accessor->find("normalized");
  values.is_normalized_ =
      normalized != accessor->end() && normalized->is_boolean() && normalized->get<bool>();
  constexpr std::uint64_t longest_stride = 4096;
  if (value_bytes == 0 || !stride || *stride < value_bytes || *stride > longest_stride || *skipped > *length)
    return std::nullopt;
  const std::uint64_t room = *length - *skipped;
  if (*count > 0 && (room < value_bytes || *count - 1 > (room - value_bytes) / *stride)) return std::nullopt;
  values.stride_ = static_cast<std::size_t>(*stride);
  values.size_ = static_cast<std::size_t>(*count);
  values.bytes_ = std::string_view(glb.binary)
                      .substr(static_cast<std::size_t>(*from + *skipped), static_cast<std::size_t>(room));
  return values;
}

bool GltfValues::is_float() const {
  return component_ == gltf::single_float;
}

std::uint64_t GltfValues::integer(std::size_t value, std::size_t component) const {
  return little_endian(bytes_, value * stride_ + component * component_bytes_, component_bytes_);
}

double GltfValues::number(std::size_t value, std::size_t component) const {
  const std::uint64_t bits = integer(value, component);
  if (is_float()) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  double plain = static_cast<double>(bits), most = component_bytes_ == 1 ? 255 : 65535;
  if (component_ == gltf::signed_byte)
    plain = static_cast<double>(static_cast<std::int8_t>(bits)), most = 127;
  if (component_ == gltf::signed_short)
    plain = static_cast<double>(static_cast<std::int16_t>(bits)), most = 32767;
  return is_normalized_ && component_bytes_ < 4 ? std::max(plain / most, -1.0) : plain;
}

}  // namespace abrazo
