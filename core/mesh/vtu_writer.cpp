#include "core/mesh/vtu_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/base/text.hpp"
#include "core/base/xml_text.hpp"

namespace abrazo {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int vtk_line = 3, vtk_tetrahedron = 10;

/// The body of an array: numbers with blanks between, a line for each row of `columns`.
class ArrayText {
 public:
  explicit ArrayText(std::size_t columns = 10) : columns_(columns) {}
  void add(double value) { add(std::isnan(value) ? std::string("nan") : exact_text(value)); }
  void add(int value) { add(std::to_string(value)); }
  const std::string& text() const { return text_; }

 private:
  void add(const std::string& word) {
    if (count_ > 0) text_ += count_ % columns_ == 0 ? '\n' : ' ';
    text_ += word;
    ++count_;
  }
  std::size_t columns_;
  std::size_t count_ = 0;
  std::string text_;
};

std::string array(const std::string& name, const char* type, const ArrayText& values, int components = 1) {
  std::string text = std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" format=\"ascii\"";
  if (components > 1) text += " NumberOfComponents=\"" + std::to_string(components) + '"';
  return text + ">\n" + values.text() + "\n</DataArray>\n";
}

double length(const PairPose& pair, const MeshEdge& edge) {
  return (pair.row(edge[0]) - pair.row(edge[1])).norm();
}

std::string point_arrays(const MeshFrame& frame) {
  ArrayText body(joint_count), joint(joint_count), displacement(3);
  for (int v = 0; v < pair_vertex_count; ++v) {
    body.add(v < joint_count ? 0 : 1);
    joint.add(v % joint_count);
    for (int axis = 0; axis < 3; ++axis)
      displacement.add(frame.positions(v, axis) - frame.reference(v, axis));
  }
  return "<PointData>\n" + array("body", "Int32", body) + array("joint", "Int32", joint) +
         array("displacement", "Float64", displacement, 3) + "</PointData>\n";
}

bool joins_bodies(const MeshTetrahedron& tetrahedron) {
  return std::any_of(tetrahedron.begin(), tetrahedron.end(), [](int v) { return v < joint_count; }) &&
         std::any_of(tetrahedron.begin(), tetrahedron.end(), [](int v) { return v >= joint_count; });
}

std::string cell_arrays(const MeshFrame& frame) {
  ArrayText kind, inter, weight, residual, long_m, change, volume, ratio;
  for (const MeshTetrahedron& tetrahedron : frame.tetrahedra) {
    const double now = six_volumes(frame.positions, tetrahedron) / 6;
    const double before = six_volumes(frame.reference, tetrahedron) / 6;
    kind.add(0), inter.add(joins_bodies(tetrahedron) ? 1 : 0);
    weight.add(none), residual.add(none), long_m.add(none), change.add(none);
    volume.add(now), ratio.add(before == 0 ? none : now / before);
  }
  for (std::size_t e = 0; e < frame.edges.size(); ++e) {
    kind.add(1), inter.add(is_inter_body(frame.edges[e]) ? 1 : 0);
    weight.add(frame.edge_weights[e]), residual.add(frame.edge_residuals_m[e]);
    const double now = length(frame.positions, frame.edges[e]);
    long_m.add(now), change.add(now - length(frame.reference, frame.edges[e]));
    volume.add(none), ratio.add(none);
  }
  return "<CellData>\n" + array("kind", "Int32", kind) + array("inter_body", "Int32", inter) +
         array("weight", "Float64", weight) + array("residual", "Float64", residual) +
         array("length", "Float64", long_m) + array("length_change", "Float64", change) +
         array("volume", "Float64", volume) + array("volume_ratio", "Float64", ratio) + "</CellData>\n";
}

std::string points(const MeshFrame& frame) {
  ArrayText values(3);
  for (int v = 0; v < pair_vertex_count; ++v)
    for (int axis = 0; axis < 3; ++axis) values.add(frame.positions(v, axis));
  return "<Points>\n" + array("Points", "Float64", values, 3) + "</Points>\n";
}

std::string cells(const MeshFrame& frame) {
  ArrayText connectivity, offsets, types;
  int end = 0;
  const auto add = [&](const auto& vertices, int type) {
    for (const int vertex : vertices) connectivity.add(vertex);
    offsets.add(end += static_cast<int>(vertices.size()));
    types.add(type);
  };
  for (const MeshTetrahedron& tetrahedron : frame.tetrahedra) add(tetrahedron, vtk_tetrahedron);
  for (const MeshEdge& edge : frame.edges) add(edge, vtk_line);
  return "<Cells>\n" + array("connectivity", "Int32", connectivity) + array("offsets", "Int32", offsets) +
         array("types", "UInt8", types) + "</Cells>\n";
}

/// VTK and ParaView take the frame's time from this field.
std::string time_field(double time_s) {
  return "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
         "format=\"ascii\">\n" +
         exact_text(time_s) + "\n</DataArray>\n</FieldData>\n";
}

std::string vtk_file(const char* type, const std::string& content) {
  return std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"") + type +
         "\" version=\"1.0\" byte_order=\"LittleEndian\">\n" + content + "</VTKFile>\n";
}

}  // namespace

std::string write_vtu(const MeshFrame& frame) {
  if (frame.edge_weights.size() != frame.edges.size() || frame.edge_residuals_m.size() != frame.edges.size())
    throw std::invalid_argument("every edge of a mesh has a weight and a residual");
  const std::size_t cell_count = frame.edges.size() + frame.tetrahedra.size();
  return vtk_file("UnstructuredGrid", "<UnstructuredGrid>\n" + time_field(frame.time_s) +
                                          "<Piece NumberOfPoints=\"" + std::to_string(pair_vertex_count) +
                                          "\" NumberOfCells=\"" + std::to_string(cell_count) + "\">\n" +
                                          point_arrays(frame) + cell_arrays(frame) + points(frame) +
                                          cells(frame) + "</Piece>\n</UnstructuredGrid>\n");
}

std::string write_pvd(std::span<const SeriesFile> files) {
  std::string text = "<Collection>\n";
  for (const SeriesFile& file : files)
    text += "<DataSet timestep=\"" + exact_text(file.time_s) + "\" part=\"0\" file=\"" + xml_text(file.name) +
            "\"/>\n";
  return vtk_file("Collection", text + "</Collection>\n");
}

}  // namespace abrazo
