#include "tests/bench/tetgen_mesh.hpp"

#define TETLIBRARY  // TetGen's header declares its library interface under this name only
#include <tetgen.h>

#include <array>

namespace abrazo::bench {

std::vector<MeshTetrahedron> tetgen_tetrahedra(const PairPose& pose) {
  tetgenio in;
  tetgenio out;
  in.numberofpoints = pair_vertex_count;
  in.pointlist = new REAL[3 * pair_vertex_count];  // freed by tetgenio
  for (int v = 0; v < pair_vertex_count; ++v)
    for (int axis = 0; axis < 3; ++axis) in.pointlist[3 * v + axis] = pose(v, axis);
  std::array<char, 2> quiet = {'Q', '\0'};
  ::tetrahedralize(quiet.data(), &in, &out);
  std::vector<MeshTetrahedron> tetrahedra(static_cast<std::size_t>(out.numberoftetrahedra));
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    for (std::size_t corner = 0; corner < 4; ++corner)
      tetrahedra[t][corner] = static_cast<std::uint8_t>(out.tetrahedronlist[4 * t + corner]);
  return tetrahedra;
}

}  // namespace abrazo::bench
