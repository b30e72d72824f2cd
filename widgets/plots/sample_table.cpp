#include "widgets/plots/sample_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace abrazo::widgets {
namespace {

/// The extremes of one pixel column, as points in the order they came.
class Column {
 public:
  void begin(double raster) {
    raster_ = raster;
    least_.reset();
    largest_.reset();
  }
  bool is(double raster) const { return begun_ && raster_ == raster; }
  void add(SampleTable::Point point) {
    begun_ = true;
    last_s_ = point.time_s;
    if (!std::isfinite(point.value)) return;
    if (!least_ || point.value < least_->value) least_ = point;
    if (!largest_ || point.value > largest_->value) largest_ = point;
  }
  void put(std::vector<SampleTable::Point>& line) const {
    if (!begun_) return;
    if (!least_) return line.push_back({last_s_, std::numeric_limits<double>::quiet_NaN()});
    const bool rising = least_->time_s <= largest_->time_s;
    line.push_back(rising ? *least_ : *largest_);
    if (least_->time_s != largest_->time_s) line.push_back(rising ? *largest_ : *least_);
  }

 private:
  bool begun_ = false;
  double raster_ = 0, last_s_ = 0;
  std::optional<SampleTable::Point> least_, largest_;
};

void put_number(std::string& text, double value) {
  char digits[32];
  const auto end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
  text.append(std::begin(digits), end);
}

/// Units in ASCII: a table goes through programs that guess the encoding.
std::string plain_unit(std::string_view unit) {
  return unit == "m²" ? "m^2" : std::string(unit);
}

bool is_earlier(const SampleTable::Row& row, double time_s) {
  return row.time_s < time_s;
}

bool is_later(double time_s, const SampleTable::Row& row) {
  return time_s < row.time_s;
}

}  // namespace

void SampleTable::append(Row row, bool after_gap) {
  if (after_gap && !rows_.empty()) gaps_.push_back({rows_.back().time_s, row.time_s});
  rows_.push_back(row);
  if ((dropped_ + rows_.size()) % block_rows != 0) return;
  if (rows_.size() < block_rows) {  // its beginning was dropped meanwhile
    dropped_blocks_ += blocks_.size() + 1;
    return blocks_.clear();
  }
  blocks_.push_back(extremes_of(rows_.size() - block_rows));
}

std::optional<std::size_t> SampleTable::row_of(std::uint64_t frame) const {
  const auto found = std::ranges::lower_bound(rows_, frame, {}, &Row::index);
  if (found == rows_.end() || found->index != frame) return std::nullopt;
  return static_cast<std::size_t>(found - rows_.begin());
}

void SampleTable::rewrite(std::uint64_t frame, const std::vector<Series>& which, const SeriesValues& values) {
  const auto row = row_of(frame);
  if (!row) return;
  for (const Series series : which)
    rows_[*row].values[static_cast<std::size_t>(series)] = values[static_cast<std::size_t>(series)];
}

void SampleTable::refresh_extremes(std::uint64_t first_frame, std::uint64_t last_frame) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const std::size_t session_row = (dropped_blocks_ + b) * block_rows;
    if (session_row < dropped_) continue;
    const std::size_t first = session_row - dropped_;
    if (rows_[first].index > last_frame || rows_[first + block_rows - 1].index < first_frame) continue;
    blocks_[b] = extremes_of(first);
  }
}

SampleTable::Block SampleTable::extremes_of(std::size_t first) const {
  Block block;
  for (std::size_t s = 0; s < series_count; ++s) {
    Extremes& found = block[s];
    const auto at = [&](std::uint8_t row) { return rows_[first + row].values[s]; };
    for (std::uint8_t row = 0; row < block_rows; ++row) {
      if (!std::isfinite(at(row))) continue;
      if (found.least == no_row || at(row) < at(found.least)) found.least = row;
      if (found.largest == no_row || at(row) > at(found.largest)) found.largest = row;
    }
  }
  return block;
}

void SampleTable::drop_before(double time_s) {
  while (!rows_.empty() && rows_.front().time_s < time_s) {
    rows_.pop_front();
    ++dropped_;
    thinning_.older -= thinning_.older > 0;
  }
  while (!gaps_.empty() && gaps_.front().to_s < time_s) gaps_.pop_front();
  while (!blocks_.empty() && dropped_blocks_ * block_rows < dropped_) {
    blocks_.pop_front();
    ++dropped_blocks_;
  }
}

void SampleTable::thin_older(std::size_t newest, std::size_t most_older) {
  const bool has_thinned = thinning_.thin(
      newest, most_older, [this] { return rows_.size(); },
      [this](std::size_t first, std::size_t count) { return halve(first, count); });
  if (has_thinned) gather_blocks();
}

/// @return how many rows are left of `count`
std::size_t SampleTable::halve(std::size_t first, std::size_t count) {
  std::size_t to = first;
  for (std::size_t from = first; from < first + count;) {
    const std::size_t group = std::min<std::size_t>(4, first + count - from);
    if (group < 4) {  // a rest stays as it is
      for (std::size_t i = 0; i < group; ++i) rows_[to++] = rows_[from++];
      continue;
    }
    Row former = rows_[from], latter = rows_[from + 2];
    for (std::size_t s = 0; s < series_count; ++s) {
      std::size_t least = from, largest = from;
      for (std::size_t row = from; row < from + group; ++row) {
        const double here = rows_[row].values[s];
        if (!std::isfinite(here)) continue;
        if (!(here >= rows_[least].values[s])) least = row;
        if (!(here <= rows_[largest].values[s])) largest = row;
      }
      former.values[s] = rows_[std::min(least, largest)].values[s];
      latter.values[s] = rows_[std::max(least, largest)].values[s];
    }
    from += group;
    rows_[to++] = former;
    rows_[to++] = latter;
  }
  rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(to),
              rows_.begin() + static_cast<std::ptrdiff_t>(first + count));
  return to - first;
}

void SampleTable::gather_blocks() {
  dropped_ = dropped_blocks_ = 0;
  blocks_.clear();
  for (std::size_t first = 0; first + block_rows <= rows_.size(); first += block_rows)
    blocks_.push_back(extremes_of(first));
}

void SampleTable::clear() {
  *this = {};
}

const SampleTable::Row* SampleTable::at(double time_s) const {
  const auto after = std::upper_bound(rows_.begin(), rows_.end(), time_s, is_later);
  return after == rows_.begin() ? nullptr : &*std::prev(after);
}

SampleTable::Reach SampleTable::reach(double from_s, double to_s) const {
  auto first = std::lower_bound(rows_.begin(), rows_.end(), from_s, is_earlier);
  auto last = std::upper_bound(first, rows_.end(), to_s, is_later);
  if (first != rows_.begin()) --first;
  if (last != rows_.end()) ++last;
  return {static_cast<std::size_t>(first - rows_.begin()), static_cast<std::size_t>(last - rows_.begin())};
}

double SampleTable::value(std::size_t row, Series series) const {
  return rows_[row].values[static_cast<std::size_t>(series)];
}

std::vector<SampleTable::Point> SampleTable::line(Series series, double from_s, double to_s,
                                                  int columns) const {
  std::vector<Point> points;
  if (columns < 1 || !(to_s > from_s)) return points;
  const double column_s = (to_s - from_s) / columns;
  const auto [first, last] = reach(from_s, to_s);
  const auto point = [&](std::size_t row) { return Point{rows_[row].time_s, value(row, series)}; };
  if (last - first <= 2 * static_cast<std::size_t>(columns)) {
    for (std::size_t row = first; row < last; ++row) points.push_back(point(row));
    break_at_gaps(points, column_s);
    return points;
  }
  Column column;
  const auto enter = [&](double time_s) {
    const double raster = std::floor(time_s / column_s);
    if (column.is(raster)) return;
    column.put(points);
    column.begin(raster);
  };
  // Whole blocks where several go into a column; the rows themselves at the ends and where they do not.
  const bool coarse = last - first > 2 * block_rows * static_cast<std::size_t>(columns);
  for (std::size_t row = first; row < last;) {
    enter(rows_[row].time_s);
    const std::size_t session_row = row + dropped_, block = session_row / block_rows;
    if (coarse && session_row % block_rows == 0 && row + block_rows <= last && block >= dropped_blocks_ &&
        block - dropped_blocks_ < blocks_.size()) {
      const Extremes& found = blocks_[block - dropped_blocks_][static_cast<std::size_t>(series)];
      if (found.least == no_row)
        column.add(point(row));
      else
        for (const std::uint8_t at :
             {std::min(found.least, found.largest), std::max(found.least, found.largest)})
          column.add(point(row + at));
      row += block_rows;
    } else {
      column.add(point(row++));
    }
  }
  column.put(points);
  break_at_gaps(points, column_s);
  return points;
}

/// Shorter gaps than a column are not seen, and would tear its least value from its largest.
void SampleTable::break_at_gaps(std::vector<Point>& line, double least_s) const {
  if (line.empty()) return;
  auto gap = std::ranges::lower_bound(gaps_, line.front().time_s, {}, &Gap::from_s);
  std::vector<Point> broken;
  broken.reserve(line.size());
  for (const Point& point : line) {
    for (; gap != gaps_.end() && gap->to_s <= point.time_s; ++gap)
      if (gap->to_s - gap->from_s >= least_s && !broken.empty())
        broken.push_back({gap->from_s, std::numeric_limits<double>::quiet_NaN()});
    broken.push_back(point);
  }
  line = std::move(broken);
}

std::string plot_csv(const SampleTable& table, double from_s, double to_s) {
  std::string text = "time [s],frame";
  for (const SeriesInfo& info : all_series())
    text += "," + std::string(info.key) + " [" + plain_unit(info.unit) + "]";
  text += "\n";
  for (const SampleTable::Row& row : table.rows()) {
    if (row.time_s < from_s || row.time_s > to_s) continue;
    put_number(text, row.time_s);
    text += "," + std::to_string(row.index);
    for (const double value : row.values) {
      text += ",";
      if (std::isfinite(value)) put_number(text, value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace abrazo::widgets
