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

/// The values of all series over the kept frames. Plain data, independent of Qt. Keeps the extremes of blocks
/// of rows, so that the cost of drawing does not grow with the time span.
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
  /// @param after_gap  lines are broken before the row
  void append(Row row, bool after_gap = false);
  /// Overwrites some series of a row; ignores frames that are not kept.
  void rewrite(std::uint64_t frame, const std::vector<Series>& which, const SeriesValues& values);
  /// Updates extremes after rewritten rows.
  void refresh_extremes(std::uint64_t first_frame, std::uint64_t last_frame);
  void drop_before(double time_s);
  /// Bounds the memory: keeps the newest rows and reduces older ones evenly to at most `most_older`. Two of
  /// each four rows remain, with minimum and maximum of every series in order, so that no spike is lost. Call
  /// at intervals.
  void thin_older(std::size_t newest, std::size_t most_older);
  /// Number of thinned rows at the beginning: their values are extremes near their frame.
  std::size_t thinned() const { return thinning_.level > 0 ? thinning_.older : 0; }
  void clear();
  const std::deque<Row>& rows() const { return rows_; }

  /// The row shown at a time: the last one not after it; null if there is none.
  const Row* at(double time_s) const;

  /// Points of a line of `columns` pixels over [from, to]: every value if there are few, else minimum and
  /// maximum of each column in order, so that no spike is lost. Includes one row beyond each end, so that the
  /// line reaches the border. Columns are on a fixed time raster that does not move with the window.
  std::vector<Point> line(Series series, double from_s, double to_s, int columns) const;

  static constexpr std::size_t block_rows = 64;

 private:
  struct Extremes {
    std::uint8_t least = no_row, largest = no_row;  ///< row within the block
  };
  static constexpr std::uint8_t no_row = 255;  ///< no finite value
  using Block = std::array<Extremes, series_count>;

  /// Without a row inside.
  struct Gap {
    double from_s = 0, to_s = 0;
  };
  void break_at_gaps(std::vector<Point>& line, double least_s) const;
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
  std::deque<Gap> gaps_;
  std::size_t dropped_ = 0;   ///< number of dropped rows; row r of the session is rows_[r - dropped_]
  std::deque<Block> blocks_;  ///< block b: rows [64 b, 64 b + 64) of the session
  std::size_t dropped_blocks_ = 0;
  Thinning thinning_;
};

/// Every row in [from, to] with every series: units are in the header, numbers read back to the same bits,
/// missing values are empty.
std::string plot_csv(const SampleTable& table, double from_s, double to_s);

}  // namespace abrazo::widgets
