// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `select_cones()` for any mesh: reads surface and options, and names the vertices that are cones. Called by
// `select_cones.h` and `cone_flattener.h`. `choose_cones()` does the work, without the caller's types; the definition
// is in `choose_cones_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/Cone_selection.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline constexpr std::size_t largest_number_of_cones = 1000;

// Vertices of a connected surface, and the sums of their planar angles, if nothing is wrong
struct Chosen_cones
{
  Diagnosis status = Diagnosis::NOTHING_WRONG;
  std::string message;
  std::vector<int> offending_vertices;
  std::vector<int> vertices;
  std::vector<double> angles; // of each of them
  double predicted_stretch = 1;
};

// The number of quanta of a full turn, or 0 if it is no whole number
inline int quanta_of_turn(double quantum)
{
  const double quanta = std::round(2 * pi / quantum);
  return quanta >= 1 && quanta <= 1e6 && std::abs(quanta * quantum - 2 * pi) <= 1e-9
             ? static_cast<int>(quanta)
             : 0;
}

// What is wrong with the options, or nothing
inline std::string wrong_option(std::size_t number_of_cones, const Cone_options& options)
{
  if(number_of_cones > largest_number_of_cones)
    return std::to_string(number_of_cones) + " cones are too many: the limit is " +
           std::to_string(largest_number_of_cones);
  if(options.angle_multiple != 0 && quanta_of_turn(options.angle_multiple) == 0)
    return "2 pi is not a multiple of the angle " + std::to_string(options.angle_multiple);
  if(options.angle_multiple != 0 && options.angles == Cone_angles::FREE)
    return "free angles of cones cannot be multiples of an angle";
  return wrong_option(options.parameterizer);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Chosen_cones choose_cones(const Chart& surface,
                                                             std::size_t number_of_cones,
                                                             const Cone_options& options,
                                                             const Linear_solvers& solvers);

// The vertex of the mesh that each vertex of the only part of a surface is
template <typename TriangleMesh, typename Reader>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
vertices_of_surface(const TriangleMesh& mesh, const Reader& reader)
{
  const Chart& surface = reader.parts().front().chart;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> result(surface.points.size());
  for(int c = 0; c < surface.number_of_corners(); ++c)
    result[surface.vertex[c]] = target(reader.halfedge_to(c), mesh);
  return result;
}

// A vertex of the mesh that is several vertices of the surface, not all of them on the border; or -1
template <typename VertexDescriptor>
int find_pinched_vertex(const Chart& surface, const std::vector<VertexDescriptor>& vertices)
{
  std::map<VertexDescriptor, int> number;
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    if(const auto [found, is_new] = number.insert({vertices[v], v});
       !is_new && (surface.interior[v] >= 0 || surface.interior[found->second] >= 0))
      return v;
  return -1;
}

inline bool is_sphere_or_disk(const Chart& surface)
{
  return euler_characteristic(surface) + static_cast<int>(surface.borders.size()) == 2 &&
         surface.borders.size() < 2;
}

template <typename TriangleMesh, typename NamedParameters>
Cone_selection<TriangleMesh> select_cones_of_mesh(const TriangleMesh& mesh, std::size_t n,
                                                  const Cone_options& options, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef Cone_selection<TriangleMesh> Selection;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;

  Selection selection;
  const auto fail = [&](Diagnosis diagnosis, const std::string& message) {
    selection.status = diagnosis;
    selection.message = message;
    return selection;
  };
  if(const std::string message = wrong_option(n, options); !message.empty())
    return fail(Diagnosis::WRONG_OPTION, message);

  Surface_reader<TriangleMesh, Vertex_point_map, Selection> reader(
      mesh,
      choose_parameter(get_parameter(np, internal_np::vertex_point),
                       get_const_property_map(CGAL::vertex_point, mesh)),
      given_numbers<TriangleMesh>(np));
  if(!reader.read([](const auto&) { return false; }, selection))
    return selection;
  if(reader.parts().size() > 1) {
    const Surface_part& second = reader.parts()[1];
    selection.offending_faces = {reader.face_of(second.first_triangle)};
    return fail(Diagnosis::SEVERAL_COMPONENTS, "the surface is not connected: the face at " +
                                                   vertex_text(second.chart, second.chart.vertex.front()) +
                                                   " belongs to a second component");
  }
  const Chart& surface = reader.parts().front().chart;
  const auto vertices = vertices_of_surface(mesh, reader);
  if(const int pinched = find_pinched_vertex(surface, vertices); pinched >= 0) {
    selection.offending_vertices = {vertices[pinched]};
    return fail(Diagnosis::NON_MANIFOLD_VERTEX,
                vertex_text(surface, pinched) + " is surrounded by faces, and also belongs to other faces");
  }
  if(options.angle_multiple > 0 && !is_sphere_or_disk(surface))
    return fail(Diagnosis::WRONG_TOPOLOGY,
                "the angles of cones can be multiples of an angle only on a sphere or a disk");

  const Chosen_cones chosen = choose_cones(surface, n, options, linear_solvers(np));
  for(int v : chosen.offending_vertices)
    selection.offending_vertices.push_back(vertices[v]);
  for(std::size_t i = 0; i < chosen.vertices.size(); ++i)
    selection.cones.emplace_back(vertices[chosen.vertices[i]], chosen.angles[i]);
  selection.predicted_stretch = chosen.predicted_stretch;
  return fail(chosen.status, chosen.message);
}

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/cones/choose_cones_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_H
