#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo {

/// Number formats of a C3D file, by the processor that wrote it (c3d.org, "The parameter section").
enum class C3dProcessor { Intel = 84, Dec = 85, Mips = 86 };

/// Reads numbers from the bytes of a C3D file. Reading past the end is a programming error.
class C3dBytes {
 public:
  C3dBytes(std::string_view bytes, C3dProcessor processor) : bytes_(bytes), processor_(processor) {}
  std::size_t size() const { return bytes_.size(); }
  std::uint8_t byte(std::size_t at) const { return static_cast<std::uint8_t>(bytes_[at]); }
  std::uint16_t word(std::size_t at) const;
  std::int16_t integer(std::size_t at) const { return static_cast<std::int16_t>(word(at)); }
  /// DEC's floats have their words swapped and an exponent that is 2 more.
  float real(std::size_t at) const;
  std::string_view text(std::size_t at, std::size_t length) const { return bytes_.substr(at, length); }

 private:
  std::string_view bytes_;
  C3dProcessor processor_;
};

/// One parameter: numbers, or texts of one length.
struct C3dParameter {
  int type = 0;  ///< -1 text, 1 bytes, 2 integers, 4 reals
  std::vector<std::size_t> dimensions;
  std::vector<double> numbers;     ///< integers with their sign
  std::vector<std::string> texts;  ///< without trailing blanks
  /// Integers are 16 bit; counts are unsigned.
  double count(std::size_t index) const;
};

/// Parameters by "GROUP:NAME", in capitals.
using C3dParameters = std::map<std::string, C3dParameter>;

/// @param section offset of the parameters
/// @param end offset of the data, which limits the parameters
/// @param warnings defects are appended
Result<C3dParameters> parse_c3d_parameters(const C3dBytes& bytes, std::size_t section, std::size_t end,
                                           std::string_view where, std::vector<ImportWarning>& warnings);

}  // namespace abrazo
