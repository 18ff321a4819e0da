// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads one of the caller's meshes for an atlas: its components, what edges cost, weights, and coordinates that are to
// be kept. `mesh_in_atlas.h` gives it its charts.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_READ_ATLAS_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_READ_ATLAS_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/atlas/mesh_components.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/apply_seams.h>
#include <CGAL/Texture_atlas/Seam_report.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Texture_atlas::internal {

template <typename PropertyMap>
inline constexpr bool is_readable =
    std::is_convertible<typename boost::property_traits<PropertyMap>::category,
                        boost::readable_property_map_tag>::value;

const char* const unreadable_text = "charts can be kept only if the map of coordinates can be read";

// Reads a mesh. The map of seams may be a null pointer.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap, typename NamedParameters>
class Atlas_mesh_reader
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Mesh_atlas_report<TriangleMesh> Report;
  typedef Mesh_report<TriangleMesh, Seam_report> Reading;
  static constexpr bool has_seams = !std::is_same<EdgeIsSeamMap, std::nullptr_t>::value;
  static constexpr bool has_polygons =
      !parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value;

public:
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  static constexpr bool has_readable_uv = is_readable<HalfedgeUVMap>;

  Atlas_mesh_reader(const TriangleMesh& mesh, EdgeIsSeamMap seams, HalfedgeUVMap uv, bool keeps_charts,
                    const NamedParameters& np)
      : points(parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                            get_const_property_map(CGAL::vertex_point, mesh))),
        surface(mesh, points, given_numbers<TriangleMesh>(np)),
        components(mesh, points, vertex_numbers(mesh, np)), m_mesh(mesh), m_seams(seams), m_uv(uv),
        m_keeps_charts(keeps_charts && has_readable_uv), m_np(np)
  {
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::face_index_t>::value)
      components.set_numbers([numbers = parameters::get_parameter(np, internal_np::face_index)](
                                 face_descriptor f) { return static_cast<std::ptrdiff_t>(get(numbers, f)); });
  }

  // Reads the faces that can be flattened. Returns whether there are not too many.
  bool read_faces(Report& report)
  {
    components.find([this](edge_descriptor e) { return is_given_seam(e); },
                    [this](edge_descriptor e) { return is_in_polygon(e); });
    if(components.are_all_bad())
      return true;
    Reading reading;
    return surface.read_unscaled(
               [this](edge_descriptor e) { return is_given_seam(e) || components.is_at_defect(e); },
               [this](face_descriptor f) { return components.is_bad(f); }, reading) ||
           refuse(reading, Diagnosis::TOO_LARGE, report);
  }

  bool has_faces() const { return components.number() > 0; }

  std::size_t number_of_triangles() const
  {
    return surface.parts().empty()
               ? 0
               : static_cast<std::size_t>(surface.parts().back().first_triangle) +
                     static_cast<std::size_t>(surface.parts().back().chart.number_of_triangles());
  }

  // Reads what belongs to edges, and appends the weights of the triangles if there are some. Returns whether they are
  // right.
  bool read_attributes(double scale, std::vector<double>& weight, Report& report)
  {
    surface.set_scale(scale);
    Reading reading;
    if(!surface.read_costs(seam_cost<edge_descriptor>(m_np), reading))
      return refuse(reading, Diagnosis::WRONG_WEIGHT, report);
    if constexpr(has_polygons)
      surface.read_diagonals([this](edge_descriptor e) { return is_in_polygon(e); });
    if(m_keeps_charts)
      surface.read_given_maps([this](halfedge_descriptor h) { return given_uv(h); });
    return read_weights(weight, report);
  }

  bool is_given_seam(edge_descriptor e) const
  {
    if constexpr(has_seams)
      if(get(m_seams, e))
        return true;
    return m_keeps_charts && !CGAL::is_border(e, m_mesh) && !has_same_uv(halfedge(e, m_mesh));
  }

  Vertex_point_map points;
  Surface_reader<TriangleMesh, Vertex_point_map, Reading> surface;
  Mesh_components<TriangleMesh, Vertex_point_map> components;

private:
  static bool refuse(const Reading& reading, Diagnosis status, Report& report)
  {
    report.message = reading.message;
    report.offending_edges = reading.offending_edges;
    report.status = status;
    return false;
  }

  // Whether both sides of an edge have the same coordinates, or none
  bool has_same_uv(halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, m_mesh);
    const auto is_same = [this](halfedge_descriptor g, halfedge_descriptor k) {
      const Chart::Point_2 p = given_uv(g), q = given_uv(k);
      return p == q || !(is_finite(p) || is_finite(q));
    };
    return is_same(h, prev(o, m_mesh)) && is_same(o, prev(h, m_mesh));
  }

  static bool is_finite(const Chart::Point_2& p) { return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()); }

  Chart::Point_2 given_uv(halfedge_descriptor h) const
  {
    if constexpr(has_readable_uv) {
      const auto& p = get(m_uv, h);
      return Chart::Point_2(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    } else {
      (void)h;
      return CGAL::ORIGIN;
    }
  }

  // Whether both faces of an edge are parts of one polygon
  bool is_in_polygon([[maybe_unused]] edge_descriptor e) const
  {
    if constexpr(has_polygons) {
      const auto polygons = parameters::get_parameter(m_np, internal_np::face_patch);
      const halfedge_descriptor h = halfedge(e, m_mesh);
      return !CGAL::is_border(e, m_mesh) &&
             get(polygons, face(h, m_mesh)) == get(polygons, face(opposite(h, m_mesh), m_mesh));
    } else {
      return false;
    }
  }

  bool read_weights([[maybe_unused]] std::vector<double>& weight, [[maybe_unused]] Report& report) const
  {
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::face_size_map_t>::value) {
      const auto weights = parameters::get_parameter(m_np, internal_np::face_size_map);
      for(const Surface_part& part : surface.parts())
        for(int t = 0; t < part.chart.number_of_triangles(); ++t) {
          const face_descriptor f = surface.face_of(part.first_triangle + t);
          weight.push_back(CGAL::to_double(get(weights, f)));
          if(!(weight.back() >= 0 && CGAL::is_finite(weight.back()))) {
            report.status = Diagnosis::WRONG_WEIGHT;
            report.offending_faces = {f};
            report.message = components.face_name(f) + " has the weight " + std::to_string(weight.back()) +
                             ", and weights must be finite and not negative";
            return false;
          }
        }
    }
    return true;
  }

  const TriangleMesh& m_mesh;
  EdgeIsSeamMap m_seams;
  HalfedgeUVMap m_uv;
  const bool m_keeps_charts; // those of the coordinates that are there
  const NamedParameters& m_np;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_READ_ATLAS_MESH_H
