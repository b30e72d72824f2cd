#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// As it was decoded last: upright, red, green, blue, rows from the top without padding. Empty where it
/// cannot be had.
struct DecodedPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The pictures of a video one after the other. Where a jump lands is only known by the time of the picture
/// it lands on.
class PictureStream {
 public:
  virtual ~PictureStream() = default;

  /// @param file  absolute
  /// @return false where there is nothing that decodes; what was open before is closed
  virtual bool open(const std::filesystem::path& file) = 0;
  /// At the beginning again, before the first picture.
  virtual bool restart() = 0;
  virtual bool next() = 0;
  /// Of the picture that was decoded last, by the clock of the file.
  virtual double stamp_ms() const = 0;
  /// About there, a little earlier if anything; a picture is decoded.
  virtual bool jump(double seconds_after_start) = 0;
  virtual DecodedPicture picture() const = 0;
  /// Of the picture as it is decoded; two that differ have another with all likelihood.
  virtual std::uint64_t fingerprint() const = 0;

  virtual double nominal_hz() const = 0;
  virtual int promised() const = 0;
  virtual int rotation_deg() const = 0;
  virtual std::string codec() const = 0;
  /// Width of a pixel by its height.
  virtual double pixel_aspect() const = 0;
};

/// Pictures into an MPEG-4 video.
class PictureSink {
 public:
  virtual ~PictureSink() = default;

  /// @param file  whose ending says which container
  virtual bool open(const std::filesystem::path& file, int width, int height, double fps) = 0;
  /// @param rgb  as many rows as the video has, each `stride` bytes after the other
  virtual void add(const std::uint8_t* rgb, std::size_t stride) = 0;
  virtual void close() = 0;
};

/// What decodes and encodes videos: a module (libabrazo-video.so, from core/video/opencv/) that is loaded
/// when the first video is opened or written. OpenCV brings 170 libraries along, which would otherwise be
/// loaded at every start.
class VideoCodec {
 public:
  virtual ~VideoCodec() = default;
  virtual std::unique_ptr<PictureStream> stream() const = 0;
  virtual std::unique_ptr<PictureSink> sink() const = 0;
  /// By the header of the file; 0 when it cannot be opened.
  virtual int pictures_in(const std::filesystem::path& file) const = 0;
};

/// Loads the module at the first call, and stays. The error says where it was looked for.
Result<const VideoCodec*> video_codec();

/// Where it is looked for: beside the program, as it is built, and where it is installed; nowhere that others
/// may write to. A relative path would be one in whatever folder the program was started from.
/// @param program  its own file, absolute; where that is not known there is no place
std::vector<std::filesystem::path> video_codec_places(const std::filesystem::path& program);

/// Keeps what decodes from writing to the console. It changes the environment: to be called before threads
/// start that open videos; video_codec() calls it as well.
void silence_video_codec();

}  // namespace abrazo
