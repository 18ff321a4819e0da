// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A target of libFuzzer: makes a mesh of bytes and flattens it. For every mesh, the result must be a map that passes
// the exact certificate, or an error with a reason and an unchanged map.

#include "bytes.h"
#include "meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace fuzz {

namespace SMP = CGAL::Surface_mesh_parameterization;

typedef SMP::ABF_plus_plus_report Report;
typedef SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh> Hierarchical_parameterizer;
typedef Mesh::Halfedge_index Halfedge;

void require(bool condition, const std::string& what)
{
  if(condition)
    return;
  std::cerr << "FAULT: " << what << std::endl;
  std::abort();
}

template <typename UVmap>
void require_valid(const Mesh& mesh, Halfedge border, UVmap uv)
{
  std::vector<Mesh::Face_index> flipped;
  SMP::flipped_faces(mesh, border, uv, std::back_inserter(flipped));
  require(flipped.empty(), "OK with flipped triangles");
}

template <typename AnyReport>
void require_consistent(const AnyReport& report, SMP::Error_code code)
{
  const std::set<SMP::Error_code> documented{SMP::OK,
                                             SMP::ERROR_EMPTY_MESH,
                                             SMP::ERROR_NO_TOPOLOGICAL_DISC,
                                             SMP::ERROR_NO_1_TO_1_MAPPING,
                                             SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,
                                             SMP::ERROR_WRONG_PARAMETER};
  require(documented.count(code) == 1, "a code not documented for triangles: " + std::to_string(code));
  require(error_code(report.status) == code, "another error code in the report");
  require((report.status == SMP::Diagnosis::NOTHING_WRONG) == (code == SMP::OK),
          "a diagnosis that contradicts the code");
  require(report.message.empty() == (code == SMP::OK), "a message that contradicts the code");
  require(code != SMP::OK || report.flipped_triangles == 0, "OK, and flipped triangles in the report");
  require(code != SMP::OK || report.smallest_angle >= 0,
          "OK, and a smallest angle below zero or not a number");
}

// Uses maps whose points are of `MapKernel`.
template <typename MapKernel, typename Parameterizer>
Diagnosis flatten(Mesh& mesh, Halfedge border, Parameterizer parameterizer)
{
  typedef typename MapKernel::Point_2 Point_2;
  const Point_2 untouched(-17, 42);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv", untouched).first;
  const SMP::Error_code code = // not by the free function, which refuses a mesh without faces
      parameterizer.parameterize(mesh, border, uv, get(boost::vertex_index, mesh), nullptr);
  require_consistent(parameterizer.report(), code);
  if(code == SMP::OK)
    require_valid(mesh, border, uv);
  else
    for(const Mesh::Vertex_index v : mesh.vertices())
      require(uv[v] == untouched, "an error, and the map was changed");
  mesh.remove_property_map(uv);
  return parameterizer.report().status;
}

// Whether this was found before any computation, so all methods must find it.
bool is_about_input(Diagnosis diagnosis)
{
  return diagnosis != SMP::Diagnosis::NOTHING_WRONG && diagnosis != SMP::Diagnosis::LINEAR_SYSTEM_FAILED &&
         diagnosis != SMP::Diagnosis::NO_CONVERGENCE && diagnosis != SMP::Diagnosis::SCALE_TOO_LARGE &&
         diagnosis != SMP::Diagnosis::FLIPPED_TRIANGLES && diagnosis != SMP::Diagnosis::PRECISION_EXCEEDED;
}

// Mostly a border, if there is one.
struct Border_choice
{
  explicit Border_choice(Bytes& bytes) : kind(bytes.byte()), first(bytes.byte()) {}

  Halfedge operator()(const Mesh& mesh) const
  {
    const Mesh::size_type halfedges = 2 * mesh.number_of_edges();
    if(halfedges == 0 || kind == 255)
      return Mesh::null_halfedge();
    Mesh::size_type h = first % halfedges;
    for(Mesh::size_type n = 0; n < halfedges && kind < 250 && !mesh.is_border(Halfedge(h)); ++n)
      h = (h + 1) % halfedges;
    return Halfedge(h);
  }

  int kind;
  Mesh::size_type first;
};

struct Options
{
  explicit Options(Bytes& bytes)
  {
    typedef SMP::ABF_plus_plus_options Direct;
    const int bits = bytes.byte(), more_bits = bytes.byte();
    direct.holes = hierarchical.holes = Direct::Holes((more_bits >> 5) % 3);
    direct.linear_solver = bits & 2 ? Direct::DIRECT : Direct::ITERATIVE;
    direct.step = bits & 4 ? Direct::SEQUENTIAL_LINEARLY_CONSTRAINED : Direct::NEWTON;
    direct.layout = Direct::Layout_type((bits >> 3) % 3);
    direct.barrier = bits & 128 ? 0 : 0.1;
    direct.max_iterations = more_bits & 1 ? 2 : 20;
    floats = more_bits & 2;
    hierarchical.polish = more_bits & 4;
    hierarchical.polish_options = direct;
    hierarchical.simplification_rate = more_bits & 8 ? 0.5 : 0.95;
    hierarchical.coarse_triangles = more_bits & 16 ? 1 : 0;
    hierarchical.threads = 1;
  }

  SMP::ABF_plus_plus_options direct;
  SMP::Hierarchical_options hierarchical;
  bool floats; // in the maps of the direct method
};

void flatten(Mesh& mesh, Halfedge border, const Options& options)
{
  const SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options.direct);
  const Diagnosis direct = options.floats
                               ? flatten<CGAL::Simple_cartesian<float>>(mesh, border, parameterizer)
                               : flatten<Kernel>(mesh, border, parameterizer);
  const Hierarchical_parameterizer hierarchical_parameterizer(
      options.hierarchical, Hierarchical_parameterizer::Coarse_parameterizer(options.direct));
  const Diagnosis hierarchical = flatten<Kernel>(mesh, border, hierarchical_parameterizer);
  require(direct == hierarchical || !(is_about_input(direct) || is_about_input(hierarchical)),
          "the methods differ in what is wrong with the input");
}

} // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  using namespace fuzz;
  Bytes bytes(data, size);
  const bool soup = bytes.below(4) == 0;
  const Options options(bytes);
  const Border_choice choose_border(bytes);
  Mesh mesh = soup ? mesh_of_soup(bytes) : mesh_of_operations(bytes);
  const Halfedge border = choose_border(mesh);
  flatten(mesh, border, options);
  return 0;
}
