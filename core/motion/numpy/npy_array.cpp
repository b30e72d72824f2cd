#include "core/motion/numpy/npy_array.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <optional>

#include "core/base/little_endian.hpp"
#include "core/base/text.hpp"
#include "core/base/utf8.hpp"

namespace abrazo {

namespace {

constexpr std::string_view npy_mark = "\x93NUMPY";
constexpr std::uint64_t too_many = std::numeric_limits<std::uint64_t>::max();

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  return __builtin_mul_overflow(a, b, &result) ? too_many : result;
}

/// Reads the literal of a Python dictionary with the keys that NumPy writes, and nothing else of Python.
class HeaderWords {
 public:
  explicit HeaderWords(std::string_view text) : left_(text) {}

  bool take(char sign) {
    skip_blanks();
    if (left_.empty() || left_.front() != sign) return false;
    left_.remove_prefix(1);
    return true;
  }
  bool take_word(std::string_view word) {
    skip_blanks();
    if (!left_.starts_with(word)) return false;
    left_.remove_prefix(word.size());
    return true;
  }
  std::optional<std::string> text() {
    skip_blanks();
    if (left_.empty() || (left_.front() != '\'' && left_.front() != '"')) return std::nullopt;
    const auto end = left_.find(left_.front(), 1);
    if (end == std::string_view::npos) return std::nullopt;
    std::string value(left_.substr(1, end - 1));
    left_.remove_prefix(end + 1);
    return value;
  }
  std::optional<std::uint64_t> number() {
    skip_blanks();
    std::uint64_t value = 0;
    const auto read = std::from_chars(left_.data(), left_.data() + left_.size(), value);
    if (read.ec != std::errc{}) return std::nullopt;
    left_.remove_prefix(static_cast<std::size_t>(read.ptr - left_.data()));
    (void)take('L');  // Python 2 wrote long numbers so
    return value;
  }
  /// (3, 4), (3,), ()
  std::optional<std::vector<std::uint64_t>> numbers() {
    std::vector<std::uint64_t> values;
    if (!take('(')) return std::nullopt;
    while (!take(')')) {
      const auto value = number();
      if (!value || values.size() == 32) return std::nullopt;  // NumPy has no more dimensions
      values.push_back(*value);
      if (!take(',') && left_.substr(0, 1) != ")") return std::nullopt;
    }
    return values;
  }

 private:
  void skip_blanks() {
    while (!left_.empty() && (left_.front() == ' ' || left_.front() == '\n')) left_.remove_prefix(1);
  }
  std::string_view left_;
};

struct HeaderFields {
  std::optional<std::string> type;
  std::optional<bool> column_order;
  std::optional<std::vector<std::uint64_t>> shape;
  bool is_structured = false;
};

std::optional<HeaderFields> header_fields(std::string_view text) {
  HeaderWords words(text);
  HeaderFields fields;
  if (!words.take('{')) return std::nullopt;
  while (!words.take('}')) {
    const auto key = words.text();
    if (!key || !words.take(':')) return std::nullopt;
    if (*key == "descr") {
      if (words.take('[')) {
        fields.is_structured = true;
        return fields;
      }
      fields.type = words.text();
    } else if (*key == "fortran_order") {
      if (words.take_word("True"))
        fields.column_order = true;
      else if (words.take_word("False"))
        fields.column_order = false;
    } else if (*key == "shape") {
      fields.shape = words.numbers();
    } else {
      return std::nullopt;
    }
    if (!words.take(',')) {
      if (!words.take('}')) return std::nullopt;
      break;
    }
  }
  if (!fields.type || !fields.column_order || !fields.shape) return std::nullopt;
  return fields;
}

/// "<f8", "|S5", "<U12" into the layout.
Status read_type(const std::string& type, std::string_view where, NpyLayout& layout) {
  const std::string file(where);
  std::string_view word = type;
  if (!word.empty() && (word[0] == '<' || word[0] == '>' || word[0] == '=' || word[0] == '|')) {
    layout.big_endian = word[0] == '>';
    word.remove_prefix(1);
  }
  if (word.starts_with('O'))
    return Error{
        "holds Python objects (a pickle), which may run anything when they are read, and is not read; save "
        "arrays of plain numbers and texts (float32, float64, str)",
        file};
  const auto size = word.empty() ? std::nullopt : parse_integer(word.substr(1));
  const auto is_one_of = [&](std::initializer_list<long long> sizes) {
    return size && std::find(sizes.begin(), sizes.end(), *size) != sizes.end();
  };
  const char kind = word.empty() ? ' ' : word[0];
  constexpr long long longest_text = 4096;
  using enum NpyLayout::Kind;
  if (kind == 'f' && is_one_of({4, 8}))
    layout.kind = Real;
  else if (kind == 'i' && is_one_of({1, 2, 4, 8}))
    layout.kind = Integer;
  else if ((kind == 'u' && is_one_of({1, 2, 4, 8})) || (kind == 'b' && is_one_of({1})))
    layout.kind = Unsigned;
  else if ((kind == 'U' || kind == 'S') && size && *size >= 0 && *size <= longest_text)
    layout.kind = kind == 'U' ? Text : Bytes;
  else
    return Error{"has elements of the type " + in_quotes(type) +
                     "; expected float32 or float64 (whole numbers and texts beside them)",
                 file};
  layout.item_bytes = static_cast<std::size_t>(*size) * (layout.kind == Text ? 4U : 1U);
  return Done{};
}

void append_utf8(std::string& to, std::uint32_t point) {
  if (point < 0x80) {
    to += static_cast<char>(point);
  } else if (point < 0x800) {
    to += static_cast<char>(0xC0U | point >> 6U);
    to += static_cast<char>(0x80U | (point & 0x3FU));
  } else if (point < 0x10000 && (point < 0xD800 || point > 0xDFFF)) {
    to += static_cast<char>(0xE0U | point >> 12U);
    to += static_cast<char>(0x80U | (point >> 6U & 0x3FU));
    to += static_cast<char>(0x80U | (point & 0x3FU));
  } else {
    to += '?';
  }
}

std::string npy_file(const std::string& type, const std::vector<std::uint64_t>& shape,
                     std::string_view data) {
  std::string dimensions;
  for (const std::uint64_t length : shape) dimensions += std::to_string(length) + ", ";
  if (shape.size() > 1) dimensions.resize(dimensions.size() - 2);
  if (shape.size() == 1) dimensions.resize(dimensions.size() - 1);
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + dimensions + "), }";
  // The elements begin at a multiple of 64 bytes.
  const std::size_t before = npy_mark.size() + 4;
  header.append(63 - (before + header.size()) % 64, ' ');
  header += '\n';
  std::string file(npy_mark);
  file += '\x01';
  file += '\0';
  file += static_cast<char>(header.size() & 0xffU);
  file += static_cast<char>(header.size() >> 8U);
  return file.append(header).append(data);
}

}  // namespace

std::uint64_t NpyLayout::count() const {
  std::uint64_t elements = 1;
  for (const std::uint64_t length : shape) elements = product(elements, length);
  return std::find(shape.begin(), shape.end(), 0U) != shape.end() ? 0 : elements;
}

std::uint64_t NpyLayout::bytes() const {
  const std::uint64_t data = product(count(), item_bytes);
  return data > too_many - header_bytes ? too_many : data + header_bytes;
}

std::string NpyLayout::shape_text() const {
  std::string text;
  for (const std::uint64_t length : shape) text += (text.empty() ? "" : ", ") + std::to_string(length);
  return "(" + text + (shape.size() == 1 ? ",)" : ")");
}

Result<NpyLayout> parse_npy_header(std::string_view head, std::string_view where) {
  const Error cut{"ends inside its header; it is cut off, copy or write it again", std::string(where)};
  if (!head.starts_with(npy_mark))
    return Error{"is no .npy: expected it to begin with \\x93NUMPY", std::string(where)};
  if (head.size() < npy_mark.size() + 4) return cut;
  const int version = static_cast<unsigned char>(head[npy_mark.size()]);
  if (version < 1 || version > 3)
    return Error{"is of version " + std::to_string(version) + " of the .npy format; 1 to 3 are read",
                 std::string(where)};
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  const std::size_t begin = npy_mark.size() + 2 + length_bytes;
  if (head.size() < begin) return cut;
  const std::size_t length = little_endian(head, npy_mark.size() + 2, length_bytes);
  if (length > npy_header_most - begin)
    return Error{
        "announces a header of " + std::to_string(length) +
            " bytes; that of an array of numbers is shorter. It is damaged, or holds fields with names",
        std::string(where)};
  if (head.size() - begin < length) return cut;
  const auto fields = header_fields(head.substr(begin, length));
  if (!fields)
    return Error{
        "has a damaged header; expected {'descr': '<f4', 'fortran_order': False, 'shape': (frames, "
        "joints, 3)}, found " +
            in_quotes(trimmed(head.substr(begin, length))),
        std::string(where)};
  if (fields->is_structured)
    return Error{"has elements with named fields; expected plain float32 or float64", std::string(where)};
  NpyLayout layout;
  layout.shape = *fields->shape;
  layout.column_order = *fields->column_order;
  layout.header_bytes = begin + length;
  if (const Status known = read_type(*fields->type, where, layout); !known) return known.error();
  return layout;
}

NpyArray::NpyArray(NpyLayout layout, std::string_view file)
    : layout_(std::move(layout)), data_(file.substr(layout_.header_bytes)) {}

std::uint64_t NpyArray::raw(std::size_t at, std::size_t bytes) const {
  if (!layout_.big_endian) return little_endian(data_, at, bytes);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8U | static_cast<unsigned char>(data_[at + i]);
  return value;
}

double NpyArray::number(std::uint64_t index) const {
  const std::uint64_t bits = raw(index * layout_.item_bytes, layout_.item_bytes);
  if (layout_.kind == NpyLayout::Kind::Real)
    return layout_.item_bytes == 4
               ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
               : std::bit_cast<double>(bits);
  if (layout_.kind == NpyLayout::Kind::Unsigned) return static_cast<double>(bits);
  const unsigned unused = 64U - 8U * static_cast<unsigned>(layout_.item_bytes);
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

double NpyArray::number(std::uint64_t a, std::uint64_t b, std::uint64_t c) const {
  const auto& shape = layout_.shape;
  return number(layout_.column_order ? a + shape[0] * (b + shape[1] * c) : (a * shape[1] + b) * shape[2] + c);
}

std::string NpyArray::text(std::uint64_t index) const {
  const std::size_t begin = index * layout_.item_bytes;
  std::string text;
  if (layout_.kind == NpyLayout::Kind::Bytes) {
    text = data_.substr(begin, layout_.item_bytes);
    if (first_broken_byte(text))
      for (char& c : text)
        if (static_cast<unsigned char>(c) > 0x7F) c = '?';
  } else {
    for (std::size_t at = begin; at < begin + layout_.item_bytes; at += 4)
      append_utf8(text, static_cast<std::uint32_t>(raw(at, 4)));
  }
  while (text.ends_with('\0')) text.pop_back();
  return text;
}

std::string npy_of_numbers(const std::vector<double>& values, const std::vector<std::uint64_t>& shape) {
  std::string data;
  data.reserve(values.size() * 8);
  for (const double value : values) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned shift = 0; shift < 64; shift += 8) data += static_cast<char>(bits >> shift & 0xffU);
  }
  return npy_file("<f8", shape, data);
}

std::string npy_of_texts(const std::vector<std::string>& texts, const std::vector<std::uint64_t>& shape) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string data;
  for (const std::string& text : texts)
    for (std::size_t i = 0; i < longest; ++i) {
      data += i < text.size() ? text[i] : '\0';
      data.append(3, '\0');
    }
  return npy_file("<U" + std::to_string(longest), shape, data);
}

}  // namespace abrazo
