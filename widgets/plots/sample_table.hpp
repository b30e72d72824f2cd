#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "widgets/common/thinning.hpp"
#include "widgets/plots/plot_series.hpp"

namespace abrazo::widgets {

/// The values of all series over the kept frames. Plain data, no toolkit. Also keeps the extremes of each run
/// of rows, so that drawing hours costs what drawing a minute does.
class SampleTable {
 public:
  struct Row {
    double time_s = 0;
    std::uint64_t index = 0;  ///< of the frame
    SeriesValues values{};
  };
  struct Point {
    double time_s = 0;
    double value = 0;  ///< NaN: the line is broken here
    bool operator==(const Point&) const = default;
  };

  /// Rows come in ascending time.
  void append(Row row);
  /// Writes some series of a row again; the row of a frame that is not kept is passed over.
  void rewrite(std::uint64_t frame, const std::vector<Series>& which, const SeriesValues& values);
  /// After rows were rewritten: the extremes of all that has changed.
  void refresh_extremes(std::uint64_t first_frame, std::uint64_t last_frame);
  void drop_before(double time_s);
  /// So that hours do not fill the memory: the newest rows stay as they are, those before become at most
  /// `most_older` and stand evenly. Of each four two remain, with the least and the largest value of every
  /// series in the order they came, so that no spike is lost. To be called now and then.
  void thin_older(std::size_t newest, std::size_t most_older);
  /// Rows at the beginning that were thinned: their values are extremes around their frame, not its own.
  std::size_t thinned() const { return thinning_.level > 0 ? thinning_.older : 0; }
  void clear();
  const std::deque<Row>& rows() const { return rows_; }

  /// The row shown at a time: the last one not after it; null when there is none.
  const Row* at(double time_s) const;

  /// What a line of `columns` pixels over [from, to] needs: each value where they are few, else the least and
  /// the largest of each column in the order they came, so that no spike is lost. One row beyond each end, so
  /// that the line reaches the border. Columns stand on a raster of time that does not move with the window.
  std::vector<Point> line(Series series, double from_s, double to_s, int columns) const;

  static constexpr std::size_t block_rows = 64;

 private:
  struct Extremes {
    std::uint8_t least = no_row, largest = no_row;  ///< row within the block
  };
  static constexpr std::uint8_t no_row = 255;  ///< no finite value
  using Block = std::array<Extremes, series_count>;

  struct Reach {
    std::size_t first, last;  ///< rows, last not included
  };
  Reach reach(double from_s, double to_s) const;
  Block extremes_of(std::size_t first_row) const;
  std::size_t halve(std::size_t first, std::size_t count);
  void gather_blocks();
  std::optional<std::size_t> row_of(std::uint64_t frame) const;
  double value(std::size_t row, Series series) const;

  std::deque<Row> rows_;
  std::size_t dropped_ = 0;   ///< rows so far; row r of the session is rows_[r - dropped_]
  std::deque<Block> blocks_;  ///< block b: rows [64 b, 64 b + 64) of the session
  std::size_t dropped_blocks_ = 0;
  Thinning thinning_;
};

/// Every row in [from, to] with every series: the header carries the units, numbers read back to the same
/// bits, a value that a frame has not is left empty.
std::string plot_csv(const SampleTable& table, double from_s, double to_s);

}  // namespace abrazo::widgets
