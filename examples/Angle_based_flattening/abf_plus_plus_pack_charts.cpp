// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/select_seams.h>
#include <CGAL/Surface_mesh_parameterization/split_overlaps.h>

#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Surface::Halfedge_index;
namespace SMP = CGAL::Surface_mesh_parameterization;
using Mesh = SMP::Cut_mesh<Surface>;

template <typename UV_map>
void write_obj(std::ostream& out, const Surface& surface, UV_map uv)
{
  out.precision(17);
  for(auto v : vertices(surface))
    out << "v " << surface.point(v) << "\n";
  for(auto h : halfedges(surface))
    out << "vt " << uv[h] << "\n";
  for(auto f : faces(surface)) {
    out << "f";
    for(auto h : halfedges_around_face(halfedge(f, surface), surface))
      out << " " << surface.target(h).idx() + 1 << "/" << h.idx() + 1;
    out << "\n";
  }
}

int main(int argc, char* argv[])
{
  Surface surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", surface)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  const auto seams = surface.add_property_map<Surface::Edge_index, bool>("e:seam", false).first;
  const SMP::Seam_report cut = SMP::select_seams(surface, seams, CGAL::parameters::stretch_bound(1.05));
  if(cut.diagnosis != cut.NOTHING_WRONG) {
    std::cerr << cut.message << "\n";
    return 1;
  }
  const auto uv_of_seam_mesh = surface.add_property_map<Halfedge, Kernel::Point_2>("h:uv", {0, 0}).first;
  Mesh mesh = SMP::make_seam_mesh(surface, seams);
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  if(SMP::parameterize(mesh, parameterizer, SMP::border_halfedge(mesh), uv_of_seam_mesh) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return 1;
  }

  // Each corner of a face has coordinates of its own, at the halfedge that leads to it.
  const auto uv = surface.add_property_map<Halfedge, Kernel::Point_2>("h:corner_uv", {0, 0}).first;
  for(auto f : faces(surface))
    for(auto h : halfedges_around_face(halfedge(f, surface), surface))
      uv[h] = uv_of_seam_mesh[target(Mesh::halfedge_descriptor(h), mesh)];

  const auto chart = surface.add_property_map<Surface::Face_index, int>("f:chart").first;
  const SMP::Overlap_split_report split = SMP::split_overlaps(surface, seams, uv, chart);
  if(!split) {
    std::cerr << split.message << "\n";
    return 1;
  }
  const SMP::Packing_report packing =
      SMP::pack_charts(surface, chart, uv, CGAL::parameters::resolution(2048, CGAL::parameters::gutter(4)));
  if(!packing) {
    std::cerr << packing.message << "\n";
    return 1;
  }
  std::cout << packing.number_of_charts << " charts cover " << 100 * packing.covered_share
            << " % of the texture, " << packing.texels_per_length << " texels for a length of 1\n";

  std::ofstream out("abf_plus_plus_pack_charts.obj");
  write_obj(out, surface, uv);
}
