#include "core/motion/files/format_recognition.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/motion/numpy/numpy_reader.hpp"
#include "core/motion/tables/point_csv.hpp"

namespace abrazo {

namespace {

bool is_c3d(std::string_view head) {
  // The second byte is the format's key; the first, where the parameters are, is a small number.
  return head.size() >= 512 && head[1] == 0x50 && head[0] > 0 && head[0] < 9;
}

/// The first word that is no comment, in capitals.
std::string first_word(std::string_view head) {
  LineReader lines(head);
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view word = take_word(line);
    if (word.empty() || word.front() == '#') continue;
    std::string capitals(word.substr(0, 40));
    std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return capitals;
  }
  return {};
}

std::optional<MotionFormat> acclaim_format(std::string_view head) {
  const std::string text = lower_case(head.substr(0, 4096));
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  if (has(":bonedata") || has(":version") || has(":units") || has(":hierarchy")) return MotionFormat::Asf;
  if (has(":fully-specified") || has(":degrees") || has(":radians")) return MotionFormat::Amc;
  return std::nullopt;
}

/// How the bytes of other programs' files begin, and what to do with them.
struct Foreign {
  std::string_view begins;
  std::string_view extension;  ///< empty: any
  std::string_view says;
};
constexpr std::string_view as_motion = "export the motion as FBX, GLB or BVH";
constexpr std::array foreign_files = {
    Foreign{"PXR-USDC", "", "a USD file; open it in Blender, Maya or Omniverse and "},
    Foreign{"#usda", "", "a USD file; open it in Blender, Maya or Omniverse and "},
    Foreign{"PK\x03\x04", ".usdz", "a USD file; open it in Blender, Maya or Omniverse and "},
    Foreign{"BLENDER", "", "a Blender file; open it in Blender and "},
    Foreign{"//Maya ASCII", "", "a Maya scene; open it in Maya and "},
    Foreign{"FOR4", "", "a Maya scene; open it in Maya and "},
    Foreign{"FOR8", "", "a Maya scene; open it in Maya and "},
    Foreign{"MATLAB 5.0", "", "a MATLAB file; write its positions as CSV or C3D, or "},
    Foreign{"PK\x03\x04", "", "a ZIP archive; unpack it first, and open what is in it"},
    Foreign{"\x1f\x8b", "", "compressed (gzip); unpack it first, and open what is in it"},
    Foreign{"\x89HDF", "", "an HDF5 file, not a motion; a library of Abrazo needs a name that ends in .h5"},
    Foreign{"SQLite format 3", "", "a database; a session of Abrazo ends in .abrazo and is opened by itself"},
    Foreign{"\x89PNG", "", "a picture, not a motion"},
    Foreign{"\xff\xd8\xff", "", "a picture, not a motion"},
    Foreign{"RIFF", "", "a video or sound, not a motion"},
    Foreign{"%PDF", "", "a PDF document, not a motion"},
};
struct Named {
  std::string_view extension, says;
};
/// Formats without a published beginning, by their names.
constexpr std::array named_files = {
    Named{".tak", "a take of OptiTrack Motive; open it in Motive and export C3D, FBX, BVH or CSV"},
    Named{".qtm", "a file of Qualisys Track Manager; open it in QTM and export C3D or FBX"},
    Named{".mvn", "a recording of Xsens MVN; open it in MVN and export FBX or BVH"},
    Named{".mcp", "a session of Vicon Shogun; open it in Shogun and export FBX or C3D"},
    Named{".x2d", "camera data of Vicon; reconstruct it in Nexus or Shogun and export C3D"},
    Named{".cap", "a capture of Cortex; open it in Cortex and export C3D or TRC"},
    Named{".pkl",
          "a Python pickle, which may run anything when it is read; write its positions as .npz or CSV"},
    Named{".max", "a 3ds Max scene; open it in 3ds Max and export the motion as FBX"},
    Named{".bip", "a Character Studio file; open it in 3ds Max and export the motion as FBX or BVH"},
    Named{".mot", "joint angles of OpenSim; export the marker positions as TRC"},
    Named{".sto", "a storage file of OpenSim; export the marker positions as TRC"},
};

}  // namespace

std::optional<MotionFormat> format_of_content(std::string_view head) {
  if (is_c3d(head)) return MotionFormat::C3d;
  if (head.starts_with("glTF")) return MotionFormat::Gltf;
  if (head.starts_with("Kaydara FBX Binary") || head.starts_with("; FBX")) return MotionFormat::Fbx;
  if (head.starts_with("\x93NUMPY") || begins_as_npz(head)) return MotionFormat::Numpy;
  const std::string_view start = head.substr(0, 65536);
  if (start.find('\0') != std::string_view::npos) return std::nullopt;
  if (start.substr(0, 4096).find("<COLLADA") != std::string_view::npos) return MotionFormat::Collada;
  const std::string word = first_word(start);
  if (word == "HIERARCHY") return MotionFormat::Bvh;
  if (word == "PATHFILETYPE") return MotionFormat::Trc;
  if (word.starts_with('{'))
    return start.find("\"asset\"") != std::string_view::npos ? std::optional(MotionFormat::Gltf)
                                                             : std::nullopt;
  if (word.starts_with(':')) return acclaim_format(start);
  if (holds_positions(start)) return MotionFormat::PointCsv;
  return std::nullopt;
}

std::string foreign_kind(std::string_view head, std::string_view file) {
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  // A file named .npz is read as one; its reader reports problems.
  if (extension == ".npz" && head.starts_with("PK")) return {};
  for (const Foreign& foreign : foreign_files) {
    if (!head.starts_with(foreign.begins)) continue;
    if (!foreign.extension.empty() && foreign.extension != extension) continue;
    std::string words = "is " + std::string(foreign.says);
    if (words.ends_with(' ')) words += as_motion;
    return words;
  }
  if (head.size() > 12 && head.substr(4, 4) == "ftyp") return "is a video, not a motion";
  if (head.substr(0, 2048).find("<mvnx") != std::string_view::npos)
    return "is an MVNX file of Xsens MVN; export FBX or BVH from MVN";
  for (const Named& named : named_files)
    if (named.extension == extension) return "is " + std::string(named.says);
  return {};
}

}  // namespace abrazo
