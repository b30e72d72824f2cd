// abrazo_fuzz_seeds FOLDER: writes FOLDER/<target>/ with small inputs that are valid, made by this program's
// own writers, and a few that are hostile by design: what a fuzzer would need luck to find. They stay in the
// build folder; the few of tests/fuzz/corpus are chosen by tests/fuzz/keep.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <fstream>
#include <iterator>

#include "core/evaluation/sweep/sweep_file.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/motion/files/clip_file.hpp"
#include "core/motion/joints/joint_map.hpp"
#include "core/motion/scenes/glb_writer.hpp"
#include "core/session/file/decisions_json.hpp"
#include "core/session/file/synthesizer_state_bytes.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/protocol/stream_encoder.hpp"
#include "core/stream/receive/decoders.hpp"
#include "core/stream/send/encoders.hpp"
#include "core/synthesis/frames/trace.hpp"
#include "core/video/camera_file.hpp"
#include "tests/core/motion/c3d_bytes.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/session_template.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/humanoid_rig.hpp"
#include "tests/support/libraries.hpp"
#include "widgets/plots/pane_arrangement.hpp"
#include "widgets/timeline/timeline_lanes.hpp"

namespace abrazo::fuzz {
namespace {

namespace fs = std::filesystem;

fs::path root;

void seed(const std::string& target, const std::string& name, std::string_view bytes) {
  fs::create_directories(root / target);
  std::ofstream(root / target / name, std::ios::binary) << bytes;
}

void seed(const std::string& target, const std::string& name, const std::vector<std::uint8_t>& bytes) {
  seed(target, name, text_of(bytes));
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Clip> dancers(std::size_t frames) {
  std::vector<Clip> clips(2);
  for (std::size_t c = 0; c < 2; ++c) {
    clips[c].name = c == 0 ? "active" : "passive";
    for (std::size_t f = 0; f < frames; ++f) {
      const double t = static_cast<double>(f);
      clips[c].poses.push_back(
          test::moved(test::standing_pose(), 0.1 * t, Vec3(c == 0 ? 0.0 : 1.5, 0, 0.02 * t)));
    }
  }
  return clips;
}

// ---- motions ----

void write_tables() {
  const std::vector<Clip> two = dancers(3);
  for (const char* type : {".bvh", ".csv"}) {
    const std::string target = type == std::string(".bvh") ? "bvh" : "point_csv";
    seed(target, "one" + std::string(type),
         *clip_file_content("a" + std::string(type), std::span(two).first(1)));
    seed(target, "two" + std::string(type), *clip_file_content("a" + std::string(type), two));
  }
  const char* joints[] = {"Hip", "Ab", "LThigh", "LShin", "LFoot", "LToe"};
  std::string motive = "Format Version,1.23,Take Name,t,Capture Frame Rate,120,Length Units,Meters\n\n",
              names = ",Name", kinds = ",Type", axes = "Frame,Time (Seconds)", row1 = "0,0.0",
              row2 = "1,0.0083";
  for (const char* joint : joints)
    for (const char* axis : {"X", "Y", "Z"}) {
      kinds += ",Bone", names += std::string(",Ana:") + joint, axes += std::string(",") + axis;
      row1 += ",0.5", row2 += ",";
    }
  seed("point_csv", "motive.csv",
       motive + kinds + "\n" + names + "\n" + axes + "\n" + row1 + "\n" + row2 + "\n");
  seed("point_csv", "nexus.csv",
       "Trajectories\n100\n,,LASI,,,RASI,,\nFrame,Sub "
       "Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n1,0,1,2,3,4,5,6\n2,0,1,2,3,,,\n");
  seed("point_csv", "commas.csv", "t;a_x [mm];a_y [mm];a_z [mm]\n0,1;1,5;2;3\n0,2;1,5;2;3\n");
  seed(
      "trc", "two.trc",
      "PathFileType\t4\t(X/Y/Z)\twalk.trc\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\t"
      "OrigDataStartFrame\tOrigNumFrames\n60\t60\t2\t2\tmm\t60\t1\t2\nFrame#\tTime\tAna:LASI\t\t\tBen:"
      "RASI\t\t\n"
      "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n1\t0\t1\t2\t3\t4\t5\t6\n2\t0.016\t1\t2\t3\t\t\t\n");
  seed("asf", "leg.asf", content_of("tests/fixtures/motion/leg.asf"));
  seed("asf", "leg_radians.asf", content_of("tests/fixtures/motion/leg_radians.asf"));
  for (const char* name : {"leg.amc", "leg_radians.amc", "leg_comments.amc"})
    seed("amc", name, content_of(std::string("tests/fixtures/motion/") + name));
  for (const char* name :
       {"arm.bvh", "glued_numbers.bvh", "mixamo_z_up_inches.bvh", "decimal_commas.bvh", "two_roots.bvh"})
    seed("bvh", name, content_of(std::string("tests/fixtures/motion/") + name));
}

/// Fuzzers find no checksums, and little of deflated data: plain arrays, archives with and without damage.
void write_numpy() {
  const std::vector<Clip> two = dancers(2);
  for (const std::size_t people : {1U, 2U})
    seed("numpy", fmt::format("people_{}.npz", people),
         *clip_file_content("a.npz", std::span(two).first(people)));
  for (const JointOrder& order : builtin_joint_orders())
    seed("numpy", order.name + ".npy",
         *clip_file_content("a.npy", std::span(two).first(1), {1, UpAxis::Y, order}));
  for (const char* name :
       {"damaged_deflate.npz", "huge_shape.npy", "infinite.npy", "nan.npy", "python_objects.npy",
        "smpl_parameters.npz", "two_orders.npy", "wrong_checksum.npz"})
    seed("numpy", name, content_of(std::string("tests/fixtures/motion/broken/") + name));
  seed("numpy", "order.txt", "Hips\nSpine\nHead\n");
  seed("numpy", "order.json", R"(["Pelvis", "L_Hip"])");
}

void write_c3d() {
  using Writer = test::C3dBytesWriter;
  int number = 0;
  for (const auto processor : {Writer::Intel, Writer::Dec, Writer::Mips})
    for (const bool floats : {true, false}) {
      Writer writer;
      writer.processor = processor;
      writer.floats = floats;
      writer.labels = {"Ana:LASI", "Ana:RASI", "Ben:T10"};
      writer.frames.assign(2, {{1, 2, 3}, {4, 5, 6}, {0, 0, 0, -1}});
      if (number % 2) writer.analog_values = 3;
      writer.add_texts("SUBJECTS", "NAMES", {"Ana", "Ben"});
      writer.add_integers("TRIAL", "ACTUAL_START_FIELD", {1, 0});
      seed("c3d", fmt::format("small_{}.c3d", number++), writer.bytes());
    }
  // Segments as Theia3D has them, with points and alone.
  Writer writer;
  writer.segment_labels = {"l_hand_4X4", "head_4X4"};
  const std::array<double, 17> still{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1, 0.5};
  writer.segment_samples.assign(2, {still, still});
  writer.announced_frames = 2;
  writer.add_texts("THEIA3D", "LHAND_LENGTH", {"0.08"});
  writer.add_reals("THEIA3D", "HEADCENTER_POS", {0, 0.01, 0.05});
  seed("c3d", "segments.c3d", writer.bytes());
  writer.labels = {"BALL"};
  writer.frames = {{{1, 2, 3}}};
  writer.segment_ratio = 2;
  seed("c3d", "segments_and_points.c3d", writer.bytes());
}

/// Two nodes of which one moves.
constexpr std::string_view small_gltf =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"a","children":[1]},{"name":"b","translation":[0,1,0]}],)"
    R"("buffers":[{"byteLength":32,"uri":"data:application/octet-stream;base64,AAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAA="}],)"
    R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":8},{"buffer":0,"byteOffset":8,"byteLength":24}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":2,"type":"SCALAR"},{"bufferView":1,"componentType":5126,"count":2,"type":"VEC3"}],)"
    R"("animations":[{"samplers":[{"input":0,"output":1}],"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}]}]})";

constexpr std::string_view small_fbx = R"(; FBX 7.3.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7300
}
Objects:  {
	Model: 1, "Model::a", "LimbNode" {
		Version: 232
		Properties70:  {
			P: "Lcl Translation", "Lcl Translation", "", "A",0,1,2
		}
	}
	Model: 2, "Model::b", "LimbNode" {
	}
	AnimationStack: 3, "AnimStack::t", "" {
	}
	AnimationLayer: 4, "AnimLayer::l", "" {
	}
	AnimationCurveNode: 5, "AnimCurveNode::T", "" {
		Properties70:  {
			P: "d|X", "Number", "", "A",0
		}
	}
	AnimationCurve: 6, "AnimCurve::", "" {
		KeyTime: *2 {
			a: 0,1924423250
		}
		KeyValueFloat: *2 {
			a: 0,1
		}
	}
}
Connections:  {
	C: "OO",1,0
	C: "OO",2,1
	C: "OO",4,3
	C: "OO",5,4
	C: "OP",5,2, "Lcl Translation"
	C: "OP",6,5, "d|X"
}
)";

/// What other programs write, as Assimp writes it.
void write_scenes() {
  seed("gltf", "small.gltf", small_gltf);
  seed("fbx", "small.fbx", small_fbx);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(small_gltf.data(), small_gltf.size(), 0, "gltf");
  expect(scene != nullptr, importer.GetErrorString());
  for (const auto& [format, target, name] : {std::tuple{"fbx", "fbx", "binary.fbx"},
                                             {"fbxa", "fbx", "text.fbx"},
                                             {"collada", "collada", "one.dae"},
                                             {"gltf2", "gltf", "written.gltf"},
                                             {"glb2", "glb", "written.glb"},
                                             {"gltf", "gltf", "version_1.gltf"}}) {
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = exporter.ExportToBlob(scene, format, 0);
    if (blob) seed(target, name, {static_cast<const char*>(blob->data), blob->size});
  }
  seed("character", "mixamo.glb", test::skinned_rig(test::Naming::Mixamo));
  seed("character", "vrm0.vrm", test::skinned_rig(test::Naming::Vrm0));
  seed("character", "vrm1.vrm", test::skinned_rig(test::Naming::Vrm1));
  std::string chain = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)";
  for (int n = 0; n < 2'000; ++n) chain += fmt::format("{{\"children\":[{}]}},", n + 1);
  seed("gltf", "chain.gltf", chain + "{}]}");
  seed(
      "gltf", "circle.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"children":[0]}]})");
  seed(
      "gltf", "huge_accessor.gltf",
      R"({"asset":{"version":"2.0"},"nodes":[{}],"accessors":[{"componentType":5126,"count":2000000000,"type":"VEC4"}],)"
      R"("animations":[{"samplers":[{"input":0,"output":0}],"channels":[{"sampler":0,"target":{"node":0,"path":"rotation"}}]}]})");
  seed(
      "collada", "instance_circle.dae",
      R"(<COLLADA version="1.4.1"><library_nodes><node id="a"><instance_node url="#a"/></node></library_nodes>)"
      R"(<library_visual_scenes><visual_scene id="s"><node id="b"><instance_node url="#a"/></node></visual_scene>)"
      R"(</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
}

// ---- tables and JSON ----

void write_labels() {
  std::vector<Tier> tiers(2);
  tiers[0] = {"move",
              {{0, 1.5, "basic", "left first", "high"}, {1.5, 2.25, "turn"}},
              {{"basic", "", 0x112233, '1'}, {"turn"}},
              TierKind::Move};
  tiers[1] = {"role", {{0, 2, "a"}}, {{"a"}, {"b"}}, TierKind::Role};
  for (const auto& [target, name] : {std::pair{"eaf", "two.eaf"},
                                     {"tier_json", "two.json"},
                                     {"text_grid", "two.TextGrid"},
                                     {"elan_text", "audacity.txt"},
                                     {"tier_csv", "two.csv"}})
    seed(target, name, write_tiers(tiers, name, {})->text);
  TierWriting writing;
  writing.fps = 60, writing.take = "salsa";
  const std::string labels = write_tiers(tiers, "labels.csv", writing)->text;
  seed("labels", "salsa.csv", labels);
  seed("tier_csv", "labels.csv", labels);
  seed("text_grid", "short.TextGrid",
       "File type = \"ooTextFile short\"\n\"TextGrid\"\n\n0\n2\n<exists>\n2\n\"IntervalTier\"\n\"move\"\n0\n2\n1\n0\n2\n"
       "\"a \"\"b\"\"\"\n\"TextTier\"\n\"beat\"\n0\n2\n1\n1\n\"x\"\n");
  seed("eaf", "units.eaf", content_of("tests/fixtures/labels/units.eaf"));
}

void write_json() {
  seed(
      "manifest", "two.json",
      R"({"name":"dance","takes":[{"name":"t1","fps":60,"metres_per_unit":0.0564,"a":{"motion":"60.amc","skeleton":"60.asf","index":0,"start":3,"up_axis":"z"},)"
      R"("b":{"motion":"sub/61.amc","joint_map":"cmu"},"frames":100,"roles":"a","labels":"moves.csv","labels_tier":"move"},)"
      R"({"name":"t2","a":{"motion":"a.bvh"},"b":{"motion":"b.bvh"},"roles":[{"start":0,"end":10,"active":"b"}]}]})");
  seed("joint_map", "cmu.json", joint_map_json(builtin_joint_maps().front()));
  for (const std::string_view name : preset_names)
    seed("settings", std::string(name) + ".json", settings_json(*preset(name)));
  seed("presets", "one.json",
       fmt::format(R"({{"abrazo_presets":1,"presets":[{{"name":"mine","settings":{}}}]}})",
                   settings_json({})));
  seed("presets", "settings.json", settings_json({}));
  seed(
      "shortcuts", "one.json",
      R"({"abrazo_shortcuts":1,"keys":{"play.play_or_pause":["K","P"],"edit.undo":["5"],"gone.now":["X"],"view.top":7}})");
  Decisions decisions;
  decisions.pinned = 33;
  decisions.vetoes.pairs = {3, 4};
  decisions.vetoes.takes = {"salsa"};
  decisions.meant = IntendedMove{"turn", std::nullopt, 12.5, true};
  seed("decisions", "all.json", decisions_json(decisions));
  FrameResult result;
  result.result = test::facing_pair(0.7);
  result.selected_pair = test::facing_pair(0.8);
  result.query_world = result.result.topRows<joint_count>();
  result.edges = {{0, 1}, {0, 25}};
  result.tetrahedra = {{0, 1, 25, 26}};
  result.candidates.resize(2);
  for (Candidate& candidate : result.candidates) candidate.pair = 1;
  result.selected = 0;
  result.collisions = {{{1, 2}, {26, 27}, 0.02, 0.01}};
  seed("trace", "two.jsonl",
       trace_header_line({"lib.h5", "walk.bvh", 15, {}}) + "\n" +
           trace_frame_line(result, *test::small_library(), 0, 0) + "\n");
  const Sweep sweep{"dance", {}, {"alpha", {"0", "1"}}, {"neighbours", {"5"}}, "moves.rate"};
  seed("sweep_shard", "two.json", shard_json(sweep, {1, 1}, {{{"moves.rate", 0.5}}, {}}));
  const fs::path camera = root / "camera.json";
  (void)write_camera({guessed_intrinsics(640, 480), {}}, camera);
  seed("camera", "one.json", content_of(camera));
  seed("intrinsics", "one.json", content_of(camera));
  fs::remove(camera);
  seed("intrinsics", "one.yml",
       "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   "
       "cols: 3\n   dt: d\n"
       "   data: [ 500., 0., 320., 0., 500., 240., 0., 0., 1. ]\ndistortion_coefficients: !!opencv-matrix\n  "
       " rows: 1\n   cols: 5\n"
       "   dt: d\n   data: [ 0.1, -0.2, 0., 0., 0. ]\n");
  seed("intrinsics", "one.xml",
       "<?xml "
       "version=\"1.0\"?>\n<opencv_storage>\n<image_width>640</image_width>\n<image_height>480</"
       "image_height>\n"
       "<camera_matrix type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt><data>500. 0. 320. 0. "
       "500. 240. 0. 0. 1.</data>"
       "</camera_matrix>\n</opencv_storage>\n");
  const std::string deep(30'000, '[');
  for (const char* target : {"manifest", "joint_map", "settings", "presets", "shortcuts", "decisions",
                             "trace", "sweep_shard", "camera", "tier_json", "intrinsics"})
    seed(target, "deep", deep);
  seed("presets", "deep_preset",
       R"({"abrazo_presets":1,"presets":[{"name":"a","settings":)" + deep + std::string(30'000, ']') + "}]}");
  seed("shortcuts", "deep_keys",
       R"({"abrazo_shortcuts":1,"keys":{"edit.undo":)" + deep + std::string(30'000, ']') + "}}");
  for (const char* words :
       {"vmc://0.0.0.0:39539?performer=Ana&delay=20&map=unity&up=z&unit=cm&floor=0.1",
        "natnet://127.0.0.1?multicast=239.255.42.99&coordinates=local", "xsens://:9763", "clip:walk.bvh",
        "1:02:03", "00:00:11:15", "+250 ms", "alpha=0:1:5", "velocity-weight=log:0.01:1:5",
        "edge-weights=inverse,uniform", "2/8", "3.1", "239.255.42.99", "joint-map"})
    seed("words", fmt::format("{:016x}", std::hash<std::string_view>()(words)), words);
  for (const char* word : {"29.97", "1280x720", "30,-15", "front", "frame_%05d.png", "film.mp4", "1.80,1.66"})
    seed("options", fmt::format("{:016x}", std::hash<std::string_view>()(word)), word);
}

/// What a session remembers of the view.
void write_views() {
  seed("view_text", "usual_panes", widgets::text_of(widgets::default_arrangement()));
  std::string all;
  for (const widgets::SeriesInfo& info : widgets::all_series()) all += std::string(info.key) + ";";
  seed("view_text", "all_series", all);
  widgets::TimelineLanes lanes;
  for (const char* tier : {"notes", "left|right", "50 %"}) lanes.set_tier_shown(tier, false);
  seed("view_text", "lanes", lanes.text());
  seed(
      "view_json", "layout.json",
      R"({"abrazo_layout":1,"docks":"AAAA/wAAAAD9","known":["scene","plots"],"shown":["plots"],"left":true,"right":null,)"
      R"("below":false,"timeline_height":230})");
  seed(
      "view_json", "markers.json",
      R"([{"id":1,"time_s":0.5,"name":"clap"},{"id":1,"time_s":-1e300},{"id":2147483647,"time_s":2,"name":"\ud800"}])");
  seed(
      "view_json", "scene.json",
      R"({"shown":{"user":true,"trails":false},"colour_by":"weight","shortest_edge_m":0.1,"longest_edge_m":2.5,"apart":1,)"
      R"("trail_s":3,"map":"cividis","logarithmic":true,"parallel":false,"mouse":"maya","reference_beside":true})");
  seed("view_json", "camera", "3.5 -0.12");
  seed("view_json", "no_camera", "nan inf");
  seed("view_json", "deep", std::string(30'000, '['));
}

// ---- streams ----

std::vector<std::uint8_t> frames_of(StreamEncoder& encoder, int count) {
  std::vector<std::uint8_t> stream;
  for (int f = 0; f < count; ++f)
    for (const auto& packet :
         encoder.packets({test::moved(test::standing_pose(), 0.1 * f, {}), f / 60.0, true}))
      add_packet(stream, packet, 8);
  return stream;
}

void write_streams() {
  const Body body = body_of(test::standing_pose());
  for (const char* scheme : {"vmc", "xsens"}) {
    const auto uri = parse_stream_uri(std::string(scheme) + "://127.0.0.1:5000");
    auto encoder = make_stream_encoder(*uri, body);
    seed(scheme, "two_frames", frames_of(**encoder, 2));
    seed(scheme, "five_frames", frames_of(**encoder, 5));
  }
  for (const char* version : {"3.0", "3.1", "4.0", "4.1"}) {
    const auto uri = parse_stream_uri(fmt::format("natnet://127.0.0.1?version={}", version));
    auto encoder = make_stream_encoder(*uri, body);
    auto decoder = make_stream_decoder(*parse_stream_uri("natnet://127.0.0.1"));
    std::vector<std::uint8_t> stream;
    Decoded asked;
    for (int round = 0; round < 4; ++round) {
      (*decoder)->pass_time(1 + round, asked);
      for (const OutgoingDatagram& question : std::exchange(asked.replies, {})) {
        std::vector<OutgoingDatagram> answers;
        (*encoder)->answer({{0x7f000001, 50000}, 1.0 + round, question.bytes}, answers);
        for (const OutgoingDatagram& answer : answers) {
          add_packet(stream, answer.bytes, 10);
          (*decoder)->take({{0x7f000001, 1510}, 1.0 + round, answer.bytes}, asked);
        }
      }
    }
    const auto frames = frames_of(**encoder, 2);
    stream.insert(stream.end(), frames.begin(), frames.end());
    seed("natnet", version, stream);
  }
}

// ---- binary files ----

void write_databases() {
  std::vector<PairedTake> takes{test::swinging_take("first", 4, 1)};
  const fs::path file = root / "library.h5";
  expect(write_library(*build_library("small", std::move(takes), {}, {}), file).ok(), "no library");
  for (const char* target : {"library", "mapped_library"}) seed(target, "four_pairs.h5", content_of(file));
  fs::remove(file);
  seed("session_file", "whole.abrazo", session_template());
  seed("session_state", "state", frame_template().state);
  seed("session_rows", "some",
       std::vector<std::uint8_t>{3, 0, 3, 2, 'a', 'b', 17, 0, 1, 1, 0xff, 25, 0, 0x80, 0});
  const std::vector<std::uint8_t> mp4{0,   0,   0, 16, 'f', 't', 'y', 'p', 'i', 's', 'o',
                                      'm', 0,   0, 0,  1,   0,   0,   0,   16,  'm', 'o',
                                      'o', 'v', 0, 0,  0,   8,   't', 'r', 'a', 'k'};
  seed("video_kind", "small.mp4", mp4);
  seed("video_kind", "small.mkv", "\x1a\x45\xdf\xa3\x84webm");
}

void write_all() {
  write_tables();
  write_c3d();
  write_numpy();
  write_scenes();
  write_labels();
  write_json();
  write_views();
  write_streams();
  write_databases();
  for (const char* format : {"bvh", "c3d", "trc", "point_csv", "amc", "asf", "numpy"})
    for (const fs::directory_entry& entry : fs::directory_iterator(root / format))
      if (entry.file_size() < 5000)
        seed("motion_format", entry.path().filename().string(), content_of(entry.path()));
}

}  // namespace
}  // namespace abrazo::fuzz

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "abrazo_fuzz_seeds FOLDER, run in the folder of the sources\n");
    return 2;
  }
  abrazo::fuzz::root = argv[1];
  abrazo::fuzz::write_all();
}
