#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

/// Which body a character gets, as a person says it: `library`, `user`, `scale:0.85` or a motion file.
struct BodyChoice {
  enum class Kind {
    Library,  ///< the recorded performer's own
    User,     ///< the person's at the input
    Scaled,   ///< the recorded performer's, all lengths times `scale`
    OfFile    ///< with the proportions of the performer in `file`
  };
  static constexpr double least_scale = 0.3, greatest_scale = 3;

  Kind kind = Kind::Library;
  double scale = 1;       ///< with Scaled
  std::string file = {};  ///< with OfFile
  /// With OfFile: the body in `file`, once it was read. Kept, because the file may change or be gone later.
  std::optional<Body> measured = std::nullopt;

  bool operator==(const BodyChoice& other) const;
};

/// The body of a choice.
/// @param recorded  of the recorded performer in this role
/// @param user      of the person at the input; before it is known, and with a file that was not read, the
/// recorded body is taken
Body body_of_choice(const BodyChoice& choice, const Body& recorded, const std::optional<Body>& user);

/// Whether all lengths are equal, to the bit.
bool are_same_lengths(const Body& a, const Body& b);

/// Reads a choice; text that is not a keyword is the path of a file ("./user" for a file of that name). The
/// Error lists what can be said, or gives the range of the scale.
Result<BodyChoice> parse_body_choice(std::string_view text);

/// The text that reads back to the same choice.
std::string body_choice_text(const BodyChoice& choice);

/// All lengths and the toe rest height times `scale`.
Body scaled_body(const Body& body, double scale);

}  // namespace abrazo
