// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;

// The surface, cut open along so many seams that its map overlaps itself
Mesh cut_open(Mesh& surface)
{
  const auto seams = surface.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  TA::Seam_options seam_options;
  seam_options.stretch_bound = 1.05;
  Mesh chart;
  if(const auto report = TA::select_seams(surface, seams, seam_options); !report)
    std::cerr << report.message << "\n";
  else if(const auto opened = TA::make_seam_mesh(surface, seams); !opened)
    std::cerr << opened.message << "\n";
  else
    CGAL::copy_face_graph(opened.mesh, chart);
  return chart; // without faces if anything is wrong
}

bool flatten(const std::string& name, Mesh& chart, const SMP::Hierarchical_options& options)
{
  const Mesh::Halfedge_index border = PMP::longest_border(chart).first;
  const auto uv = chart.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  if(SMP::parameterize(chart, parameterizer, border, uv) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return false;
  }
  const auto measures = SMP::measure_flattening(chart, border, uv);
  std::cout << name << ": energy " << measures.angular_distortion << ", symmetric Dirichlet energy "
            << measures.symmetric_dirichlet_energy << ", contact " << parameterizer.report().contact
            << (SMP::is_injective(chart, uv) ? ", injective\n" : ", overlaps itself\n");
  return true;
}

int main(int argc, char* argv[])
{
  Mesh surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", surface)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  Mesh chart = cut_open(surface);
  if(faces(chart).empty())
    return 1;
  std::cout.precision(3);

  SMP::Hierarchical_options options;
  bool succeeds = flatten("free", chart, options);
  options.injective = true;
  succeeds = flatten("injective", chart, options) && succeeds;
  options.area_weight = 1; // as isometric as possible
  succeeds = flatten("isometric", chart, options) && succeeds;
  return succeeds ? 0 : 1;
}
