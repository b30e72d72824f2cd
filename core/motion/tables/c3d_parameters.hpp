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

/// How the machine that wrote a C3D file stores numbers (c3d.org, "The parameter section").
enum class C3dProcessor { Intel = 84, Dec = 85, Mips = 86 };

/// Numbers out of the bytes of a C3D file. Reading behind the end is a programming mistake.
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
  std::vector<std::string> texts;  ///< without the blanks behind
  /// Integers are 16 bit; counts are meant without sign.
  double count(std::size_t index) const;
};

/// Parameters by "GROUP:NAME", in capitals.
using C3dParameters = std::map<std::string, C3dParameter>;

/// @param section  byte at which the parameters begin
/// @param end      byte behind the last they may take: the data begins there
/// @param warnings what was odd is appended
Result<C3dParameters> parse_c3d_parameters(const C3dBytes& bytes, std::size_t section, std::size_t end,
                                           std::string_view where, std::vector<ImportWarning>& warnings);

}  // namespace abrazo
