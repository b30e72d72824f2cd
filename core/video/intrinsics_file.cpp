#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/video/camera_model.hpp"

namespace abrazo {
namespace {

constexpr std::uintmax_t most_calibration_bytes =
    1 << 20;  // a calibration with all its corners is a tenth of it
constexpr int largest_side_px = 65536;
constexpr std::size_t most_coefficients = 14;
constexpr std::size_t deepest = 2000;  ///< levels; with all its views a calibration has some hundred brackets

const char* const advice =
    "expected a calibration as OpenCV writes it (YAML, XML or JSON with camera_matrix, "
    "distortion_coefficients, image_width and image_height)";

/// OpenCV's parser is recursive, so a file determines its use of stack. An upper bound of the depth, even
/// with brackets in strings and comments: each level begins with a bracket, a tag, or, in a block of YAML, a
/// larger indentation.
std::size_t most_levels(std::string_view text) {
  const auto is_opening = [](char c) { return c == '[' || c == '{' || c == '<'; };
  const auto openings = static_cast<std::size_t>(std::ranges::count_if(text, is_opening));
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (!text.starts_with("%YAML")) return openings;
  std::size_t furthest = 0;
  for (const std::string_view line : split_lines(text)) {
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    const auto marks =
        static_cast<std::size_t>(std::ranges::count(line, ':') + std::ranges::count(line, '-'));
    furthest = std::max(furthest, blanks + marks);
  }
  return openings + furthest;
}

/// OpenCV's XML reader follows a null pointer where the text ends behind the '=' of an attribute.
bool is_cut_off_xml(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::string_view body = trimmed(text);
  return body.starts_with('<') && !body.ends_with('>');
}

/// The numbers of a matrix entry, read one by one: the stated size does not allocate memory.
Result<std::vector<double>> numbers(const cv::FileNode& node, const char* entry, std::size_t most,
                                    const std::string& where) {
  const cv::FileNode data = node.isMap() ? node["data"] : node;
  if (!data.isSeq()) return Error{fmt::format("\"{}\" is no matrix; {}", entry, advice), where};
  if (data.size() > most)
    return Error{fmt::format("\"{}\" has {} numbers, at most {} were expected", entry, data.size(), most),
                 where};
  std::vector<double> values;
  for (const cv::FileNode& value : data) {
    if (!value.isReal() && !value.isInt())
      return Error{fmt::format("\"{}\" has something that is no number", entry), where};
    values.push_back(value.real());
    if (!std::isfinite(values.back()))
      return Error{fmt::format("\"{}\" has a number that is not finite", entry), where};
  }
  return values;
}

Result<int> pixels(const cv::FileStorage& file, const char* entry, std::size_t in_size,
                   const std::string& where) {
  cv::FileNode node = file[entry];
  if (node.empty() && file["image_size"].isSeq() && file["image_size"].size() == 2)
    node = file["image_size"][static_cast<int>(in_size)];
  const double value = node.isInt() || node.isReal() ? node.real() : 0;
  if (!(value >= 1) || value > largest_side_px || value != std::floor(value))
    return Error{fmt::format("\"{}\" is missing or no size of a picture; {}", entry, advice), where};
  return static_cast<int>(value);
}

Status take_matrix(CameraIntrinsics& result, const cv::FileStorage& file, const std::string& where) {
  cv::FileNode node = file["camera_matrix"];
  if (node.empty()) node = file["Camera_Matrix"];
  if (node.empty()) return Error{std::string("\"camera_matrix\" is missing; ") + advice, where};
  const auto k = numbers(node, "camera_matrix", 9, where);
  if (!k) return k.error();
  if (k->size() != 9)
    return Error{fmt::format("\"camera_matrix\" has {} numbers, 3 x 3 were expected", k->size()), where};
  const auto& m = *k;
  if (!(m[0] > 0) || !(m[4] > 0) || m[3] != 0 || m[6] != 0 || m[7] != 0 || m[8] != 1)
    return Error{"\"camera_matrix\" is not of the form fx 0 cx, 0 fy cy, 0 0 1 with fx and fy above 0",
                 where};
  if (std::abs(m[1]) > 1e-6 * m[0])
    return Error{fmt::format("\"camera_matrix\" has a skew of {:.4g}, which is not supported; calibrate "
                             "without it",
                             m[1]),
                 where};
  result.fx = m[0];
  result.cx = m[2];
  result.fy = m[4];
  result.cy = m[5];
  return Done{};
}

Status take_distortion(CameraIntrinsics& result, const cv::FileStorage& file, const std::string& where) {
  cv::FileNode node = file["distortion_coefficients"];
  if (node.empty()) node = file["Distortion_Coefficients"];
  if (node.empty()) return Error{std::string("\"distortion_coefficients\" is missing; ") + advice, where};
  const auto k = numbers(node, "distortion_coefficients", most_coefficients, where);
  if (!k) return k.error();
  for (const std::size_t known : {0, 4, 5, 8, 12, 14}) {
    if (k->size() != known) continue;
    for (std::size_t i = 0; i < k->size(); ++i) {
      if (i < result.distortion.size())
        result.distortion[i] = (*k)[i];
      else if ((*k)[i] != 0)
        return Error{
            "\"distortion_coefficients\" has thin prism or tilt terms, which are not supported; "
            "calibrate with k1 k2 p1 p2 k3 k4 k5 k6 at most",
            where};
    }
    return Done{};
  }
  return Error{
      fmt::format("\"distortion_coefficients\" has {} numbers; 0, 4, 5 or 8 were expected", k->size()),
      where};
}

Result<CameraIntrinsics> intrinsics_of(const cv::FileStorage& file, const std::string& where) {
  if (const cv::FileNode fisheye = file["fisheye_model"]; fisheye.isInt() && static_cast<int>(fisheye) != 0)
    return Error{
        "is a calibration of the fisheye model, which is not supported; calibrate with the standard "
        "model",
        where};
  CameraIntrinsics result;
  const auto width = pixels(file, "image_width", 0, where);
  if (!width) return width.error();
  const auto height = pixels(file, "image_height", 1, where);
  if (!height) return height.error();
  result.width = *width;
  result.height = *height;
  if (const Status matrix = take_matrix(result, file, where); !matrix) return matrix.error();
  if (const Status distortion = take_distortion(result, file, where); !distortion) return distortion.error();
  return result;
}

}  // namespace

Result<CameraIntrinsics> read_intrinsics(const std::filesystem::path& file) {
  std::error_code failure;
  const auto bytes = std::filesystem::file_size(file, failure);
  if (!failure && bytes > most_calibration_bytes)
    return Error{fmt::format("has {} bytes; a calibration has less than 1 MB", bytes), file.string()};
  auto text = read_whole_file(file);
  if (!text) return text.error();
  if (trimmed(*text).empty()) return Error{std::string("is empty; ") + advice, file.string()};
  // At a zero byte OpenCV's parser of XML reads from a null pointer.
  if (text->find('\0') != std::string::npos)
    return Error{std::string("has a zero byte, so it is not text; ") + advice, file.string()};
  if (most_levels(*text) > deepest)
    return Error{fmt::format("may have more than {} levels inside each other; {}", deepest, advice),
                 file.string()};
  if (is_cut_off_xml(*text)) return Error{std::string("is XML that is cut off; ") + advice, file.string()};
  try {
    const cv::FileStorage storage(*text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    if (!storage.isOpened()) return Error{std::string("cannot be read; ") + advice, file.string()};
    return intrinsics_of(storage, file.string());
  } catch (const cv::Exception& trouble) {
    return Error{fmt::format("cannot be read ({}); {}", trimmed(trouble.err), advice), file.string()};
  } catch (const std::exception&) {
    // OpenCV's use of strings throws too, for example at a value without a key in YAML
    // ("basic_string::_M_create").
    return Error{std::string("cannot be read; ") + advice, file.string()};
  }
}

Status write_intrinsics(const CameraIntrinsics& intrinsics, const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  if (extension != ".yaml" && extension != ".yml" && extension != ".xml" && extension != ".json")
    return Error{"a calibration is written as .yaml, .yml, .xml or .json", file.string()};
  try {
    cv::FileStorage storage(extension == ".yaml" ? ".yml" : extension,
                            cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
    storage << "image_width" << intrinsics.width << "image_height" << intrinsics.height;
    storage << "camera_matrix"
            << cv::Mat(
                   cv::Matx33d(intrinsics.fx, 0, intrinsics.cx, 0, intrinsics.fy, intrinsics.cy, 0, 0, 1));
    cv::Mat distortion(static_cast<int>(intrinsics.distortion.size()), 1, CV_64F);
    std::ranges::copy(intrinsics.distortion, distortion.ptr<double>());
    storage << "distortion_coefficients" << distortion;
    return write_whole_file(file, storage.releaseAndGetString());
  } catch (const cv::Exception& trouble) {
    return Error{"cannot be written: " + trouble.err, file.string()};
  }
}

}  // namespace abrazo
