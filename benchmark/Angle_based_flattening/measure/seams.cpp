// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "subcommands.h"
#include "terminal_choices.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>

namespace ABF_benchmark {

namespace {

namespace TA = CGAL::Texture_atlas;

void read_connected_mesh(const std::string& file, Mesh& mesh)
{
  read_mesh(file, mesh);
  const auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  if(CGAL::Polygon_mesh_processing::connected_components(mesh, component) != 1)
    throw std::runtime_error("the mesh is not connected");
}

// Returns the number of terminals.
std::size_t choose_seams(const Mesh& mesh, Seam_map seams, const std::string& choice,
                         const Seam_choice_options& options)
{
  if(choice == "cones") {
    TA::Seam_options seam_options;
    seam_options.stretch_bound = options.bound;
    const auto report = TA::select_seams(mesh, seams, seam_options);
    check(report);
    return report.number_of_terminals;
  }
  if(choice == "random") {
    std::mt19937 random(1);
    const std::size_t number =
        (std::min)(static_cast<std::size_t>(options.terminals), std::size_t(mesh.number_of_vertices()));
    std::set<Mesh::Vertex_index> terminals;
    while(terminals.size() < number)
      terminals.insert(Mesh::Vertex_index(static_cast<unsigned>(random() % mesh.number_of_vertices())));
    check(TA::cut_to_disks(
        mesh, seams,
        CGAL::parameters::vertex_is_constrained_map(CGAL::make_boolean_property_map(terminals))));
    return terminals.size();
  }
  Terminal_choice others(mesh, seams);
  if(choice == "farthest")
    others.add_farthest_points(options.terminals);
  else if(choice == "peaks")
    others.add_curvature_peaks(options.terminals);
  else
    throw std::runtime_error("there is no choice of seams '" + choice + "'");
  return static_cast<std::size_t>(options.terminals);
}

// With no terminals to be added, `select_seams()` adds nothing to a disk, but says what it predicts.
auto predict(const Mesh& mesh, Seam_map seams)
{
  TA::Seam_options options;
  options.maximum_number_of_terminals = 0;
  const auto report = TA::select_seams(mesh, seams, options);
  check(report);
  return report;
}

} // namespace

void seams(const std::string& choice, const std::string& file, const Seam_choice_options& options,
           Measurement& m)
{
  Mesh mesh;
  read_connected_mesh(file, mesh);
  const Seam_map is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  std::size_t terminals = 0;
  m.add("triangles", mesh.number_of_faces());
  m.add("choice_seconds", seconds_of([&] { terminals = choose_seams(mesh, is_seam, choice, options); }));
  m.add("terminals", terminals);
  if(const auto cut = TA::is_disk_cut(mesh, is_seam); !cut)
    return m.fail("the seams leave no disk: " + cut.message);
  if(choice == "random")
    return;
  const auto report = predict(mesh, is_seam);
  m.add("seam", report.relative_seam_length);
  m.add("predicted", report.predicted_stretch);

  Surface surface;
  const auto opened = TA::make_seam_mesh(mesh, is_seam).mesh;
  CGAL::copy_face_graph(opened, surface.mesh);
  surface.border = CGAL::Polygon_mesh_processing::longest_border(surface.mesh).first;
  surface.uv = surface.mesh.add_property_map<Mesh::Vertex_index, abf::Chart::Point_2>("v:uv", {0, 0}).first;
  flatten(options.method, surface, {}, m);
}

} // namespace ABF_benchmark
