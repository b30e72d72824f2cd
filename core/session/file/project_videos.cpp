#include "core/session/file/project_videos.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "core/video/camera_file.hpp"

namespace abrazo {

namespace {

constexpr const char* camera_columns =
    "video, width, height, fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6, r11, r12, r13, r21, r22, r23, "
    "r31, "
    "r32, r33, tx, ty, tz";

Status write_data(SessionDatabase& database, const std::vector<DataReference>& data) {
  auto insert = database.prepare(
      "INSERT INTO data_references (id, use, relative_path, absolute_path, bytes, hash) VALUES (?, ?, ?, ?, "
      "?, ?)");
  if (!insert) return insert.error();
  std::int64_t row = 0;
  for (const DataReference& one : data) {
    insert->bind(0, ++row).bind(1, text_of(one.use)).bind(3, one.absolute_path).bind(4, one.bytes);
    one.relative_path.empty() ? insert->bind_null(2) : insert->bind(2, one.relative_path);
    if (const Status done = insert->bind(5, one.hash).run(); !done) return done;
  }
  return Done{};
}

Status write_camera(SessionDatabase& database, std::int64_t video, const CameraModel& camera) {
  auto insert = database.prepare(std::string("INSERT INTO cameras (") + camera_columns +
                                 ") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                                 "?, ?, ?, ?, ?, ?)");
  if (!insert) return insert.error();
  const CameraIntrinsics& lens = camera.intrinsics;
  insert->bind(0, video).bind(1, lens.width).bind(2, lens.height);
  int column = 3;
  for (const double value : {lens.fx, lens.fy, lens.cx, lens.cy}) insert->bind(column++, value);
  for (const double value : lens.distortion) insert->bind(column++, value);
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 3; ++c) insert->bind(column++, camera.pose.rotation(r, c));
  for (Eigen::Index i = 0; i < 3; ++i) insert->bind(column++, camera.pose.translation[i]);
  return insert->run();
}

CameraModel camera_of(const SessionStatement& row) {
  CameraModel camera;
  CameraIntrinsics& lens = camera.intrinsics;
  const auto pixels = [&](int column) {
    return static_cast<int>(
        std::clamp<std::int64_t>(row.integer(column), 0, std::numeric_limits<int>::max()));
  };
  lens.width = pixels(2);
  lens.height = pixels(3);
  int column = 4;
  for (double* value : {&lens.fx, &lens.fy, &lens.cx, &lens.cy}) *value = row.real(column++);
  for (double& value : lens.distortion) value = row.real(column++);
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 3; ++c) camera.pose.rotation(r, c) = row.real(column++);
  for (Eigen::Index i = 0; i < 3; ++i) camera.pose.translation[i] = row.real(column++);
  return camera;
}

Status write_video(SessionDatabase& database, const ProjectVideo& video) {
  auto insert = database.prepare("INSERT INTO videos (data, subject, rate) VALUES (?, ?, ?)");
  auto sync = database.prepare("INSERT INTO sync_points (video, subject_s, video_s) VALUES (?, ?, ?)");
  auto picked = database.prepare(
      "INSERT INTO picked_points (video, x, y, z, pixel_x, pixel_y, subject_s, vertex) VALUES (?, ?, ?, ?, "
      "?, ?, ?, ?)");
  for (const auto* one : {&insert, &sync, &picked})
    if (!*one) return one->error();
  video.data < 0 ? insert->bind_null(0) : insert->bind(0, video.data + 1);
  if (const Status done = insert->bind(1, video.subject).bind(2, video.sync.rate).run(); !done) return done;
  const std::int64_t row = database.last_row_id();
  for (const SyncPoint& point : video.sync.points)
    if (const Status done = sync->bind(0, row).bind(1, point.subject_s).bind(2, point.video_s).run(); !done)
      return done;
  for (const PickedPoint& point : video.picked) {
    picked->bind(0, row).bind(1, point.world.x()).bind(2, point.world.y()).bind(3, point.world.z());
    picked->bind(4, point.pixel.x()).bind(5, point.pixel.y()).bind(6, point.subject_s);
    point.vertex < 0 ? picked->bind_null(7) : picked->bind(7, point.vertex);
    if (const Status done = picked->run(); !done) return done;
  }
  return video.camera ? write_camera(database, row, *video.camera) : Status(Done{});
}

/// Rows that belong to a video.
class VideoRows {
 public:
  VideoRows(TableReader& tables, std::vector<ProjectVideo>& videos) : tables_(tables), videos_(videos) {}

  void add(std::int64_t row, ProjectVideo video) {
    places_[row] = videos_.size();
    videos_.push_back(std::move(video));
  }

  /// The video is column 1; `numbers` after it have to be finite.
  void each(const std::string& what, const std::string& table, const std::string& columns, int numbers,
            const std::function<Status(ProjectVideo&, const SessionStatement&)>& take) {
    tables_.each(what, table, columns, [&](const SessionStatement& row) -> Status {
      const auto place = places_.find(row.integer(1));
      if (place == places_.end()) return Error{"its video is not there", {}};
      for (int column = 2; column < 2 + numbers; ++column)
        if (Status good = finite(row, {column}, "a row of " + what); !good) return good;
      return take(videos_[place->second], row);
    });
  }

 private:
  TableReader& tables_;
  std::vector<ProjectVideo>& videos_;
  std::map<std::int64_t, std::size_t> places_;
};

/// @return by row of the table, the index into `data`
std::map<std::int64_t, int> read_data(TableReader& tables, std::vector<DataReference>& data) {
  std::map<std::int64_t, int> places;
  tables.each("references to data", "data_references",
              "use, coalesce(relative_path, ''), absolute_path, bytes, hash",
              [&](const SessionStatement& row) -> Status {
                const auto use = parse_data_use(row.text(1));
                if (!use) return use.error();
                if (row.integer(4) < 0) return Error{"a file of negative size", {}};
                places[row.integer(0)] = static_cast<int>(data.size());
                data.push_back({*use, row.text(2), row.text(3), static_cast<std::uint64_t>(row.integer(4)),
                                row.text(5)});
                return Done{};
              });
  return places;
}

}  // namespace

Status write_data_and_videos(SessionDatabase& database, const Project& project) {
  const Status cleared = database.execute(
      "DELETE FROM picked_points; DELETE FROM cameras; DELETE FROM sync_points; DELETE FROM videos; "
      "DELETE FROM data_references");
  if (!cleared) return cleared;
  if (const Status done = write_data(database, project.data); !done) return done;
  for (const ProjectVideo& video : project.videos)
    if (const Status done = write_video(database, video); !done) return done;
  return Done{};
}

void read_data_and_videos(TableReader& tables, Project& project) {
  const std::map<std::int64_t, int> data = read_data(tables, project.data);
  VideoRows rows(tables, project.videos);
  tables.each("videos", "videos", "data, subject, rate", [&](const SessionStatement& row) -> Status {
    if (Status good = finite(row, {3}, "the rate of a video"); !good) return good;
    ProjectVideo video;
    if (const auto place = data.find(row.integer(1)); !row.is_null(1) && place != data.end())
      video.data = place->second;
    video.subject = row.text(2);
    video.sync.rate = row.real(3);
    if (Status good = check_sync(video.sync); !good) return good;
    rows.add(row.integer(0), std::move(video));
    return Done{};
  });
  rows.each("sync points", "sync_points", "video, subject_s, video_s", 2,
            [](ProjectVideo& video, const SessionStatement& row) -> Status {
              if (video.sync.points.size() >= 2) return Error{"a video has more than two", {}};
              VideoSync sync = video.sync;
              sync.points.push_back({row.real(2), row.real(3)});
              if (Status good = check_sync(sync); !good) return good;
              video.sync = std::move(sync);
              return Done{};
            });
  rows.each("cameras", "cameras", camera_columns, 26,
            [](ProjectVideo& video, const SessionStatement& row) -> Status {
              if (video.camera) return Error{"a video has two", {}};
              const CameraModel camera = camera_of(row);
              if (Status good = check_camera(camera, {}); !good) return good;
              video.camera = camera;
              return Done{};
            });
  rows.each(
      "picked points", "picked_points", "video, x, y, z, pixel_x, pixel_y, subject_s, coalesce(vertex, -1)",
      6, [](ProjectVideo& video, const SessionStatement& row) -> Status {
        const std::int64_t vertex = row.integer(8);
        if (vertex < -1 || vertex >= pair_vertex_count) return Error{"a joint that no pair has", {}};
        video.picked.push_back({Vec3(row.real(2), row.real(3), row.real(4)), Pixel(row.real(5), row.real(6)),
                                static_cast<int>(vertex), row.real(7)});
        return Done{};
      });
}

}  // namespace abrazo
