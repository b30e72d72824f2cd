#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// A decoded picture: upright, RGB, rows from the top without padding. Empty if unavailable.
struct DecodedPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Sequential access to the pictures of a video. The target of a jump is known only from the time of the
/// picture reached.
class PictureStream {
 public:
  virtual ~PictureStream() = default;

  /// @param file  absolute
  /// @return false if it cannot be decoded; a previously open file is closed
  virtual bool open(const std::filesystem::path& file) = 0;
  /// Returns to the beginning, before the first picture.
  virtual bool restart() = 0;
  virtual bool next() = 0;
  /// Time of the last decoded picture, by the clock of the file.
  virtual double stamp_ms() const = 0;
  /// Jumps to about this time, rather slightly before it, and decodes a picture.
  virtual bool jump(double seconds_after_start) = 0;
  virtual DecodedPicture picture() const = 0;
  /// Hash of the decoded picture.
  virtual std::uint64_t fingerprint() const = 0;

  /// Width and height that the container names, before anything is decoded and turned upright; 0 if unknown.
  virtual std::array<int, 2> promised_size() const = 0;
  virtual double nominal_hz() const = 0;
  virtual int promised() const = 0;
  /// Clockwise turn of the pictures, by the file's header unless `turn` was called.
  virtual int rotation_deg() const = 0;
  /// Mirrors the pictures left to right if wanted, then turns them clockwise, in place of the header's turn.
  virtual void turn(int degrees, bool mirrors) = 0;
  virtual std::string codec() const = 0;
  /// Width of a pixel divided by its height.
  virtual double pixel_aspect() const = 0;
};

/// Writes pictures to an MPEG-4 video.
class PictureSink {
 public:
  virtual ~PictureSink() = default;

  /// @param file its extension selects the container
  virtual bool open(const std::filesystem::path& file, int width, int height, double fps) = 0;
  /// @param rgb the rows of a picture, `stride` bytes apart
  virtual void add(const std::uint8_t* rgb, std::size_t stride) = 0;
  virtual void close() = 0;
};

/// Decoder and encoder of videos: a module (libabrazo-video.so, from core/video/opencv/) that is loaded when
/// the first video is opened or written. OpenCV depends on 170 libraries, which would otherwise be loaded at
/// every start.
class VideoCodec {
 public:
  virtual ~VideoCodec() = default;
  virtual std::unique_ptr<PictureStream> stream() const = 0;
  virtual std::unique_ptr<PictureSink> sink() const = 0;
  /// Number of pictures by the header of the file; 0 if it cannot be opened.
  virtual int pictures_in(const std::filesystem::path& file) const = 0;
};

/// Loads the module on the first call and keeps it. The Error lists the searched places.
Result<const VideoCodec*> video_codec();

/// Search places of the module: beside the program, in the build tree, and in the installation; never in
/// places writable by others. Relative paths are excluded, because they would depend on the working
/// directory.
/// @param program absolute path of the program; without it there are no places
std::vector<std::filesystem::path> video_codec_places(const std::filesystem::path& program);

/// Keeps the decoder from writing to the console. Changes the environment, so call it before threads that
/// open videos start; video_codec() also calls it.
void silence_video_codec();

}  // namespace abrazo
