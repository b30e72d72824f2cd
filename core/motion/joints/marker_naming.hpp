#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/joints/marker_guess.hpp"

namespace abrazo {

/// Which marker of a file is where on a body: what a person said, and beside it what a guess proposes.
/// A place belongs to one marker at most.
class MarkerNaming {
 public:
  enum class By {
    Nothing,
    Proposal,  ///< guessed and not sure; not part of the model until it is accepted
    Guess,     ///< guessed and sure
    Person     ///< said, accepted or read from a file; a guess leaves it alone
  };
  struct Row {
    MarkerPlace place = MarkerPlace::Count;
    std::size_t side = 0;   ///< as in MarkerModel
    double confidence = 0;  ///< of a guess, 0 to 1
    By by = By::Nothing;
  };

  explicit MarkerNaming(std::vector<std::string> points);
  /// In place of an earlier guess. What a person said stays, and the places that were said are not guessed.
  void propose(const MarkerGuess& guess);
  /// What is guessed of this point holds from now on. @return whether there was a guess
  bool accept(int point);
  /// Puts a point to a place by its name ("left knee"); nothing: takes it away. A guess gives way.
  /// @return an Error for an unknown name, or a place that a person gave to another point
  Status say(int point, std::string_view place);
  /// In place of all that was said. @return how many points it names; an Error, changing nothing, for none
  Result<std::size_t> read(const MarkerModel& model);

  const std::vector<Row>& rows() const { return rows_; }  ///< one per point
  /// "left knee"; empty without a place.
  std::string place_of(int point) const;
  /// "sure", "likely" or "doubtful" of a guess, "said", or nothing.
  std::string belief_in(int point) const;
  /// "12 of 41 markers guessed, 9 sure; 3 said".
  std::string counted() const;
  /// Of what is sure or said.
  MarkerModel model(const std::string& name) const;

 private:
  std::vector<std::string> points_;
  std::vector<Row> rows_;
};

/// Whether the points are markers (no bones between them) enough for a guess, and no name of them is like
/// that of a joint or of a known marker.
bool names_say_nothing(const NamedMotion& motion);

}  // namespace abrazo
