#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// How much of a stranger's file is read where its own words decide how much memory or time that takes. A
/// test tries each limit and one step beyond it.
namespace abrazo::limits {

/// Files that are read as a whole [bytes]: an hour of one person at 120 Hz is some 300 MB as BVH text.
inline constexpr std::uintmax_t whole_file_bytes = std::uintmax_t{4} << 30U;

/// A line for a terminal [bytes]: the longest of our own lists the settings.
inline constexpr std::size_t line_bytes = 8'000;

/// JSON: brackets inside each other, and values of one text. A million intervals of labels have five million.
inline constexpr std::size_t json_depth = 100, json_values = 6'000'000;
/// Settings as JSON [bytes]: all of them have some 4 000.
inline constexpr std::size_t settings_bytes = 1U << 20U;

/// A row of a session file [bytes]: a project's longest text has a few MB.
inline constexpr int session_row_bytes = 16 << 20;

/// Numbers of one NumPy file, all arrays that are read together: 512 MiB as doubles, two hours of 25 joints
/// at 120 Hz.
inline constexpr std::uint64_t numpy_numbers = std::uint64_t{1} << 26U;
/// Texts of one array of a NumPy file, which are names of joints.
inline constexpr std::uint64_t numpy_texts = 10'000;
/// A .npy file [bytes]: its numbers as doubles, and its header.
inline constexpr std::uintmax_t npy_file_bytes = numpy_numbers * sizeof(double) + (1U << 16U);
/// Entries of a ZIP archive (.npz).
inline constexpr std::uint64_t archive_entries = 4096;
/// Content per stored byte of a ZIP archive: Deflate gives no more.
inline constexpr std::uint64_t deflate_ratio = 1032;
/// Of an SMPL body model: SMPL-X has 10 475 vertices and 400 shapes.
inline constexpr std::uint64_t body_vertices = 20'000, body_shapes = 1'000;

/// Primitives of a character's skin, counted for each node that shows them: a character has some dozens.
inline constexpr std::size_t character_primitives = 10'000;

/// Pixels of a picture of a video.
inline constexpr double video_pixels = 8192.0 * 8192.0;

}  // namespace abrazo::limits

namespace abrazo {

/// Why a JSON text is not to be parsed: it is nested deeper, or has more values, than the limits. Values are
/// written, copied and compared by recursion, to a depth set by the file, and each takes some fifty bytes
/// however few it has in the text. Null for others, whatever else is wrong with them.
const char* json_beyond_bounds(std::string_view json);

}  // namespace abrazo
