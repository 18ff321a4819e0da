// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TRIANGULATED_COPY_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TRIANGULATED_COPY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Texture_atlas/internal/atlas/mesh_in_atlas.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <set>
#include <type_traits>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// A mesh with the property maps that `make_atlas()` takes. `Point` is that of the coordinates.
template <typename Point>
struct Mapped_mesh
{
  Surface_of_model surface;
  Mesh& mesh = surface.mesh;

  Mesh::Property_map<Edge, bool> seams, is_constrained;
  Mesh::Property_map<Edge, double> weights;
  Mesh::Property_map<Halfedge, Point> uv;
  Mesh::Property_map<Face, int> charts;
  Mesh::Property_map<Face, double> sizes;
  Mesh::Property_map<Face, std::size_t> polygons, numbers; // the latter are for messages

  Mapped_mesh() = default;
  Mapped_mesh(const Mapped_mesh&) = delete;
  Mapped_mesh& operator=(const Mapped_mesh&) = delete;

  void add_maps()
  {
    seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
    uv = mesh.template add_property_map<Halfedge, Point>("h:uv").first;
    charts = mesh.add_property_map<Face, int>("f:chart", -1).first;
    is_constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
    weights = mesh.add_property_map<Edge, double>("e:weight", 0).first;
    sizes = mesh.add_property_map<Face, double>("f:size", 1).first;
    polygons = mesh.add_property_map<Face, std::size_t>("f:polygon", 0).first;
    numbers = mesh.add_property_map<Face, std::size_t>("f:number", 0).first;
  }
};

// A copy of any mesh, whose larger polygons are divided into triangles
template <typename PolygonMesh, typename Point>
class Triangulated_copy : public Mapped_mesh<Point>
{
  typedef Mapped_mesh<Point> Base;
  typedef boost::graph_traits<PolygonMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

  using Base::charts;
  using Base::is_constrained;
  using Base::mesh;
  using Base::numbers;
  using Base::polygons;
  using Base::seams;
  using Base::sizes;
  using Base::surface;
  using Base::uv;
  using Base::weights;

public:
  template <typename NamedParameters>
  Triangulated_copy(const PolygonMesh& given, const NamedParameters& np)
      : m_given(given), m_number_of_halfedge(get(dynamic_halfedge_property_t<std::size_t>(), given)),
        m_number_of_face(get(dynamic_face_property_t<std::size_t>(), given))
  {
    copy_graph(parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                            get_const_property_map(vertex_point, given)));
    divide_polygons(this->surface);
    this->add_maps();
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
        if(keeps_charts && !mesh.is_border(h))
          uv[h] = get(given_uv, given_halfedge(h));
  }

  template <typename EdgeIsSeamMap, typename HalfedgeUVMap, typename FaceChartMap>
  void write(EdgeIsSeamMap given_seams, HalfedgeUVMap given_uv, FaceChartMap given_charts) const
  {
    if constexpr(!std::is_same<EdgeIsSeamMap, std::nullptr_t>::value)
      for(const Edge e : mesh.edges())
        if(seams[e] && !is_diagonal(e))
          put(given_seams, given_edge(e), true);
    for(const Halfedge h : mesh.halfedges())
      if(!mesh.is_border(h) && charts[mesh.face(h)] >= 0)
        put(given_uv, given_halfedge(h), uv[h]);
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

  // Counts faces of the given mesh instead of triangles.
  template <typename Skipped>
  void translate_part(Skipped& part) const
  {
    const Face first(static_cast<Mesh::size_type>(part.first_face));
    std::set<std::size_t> faces;
    std::set<Face> triangles = {first};
    for(std::vector<Face> stack = {first}; !stack.empty();) {
      const Face f = stack.back();
      stack.pop_back();
      faces.insert(numbers[f]);
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        const Face next = mesh.face(mesh.opposite(h));
        if(next != Mesh::null_face() && charts[next] < 0 && !seams[mesh.edge(h)] &&
           triangles.insert(next).second)
          stack.push_back(next);
      }
    }
    part.first_face = *faces.begin();
    part.number_of_faces = faces.size();
  }

private:
  halfedge_descriptor given_halfedge(const Halfedge h) const
  {
    return m_halfedges[surface.origins.corners[h.idx()]];
  }
  edge_descriptor given_edge(const Edge e) const { return edge(m_halfedges[2 * e.idx()], m_given); }
  face_descriptor given_face(const Face f) const { return face(given_halfedge(mesh.halfedge(f)), m_given); }
  bool is_diagonal(const Edge e) const { return e.idx() >= m_halfedges.size() / 2; }

  Halfedge copy_of(const halfedge_descriptor h) const
  {
    return Halfedge(static_cast<Mesh::size_type>(get(m_number_of_halfedge, h)));
  }

  template <typename VertexPointMap>
  void copy_graph(const VertexPointMap& points)
  {
    const auto number_of_vertex = get(dynamic_vertex_property_t<std::size_t>(), m_given);
    for(const vertex_descriptor v : vertices(m_given)) {
      put(number_of_vertex, v, m_vertices.size());
      m_vertices.push_back(v);
      const auto& p = get(points, v);
      mesh.add_vertex(
          Kernel::Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
    }
    for(const edge_descriptor e : edges(m_given)) {
      const halfedge_descriptor h = halfedge(e, m_given);
      for(const halfedge_descriptor side : {h, opposite(h, m_given)}) {
        put(m_number_of_halfedge, side, m_halfedges.size());
        m_halfedges.push_back(side);
      }
      mesh.add_edge();
    }
    for(const halfedge_descriptor h : m_halfedges) {
      const Halfedge copy = copy_of(h);
      const Vertex end(static_cast<Mesh::size_type>(get(number_of_vertex, target(h, m_given))));
      mesh.set_target(copy, end);
      mesh.set_next(copy, copy_of(next(h, m_given)));
      if(mesh.halfedge(end) == Mesh::null_halfedge() || CGAL::is_border(h, m_given))
        mesh.set_halfedge(end, copy);
    }
    for(const face_descriptor f : faces(m_given)) {
      put(m_number_of_face, f, m_number_of_faces++);
      const Face copy = mesh.add_face();
      mesh.set_halfedge(copy, copy_of(halfedge(f, m_given)));
      for(const halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_given), m_given))
        mesh.set_face(copy_of(h), copy);
    }
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
      weights[e] =
          std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
      if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_weight_t>::value)
        if(!is_diagonal(e))
          weights[e] = CGAL::to_double(get(get_parameter(np, internal_np::edge_weight), given_edge(e)));
    }
    Disjoint_sets sets(m_number_of_faces);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::face_patch_t>::value) {
      const auto patches = get_parameter(np, internal_np::face_patch);
      for(const edge_descriptor e : edges(m_given)) {
        const halfedge_descriptor h = halfedge(e, m_given);
        if(!CGAL::is_border(e, m_given)) {
          const face_descriptor f = face(h, m_given), g = face(opposite(h, m_given), m_given);
          if(get(patches, f) == get(patches, g))
            sets.union_set(get(m_number_of_face, f), get(m_number_of_face, g));
        }
      }
    }
    for(const Face f : mesh.faces()) {
      numbers[f] = get(m_number_of_face, given_face(f));
      polygons[f] = sets.find_set(numbers[f]);
      if constexpr(!is_default_parameter<NamedParameters, internal_np::face_size_map_t>::value)
        sizes[f] = CGAL::to_double(get(get_parameter(np, internal_np::face_size_map), given_face(f)));
    }
  }

  const PolygonMesh& m_given;
  typename boost::property_map<PolygonMesh, dynamic_halfedge_property_t<std::size_t>>::const_type
      m_number_of_halfedge;
  typename boost::property_map<PolygonMesh, dynamic_face_property_t<std::size_t>>::const_type
      m_number_of_face;
  std::size_t m_number_of_faces = 0;
  std::vector<vertex_descriptor> m_vertices;    // of each vertex of the copy
  std::vector<halfedge_descriptor> m_halfedges; // of each halfedge of the copy that is no diagonal's
};

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TRIANGULATED_COPY_H
