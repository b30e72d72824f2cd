#include "core/motion/numpy/numpy_writer.hpp"

#include <vector>

#include "core/motion/numpy/npy_array.hpp"
#include "core/motion/numpy/zip_archive.hpp"

namespace abrazo {

Result<std::string> write_npy(const Clip& clip, const JointOrder& order) {
  const auto points = OrderedPoints::of(order);
  if (!points) return points.error();
  std::vector<double> values;
  values.reserve(clip.poses.size() * order.points.size() * 3);
  for (const Pose& pose : clip.poses) {
    const Positions places = points->positions_of(pose);
    values.insert(values.end(), places.data(), places.data() + places.size());
  }
  return npy_of_numbers(values, {clip.poses.size(), order.points.size(), 3});
}

Result<std::string> write_npz(std::span<const Clip> clips, const JointOrder& order, UpAxis up,
                              double metres_per_unit) {
  if (clips.empty()) return Error{"there is no motion to write", ""};
  std::vector<ZipContent> files;
  for (const Clip& clip : clips) {
    if (clip.fps != clips.front().fps)
      return Error{"has another frame rate than '" + clips.front().name +
                       "', and a .npz has one for all; write them one by one",
                   clip.name};
    auto positions = write_npy(clip, order);
    if (!positions) return positions.error();
    const std::string name = clips.size() == 1 ? "positions" : "person" + std::to_string(files.size() + 1);
    files.push_back({name + ".npy", std::move(*positions)});
  }
  files.push_back({"joint_names.npy", npy_of_texts(order.points, {order.points.size()})});
  files.push_back({"fps.npy", npy_of_numbers({clips.front().fps}, {})});
  files.push_back({"up.npy", npy_of_texts({name_of(up)}, {})});
  files.push_back({"metres_per_unit.npy", npy_of_numbers({metres_per_unit}, {})});
  return write_zip(files);
}

}  // namespace abrazo
