// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MESH_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MESH_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Texture_atlas/internal/atlas/mesh_atlas_builder.h>
#include <CGAL/Texture_atlas/internal/atlas/mesh_in_atlas.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/prepare/Mapped_mesh.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// A copy of any mesh, whose larger polygons are divided into triangles
template <typename PolygonMesh>
class Triangulated_copy : public Mapped_mesh
{
  typedef boost::graph_traits<PolygonMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

public:
  template <typename NamedParameters>
  Triangulated_copy(const PolygonMesh& given, const NamedParameters& np)
      : m_given(given), m_position(vertex_positions(given))
  {
    std::vector<std::pair<vertex_descriptor, Vertex>> vertices;
    std::vector<std::pair<halfedge_descriptor, Halfedge>> halfedges;
    const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                     get_const_property_map(vertex_point, given));
    copy_face_graph(given, mesh,
                    parameters::vertex_point_map(points)
                        .vertex_to_vertex_output_iterator(std::back_inserter(vertices))
                        .halfedge_to_halfedge_output_iterator(std::back_inserter(halfedges)));
    m_vertices.resize(vertices.size());
    for(const auto& [source, copy] : vertices)
      m_vertices[copy.idx()] = source;
    m_halfedges.resize(halfedges.size());
    for(const auto& [source, copy] : halfedges)
      m_halfedges[copy.idx()] = source;
    std::vector<std::size_t> polygon_of_halfedge;
    for(const Halfedge h : mesh.halfedges())
      polygon_of_halfedge.push_back(mesh.face(h).idx());
    m_number_of_polygons = mesh.number_of_faces();
    divide_polygons(surface);
    add_maps();
    for(const Face f : mesh.faces())
      m_polygons.push_back(polygon_of_halfedge[surface.origins.corners[mesh.halfedge(f).idx()]]);
    read_numbers(np);
    read_parameters(np);
  }

  template <typename EdgeIsSeamMap, typename HalfedgeUVMap>
  void read(EdgeIsSeamMap given_seams, HalfedgeUVMap given_uv, const bool keeps_charts)
  {
    if constexpr(!std::is_same<EdgeIsSeamMap, std::nullptr_t>::value)
      for(const Edge e : mesh.edges())
        seams[e] = !is_diagonal(e) && get(given_seams, given_edge(e));
    if constexpr(is_readable<HalfedgeUVMap>)
      for(const Halfedge h : mesh.halfedges())
        if(keeps_charts && !mesh.is_border(h)) {
          const auto& p = get(given_uv, given_halfedge(h));
          uv[h] = Kernel::Point_2(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
        }
  }

  template <typename EdgeIsSeamMap, typename HalfedgeUVMap, typename FaceChartMap>
  void write(EdgeIsSeamMap given_seams, HalfedgeUVMap given_uv, FaceChartMap given_charts) const
  {
    if constexpr(!std::is_same<EdgeIsSeamMap, std::nullptr_t>::value)
      for(const Edge e : mesh.edges())
        if(seams[e] && !is_diagonal(e))
          put(given_seams, given_edge(e), true);
    typedef typename boost::property_traits<HalfedgeUVMap>::value_type Point;
    for(const Halfedge h : mesh.halfedges())
      if(!mesh.is_border(h) && charts[mesh.face(h)] >= 0)
        put(given_uv, given_halfedge(h), planar_point<Point>(Chart::Point_2(uv[h].x(), uv[h].y())));
    if constexpr(!std::is_same<FaceChartMap, std::nullptr_t>::value)
      for(const Face f : mesh.faces())
        put(given_charts, given_face(f),
            static_cast<typename boost::property_traits<FaceChartMap>::value_type>(charts[f]));
  }

  // The descriptors of the given mesh, in place of those of the copy
  template <typename Given_report, typename Report>
  void translate(const Report& report, Given_report& given) const
  {
    for(const Vertex v : report.offending_vertices)
      given.offending_vertices.push_back(m_vertices[v.idx()]);
    for(const Edge e : report.offending_edges)
      given.offending_edges.push_back(given_edge(e));
    for(const Face f : report.offending_faces)
      given.offending_faces.push_back(given_face(f));
  }

  // Counts faces of the given mesh instead of triangles, and its vertices. Returns their descriptors.
  typename Mesh_atlas_report<PolygonMesh>::Part_elements
  translate_part(const Report_on_atlas::Part_elements& elements, Atlas_report::Skipped& part) const
  {
    std::map<std::size_t, face_descriptor> faces; // by their positions
    for(const Face f : elements.faces)
      faces.emplace(m_polygons[f.idx()], given_face(f));
    part.first_face = faces.begin()->first;
    part.number_of_faces = faces.size();
    typename Mesh_atlas_report<PolygonMesh>::Part_elements given;
    for(const auto& [position, f] : faces)
      given.faces.push_back(f);
    part.vertices.clear();
    for(const Vertex v : elements.vertices) {
      given.vertices.push_back(m_vertices[v.idx()]);
      part.vertices.push_back(static_cast<std::size_t>(m_position(given.vertices.back())));
    }
    return given;
  }

private:
  halfedge_descriptor given_halfedge(const Halfedge h) const
  {
    return m_halfedges[surface.origins.corners[h.idx()]];
  }
  edge_descriptor given_edge(const Edge e) const { return edge(m_halfedges[2 * e.idx()], m_given); }
  face_descriptor given_face(const Face f) const { return face(given_halfedge(mesh.halfedge(f)), m_given); }
  bool is_diagonal(const Edge e) const { return e.idx() >= m_halfedges.size() / 2; }

  // For messages
  template <typename NamedParameters>
  void read_numbers(const NamedParameters& np)
  {
    const Vertex_numbers<PolygonMesh> given_number = given_numbers<PolygonMesh>(np),
                                      number = given_number ? given_number : m_position;
    for(const Vertex v : mesh.vertices())
      vertex_numbers[v] = number(m_vertices[v.idx()]);
    for(const Face f : mesh.faces())
      if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::face_index_t>::value)
        face_numbers[f] = static_cast<std::ptrdiff_t>(m_polygons[f.idx()]);
      else
        face_numbers[f] = static_cast<std::ptrdiff_t>(
            get(parameters::get_parameter(np, internal_np::face_index), given_face(f)));
  }

  template <typename NamedParameters>
  void read_parameters(const NamedParameters& np)
  {
    using parameters::get_parameter;
    using parameters::is_default_parameter;
    const auto constrained =
        parameters::choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                     Static_boolean_property_map<edge_descriptor, false>());
    for(const Edge e : mesh.edges()) {
      is_constrained[e] = is_diagonal(e) || get(constrained, given_edge(e));
      const Kernel::Vector_3 side(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
      weights[e] = std::hypot(side.x(), side.y(), side.z()); // whose squares may be too large
      if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_weight_t>::value)
        if(!is_diagonal(e))
          weights[e] = CGAL::to_double(get(get_parameter(np, internal_np::edge_weight), given_edge(e)));
    }
    Disjoint_sets sets(m_number_of_polygons);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::face_patch_t>::value) {
      const auto patches = get_parameter(np, internal_np::face_patch);
      for(const Edge e : mesh.edges()) {
        const Face f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
        if(!mesh.is_border(e) && get(patches, given_face(f)) == get(patches, given_face(g)))
          sets.union_set(m_polygons[f.idx()], m_polygons[g.idx()]);
      }
    }
    for(const Face f : mesh.faces()) {
      polygons[f] = sets.find_set(m_polygons[f.idx()]);
      if constexpr(!is_default_parameter<NamedParameters, internal_np::face_size_map_t>::value)
        sizes[f] = CGAL::to_double(get(get_parameter(np, internal_np::face_size_map), given_face(f)));
    }
  }

  const PolygonMesh& m_given;
  const Vertex_numbers<PolygonMesh> m_position; // in the sequence of vertices
  std::size_t m_number_of_polygons = 0;
  std::vector<std::size_t> m_polygons;          // of each triangle of the copy: the position of its polygon
  std::vector<vertex_descriptor> m_vertices;    // of each vertex of the copy
  std::vector<halfedge_descriptor> m_halfedges; // of each halfedge of the copy that is no diagonal's
};

} // namespace CGAL::Texture_atlas::internal::prepare

namespace CGAL::Texture_atlas::internal {

template <typename Range>
using Element_of = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

template <typename Range>
std::size_t size_of(const Range& range)
{
  return static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
}

namespace prepare {

// One atlas of any meshes, with property maps of each. Polygons are divided in copies.
template <typename MeshRange, typename SeamMaps, typename UVMaps, typename ChartMaps,
          typename NamedParameters>
Mesh_atlas_report<Element_of<MeshRange>>
make_atlas_of_polygon_meshes(const MeshRange& meshes, const SeamMaps& seams, const UVMaps& uv,
                             const ChartMaps& charts, const Atlas_options& options, const NamedParameters& np)
{
  typedef Element_of<MeshRange> PolygonMesh;
  typedef typename boost::property_traits<Element_of<UVMaps>>::value_type Point;
  Mesh_atlas_report<PolygonMesh> report;
  if(options.given_charts != Atlas_options::REPLACE && !is_readable<Element_of<UVMaps>>) {
    report.status = Diagnosis::WRONG_OPTION;
    report.message = unreadable_text;
    return report;
  }
  std::deque<Triangulated_copy<PolygonMesh>> copies;
  std::vector<Mapped_mesh*> pointers;
  auto seam_map = std::begin(seams);
  auto uv_map = std::begin(uv);
  for(const PolygonMesh& mesh : meshes) {
    copies.emplace_back(mesh, np);
    copies.back().read(*seam_map++, *uv_map++, options.given_charts != Atlas_options::REPLACE);
    pointers.push_back(&copies.back());
  }
  const Report_on_atlas of_copies =
      make_atlas_of_mapped_meshes(pointers, options, linear_solvers(np), &round_to_points<Point>);
  static_cast<Atlas_report&>(report) = of_copies;
  for(Atlas_report::Skipped& part : report.skipped) {
    const auto i = static_cast<std::size_t>(&part - report.skipped.data());
    report.skipped_elements.push_back(copies[part.mesh].translate_part(of_copies.skipped_elements[i], part));
  }
  if(copies.size() == 1) // elements of several meshes are not named
    copies.front().translate(of_copies, report);
  if(copies.size() == 1 && !report.skipped.empty()) {
    report.offending_faces.clear();
    for(const auto& elements : report.skipped_elements)
      report.offending_faces.push_back(elements.faces.front());
  }
  if(report.has_atlas()) {
    seam_map = std::begin(seams);
    uv_map = std::begin(uv);
    auto chart_map = std::begin(charts);
    for(const auto& copy : copies)
      copy.write(*seam_map++, *uv_map++, *chart_map++);
  }
  return report;
}

} // namespace prepare

// One atlas of meshes, with property maps of each
template <typename MeshRange, typename SeamMaps, typename UVMaps, typename ChartMaps,
          typename NamedParameters>
Mesh_atlas_report<Element_of<MeshRange>> atlas_of_meshes(const MeshRange& meshes, const SeamMaps& seams,
                                                         const UVMaps& uv, const ChartMaps& charts,
                                                         Atlas_options options, const NamedParameters& np)
{
  Check_edge_map<Element_of<MeshRange>, Element_of<SeamMaps>>();
  Check_halfedge_map<Element_of<MeshRange>, Element_of<UVMaps>>();
  Check_face_map<Element_of<MeshRange>, Element_of<ChartMaps>>();
  Visitor_parameter<Atlas_visitor, NamedParameters> visitor(np);
  options.visitor = visitor.pointer(options.visitor);
  for(const auto& mesh : meshes)
    if(!is_triangle_mesh(mesh))
      return prepare::make_atlas_of_polygon_meshes(meshes, seams, uv, charts, options, np);
  Mesh_atlas_builder<Element_of<MeshRange>, Element_of<SeamMaps>, Element_of<UVMaps>, Element_of<ChartMaps>,
                     NamedParameters>
      builder(options, linear_solvers(np));
  auto seam_map = std::begin(seams);
  auto uv_map = std::begin(uv);
  auto chart_map = std::begin(charts);
  for(const auto& mesh : meshes)
    builder.add(mesh, *seam_map++, *uv_map++, *chart_map++, np);
  return builder.run();
}

// Whether a parameter is a map of one mesh, and therefore none of several
template <typename NamedParameters>
inline constexpr bool has_maps_of_a_mesh =
    !(parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::vertex_index_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::face_index_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::edge_weight_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::face_size_map_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value);

template <typename MeshRange, typename SeamMaps, typename UVMaps, typename ChartMaps,
          typename NamedParameters>
Mesh_atlas_report<Element_of<MeshRange>> common_atlas(const MeshRange& meshes, const SeamMaps& seams,
                                                      const UVMaps& uv, const ChartMaps& charts,
                                                      const Atlas_options& options, const NamedParameters& np)
{
  static_assert(!has_maps_of_a_mesh<NamedParameters>, "property maps as named parameters belong to one mesh");
  Mesh_atlas_report<Element_of<MeshRange>> report;
  for(const std::size_t maps : {size_of(seams), size_of(uv), size_of(charts)})
    if(maps != size_of(meshes)) {
      report.status = Diagnosis::WRONG_OPTION;
      report.message = "there are " + std::to_string(size_of(meshes)) + " meshes, but " +
                       std::to_string(maps) + " property maps";
      return report;
    }
  return atlas_of_meshes(meshes, seams, uv, charts, options, np);
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MESH_ATLAS_H
