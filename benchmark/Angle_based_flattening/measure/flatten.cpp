// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "subcommands.h"

#include "../methods/methods.h"

#include <CGAL/Aff_transformation_2.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace ABF_benchmark {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

Method find_method(const std::string& name)
{
  for(const auto& list : {parameterizer_methods(), chart_methods()})
    if(const auto found = list.find(name); found != list.end())
      return found->second;
  throw std::runtime_error("there is no method '" + name + "'");
}

// The component with the longest border
Surface read_surface(const std::string& file)
{
  Surface surface;
  Mesh& mesh = surface.mesh;
  read_mesh(file, mesh);
  const auto longest_border = [&] { return PMP::longest_border(mesh).first; };
  if(longest_border() == Mesh::null_halfedge())
    throw std::runtime_error("the mesh has no border");
  std::vector<Mesh::Face_index> component;
  PMP::connected_component(mesh.face(mesh.opposite(longest_border())), mesh, std::back_inserter(component));
  PMP::keep_connected_components(mesh, component);
  mesh.collect_garbage();
  surface.border = longest_border();
  surface.uv = mesh.add_property_map<Mesh::Vertex_index, abf::Chart::Point_2>("v:uv", {0, 0}).first;
  return surface;
}

// The shear depends on the axes. For small distortions, the root mean square over two pairs of axes at 45 degrees
// equals that over all pairs. It is called the mean shear here.
void measure_map(Surface& surface, Measurement& m)
{
  double area = 0, planar_area = 0, square = 0;
  const auto add_face = [&](Mesh::Face_index, const SMP::Flattening_face_measures& face) {
    area += face.area;
    planar_area += face.area * CGAL::square(face.scale);
    square += face.area / CGAL::square(face.scale);
  };
  const SMP::Flattening_measures measures =
      SMP::measure_flattening(surface.mesh, surface.border, surface.uv, CGAL::parameters::visitor(add_face));
  const CGAL::Aff_transformation_2<abf::Chart::Kernel> turn(CGAL::ROTATION, std::sqrt(0.5), std::sqrt(0.5));
  for(const Mesh::Vertex_index v : surface.mesh.vertices())
    surface.uv[v] = turn(surface.uv[v]);
  const double turned_shear = SMP::measure_flattening(surface.mesh, surface.border, surface.uv).l2_shear;
  m.add("shear", measures.l2_shear);
  m.add("mean_shear", std::sqrt((CGAL::square(measures.l2_shear) + CGAL::square(turned_shear)) / 2));
  m.add("principal_shear", measures.l2_principal_shear);
  m.add("equal_stretch_error", measures.l2_equal_stretch_error);
  m.add("stretch", measures.l2_stretch);
  m.add("scale_stretch", std::sqrt(square * planar_area) / area); // the L2 stretch if no angle changed
  m.add("linf_stretch", measures.linf_stretch);
  m.add("energy", measures.angular_distortion);
  m.add("angle_change", measures.mean_angle_change);
  m.add("corner_angle_change", measures.mean_corner_angle_change);
  m.add("quasi_conformal", measures.mean_quasi_conformal_ratio);
  m.add("area", measures.l2_area_distortion);
  m.add("symmetric_dirichlet", measures.symmetric_dirichlet_energy);
  m.add("flips", measures.flipped_triangles);
  m.add("border_is_simple", measures.border_is_simple);
}

} // namespace

void flatten(const std::string& method, const std::string& file, const SMP::Hierarchical_options& options,
             Measurement& m)
{
  Surface surface = read_surface(file);
  m.add("vertices", surface.mesh.number_of_vertices());
  m.add("triangles", surface.mesh.number_of_faces());
  flatten(method, surface, options, m);
}

void flatten(const std::string& method, Surface& surface, const SMP::Hierarchical_options& options,
             Measurement& m)
{
  find_method(method)(surface, options, m);
  if(m.failed())
    return;
  for(const Mesh::Vertex_index v : surface.mesh.vertices())
    if(!CGAL::is_finite(surface.uv[v].x()) || !CGAL::is_finite(surface.uv[v].y()))
      return m.fail("a coordinate is not finite");
  measure_map(surface, m);
}

} // namespace ABF_benchmark
