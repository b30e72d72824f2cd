#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace abrazo::test {

/// Writes small C3D files byte by byte, as c3d.org describes them, in the numbers of any processor.
class C3dBytesWriter {
 public:
  enum Processor { Intel = 84, Dec = 85, Mips = 86 };
  struct Sample {
    double x, y, z, residual = 0;
  };

  Processor processor = Intel;
  bool floats = true;
  double scale = 0.1;  ///< of integers; its negative is written for floats
  double rate = 100;
  std::vector<std::string> labels;
  std::vector<std::vector<Sample>> frames;
  int analog_values = 0;  ///< per frame
  int first_frame = 1;
  int announced_frames = -1;  ///< -1: as many as there are
  std::string units = "mm", x_screen, y_screen;
  bool scale_in_parameters = true;
  /// Segments: per sample 17 numbers each, a transform by columns and its reliability.
  std::vector<std::string> segment_labels;
  std::vector<std::vector<std::array<double, 17>>> segment_samples;
  int segment_ratio = 1;        ///< samples per frame
  int announced_samples = -1;   ///< -1: as many as there are
  int segment_data_block = -1;  ///< -1: where they are

  /// Further parameters of groups: texts of one length.
  void add_texts(const std::string& group, const std::string& name, const std::vector<std::string>& texts) {
    parameters_.push_back({group, name, text_value(texts)});
  }
  void add_integers(const std::string& group, const std::string& name, const std::vector<int>& values) {
    std::string value{2, 1, static_cast<char>(values.size())};
    for (const int number : values) value += word(number);
    parameters_.push_back({group, name, value});
  }
  void add_reals(const std::string& group, const std::string& name, const std::vector<double>& values) {
    std::string value{4, 1, static_cast<char>(values.size())};
    for (const double number : values) value += real(number);
    parameters_.push_back({group, name, value});
  }

  std::string bytes() const;
  /// Where the parameters of the file begin.
  static constexpr std::size_t section = 512;

  std::string word(int value) const {
    const auto bits = static_cast<std::uint16_t>(value);
    const char low = static_cast<char>(bits & 0xFF), high = static_cast<char>(bits >> 8);
    return processor == Mips ? std::string{high, low} : std::string{low, high};
  }
  std::string real(double value) const {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    const auto byte = [](std::uint32_t of, int shift) { return static_cast<char>(of >> shift & 0xFF); };
    if (processor == Mips) return {byte(bits, 24), byte(bits, 16), byte(bits, 8), byte(bits, 0)};
    if (processor == Intel) return {byte(bits, 0), byte(bits, 8), byte(bits, 16), byte(bits, 24)};
    // VAX F: four times as much in the exponent, the words swapped.
    const std::uint32_t vax = value == 0 ? 0 : bits + (2U << 23);
    return {byte(vax, 16), byte(vax, 24), byte(vax, 0), byte(vax, 8)};
  }

 private:
  struct Parameter {
    std::string group, name, value;
  };
  static std::string text_value(const std::vector<std::string>& texts) {
    std::size_t length = 1;
    for (const std::string& text : texts) length = std::max(length, text.size());
    std::string value{-1, 2, static_cast<char>(length), static_cast<char>(texts.size())};
    for (std::string text : texts) {
      text.resize(length, ' ');
      value += text;
    }
    return value;
  }
  std::string parameter_section(int segment_block) const;

  std::vector<Parameter> parameters_;
};

inline std::string C3dBytesWriter::parameter_section(int segment_block) const {
  std::vector<Parameter> all;
  for (std::size_t first = 0; first < labels.size(); first += 255) {
    const auto end = std::min(labels.size(), first + 255);
    const std::string number = first == 0 ? "" : std::to_string(first / 255 + 1);
    all.push_back({"POINT", "LABELS" + number,
                   text_value({labels.begin() + static_cast<std::ptrdiff_t>(first),
                               labels.begin() + static_cast<std::ptrdiff_t>(end)})});
  }
  if (!units.empty()) all.push_back({"POINT", "UNITS", text_value({units})});
  if (!x_screen.empty()) all.push_back({"POINT", "X_SCREEN", text_value({x_screen})});
  if (!y_screen.empty()) all.push_back({"POINT", "Y_SCREEN", text_value({y_screen})});
  if (scale_in_parameters)
    all.push_back({"POINT", "SCALE", std::string{4, 0} + real(floats ? -scale : scale)});
  all.insert(all.end(), parameters_.begin(), parameters_.end());
  if (!segment_labels.empty()) {
    const auto add_word = [&](const char* name, int value) {
      all.push_back({"ROTATION", name, std::string{2, 0} + word(value)});
    };
    add_word("USED", static_cast<int>(segment_labels.size()));
    add_word("DATA_START", segment_data_block < 0 ? segment_block : segment_data_block);
    add_word("RATIO", segment_ratio);
    all.push_back({"ROTATION", "RATE", std::string{4, 0} + real(rate * segment_ratio)});
    add_word("FRAMES", announced_samples < 0 ? static_cast<int>(segment_samples.size()) : announced_samples);
    all.push_back({"ROTATION", "LABELS", text_value(segment_labels)});
  }
  std::vector<std::string> groups;
  std::string text;
  const auto add = [&](int id, const std::string& name, const std::string& value) {
    text += static_cast<char>(name.size());
    text += static_cast<char>(id);
    text += name + word(static_cast<int>(value.size()) + 3) + value;
    text += '\0';  // no description
  };
  const auto id_of = [&](const std::string& group) {
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (groups[g] == group) return static_cast<int>(g) + 1;
    groups.push_back(group);
    add(-static_cast<int>(groups.size()), group, "");
    return static_cast<int>(groups.size());
  };
  for (const Parameter& parameter : all) {
    const int id = id_of(parameter.group);
    add(id, parameter.name, parameter.value);
  }
  text += std::string(2, '\0');
  const std::size_t blocks = (text.size() + 4 + 511) / 512;
  std::string section_text{1, 0x50, static_cast<char>(blocks), static_cast<char>(processor)};
  section_text += text;
  section_text.resize(blocks * 512, '\0');
  return section_text;
}

inline std::string C3dBytesWriter::bytes() const {
  std::string values;
  for (const auto& frame : frames) {
    for (const Sample& sample : frame) {
      for (const double value : {sample.x, sample.y, sample.z})
        values += floats ? real(value) : word(static_cast<int>(std::lround(value / scale)));
      values += floats ? real(sample.residual) : word(static_cast<int>(sample.residual));
    }
    for (int a = 0; a < analog_values; ++a) values += floats ? real(7.5) : word(77);
  }
  if (!segment_labels.empty()) values.resize((values.size() + 511) / 512 * 512, '\0');
  const auto first_block = static_cast<int>(2 + parameter_section(0).size() / 512);
  const std::string parameters = parameter_section(first_block + static_cast<int>(values.size() / 512));
  for (const auto& sample : segment_samples)
    for (const auto& segment : sample)
      for (const double value : segment) values += real(value);
  std::string header{2, 0x50};
  const int count = announced_frames < 0 ? static_cast<int>(frames.size()) : announced_frames;
  header += word(static_cast<int>(labels.size())) + word(analog_values) + word(first_frame) +
            word(std::min(65535, first_frame + count - 1)) + word(10) + real(floats ? -scale : scale) +
            word(first_block) + word(analog_values > 0 ? 1 : 0) + real(rate);
  header.resize(512, '\0');
  return header + parameters + values;
}

}  // namespace abrazo::test
