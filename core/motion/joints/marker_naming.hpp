#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/joints/marker_guess.hpp"

namespace abrazo {

/// The places of a file's markers on the body: those that a person named, and those that a guess proposes.
/// A place belongs to at most one marker.
class MarkerNaming {
 public:
  enum class By {
    Nothing,
    Proposal,  ///< guessed and not sure; not part of the model until it is accepted
    Guess,     ///< guessed and sure
    Person     ///< named, accepted or read from a file; a guess does not change it
  };
  struct Row {
    MarkerPlace place = MarkerPlace::Count;
    std::size_t side = 0;   ///< as in MarkerModel
    double confidence = 0;  ///< of a guess, 0 to 1
    By by = By::Nothing;
  };

  explicit MarkerNaming(std::vector<std::string> points);
  /// Replaces an earlier guess. Places named by a person stay, and are not proposed for other points.
  void propose(const MarkerGuess& guess);
  /// Accepts the guess for this point. @return whether there was one
  bool accept(int point);
  /// Names the place of a point ("left knee"); an empty name removes it. Replaces a guess.
  /// @return an Error for an unknown name, or a place that a person gave to another point
  Status say(int point, std::string_view place);
  /// Replaces all named places. @return the number of points that the model names; for none an Error, without
  /// a change
  Result<std::size_t> read(const MarkerModel& model);

  const std::vector<Row>& rows() const { return rows_; }  ///< one per point
  /// "left knee"; empty without a place.
  std::string place_of(int point) const;
  /// "sure", "likely" or "doubtful" for a guess, "said" for a named place, or nothing.
  std::string belief_in(int point) const;
  /// "12 of 41 markers guessed, 9 sure; 3 said".
  std::string counted() const;
  /// Of the sure, named and accepted places.
  MarkerModel model(const std::string& name) const;

 private:
  std::vector<std::string> points_;
  std::vector<Row> rows_;
};

/// Whether the points are markers (no bones between them), enough for a guess, and none has a name like
/// that of a joint or a known marker.
bool names_say_nothing(const NamedMotion& motion);

}  // namespace abrazo
