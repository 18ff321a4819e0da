// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What callers prescribe for a mesh: importance of faces, sums of angles, positions, and both sides of seams, with the
// types of their maps hidden.
// `run_parameterizer.h`, cones and atlas charts take it into the chart, before target angles are computed.
//
// Reads the importance of faces as weights of triangles in the energy, and refuses weights with which Newton's method
// is slow. `prescriptions.h` calls it when a mesh is read; `coarse_solver.h` keeps the weights of coarse charts in the
// same range.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_PRESCRIPTIONS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_PRESCRIPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_pins.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Newton's method takes up to 4 times as many steps where neighbours differ by a factor of 10, up to 25 times as many
// where they differ by 100, and often does not converge where they differ by 1000.
inline constexpr double least_importance = 0.1, largest_importance = 10;

// The importance of each face of a mesh; empty if all are equal. It hides the type of the caller's property map.
template <typename TriangleMesh>
using Face_importance =
    std::function<double(const typename boost::graph_traits<TriangleMesh>::face_descriptor&)>;

template <typename TriangleMesh, typename FaceImportanceMap>
Face_importance<TriangleMesh> face_importance(FaceImportanceMap map)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  return [map](const face_descriptor& f) { return static_cast<double>(get(map, f)); };
}

// Finds the weights of triangles that are out of range.
inline Chart_defect find_wrong_weight(const Chart& chart)
{
  const std::vector<double>& weight = chart.weight;
  Chart_defect defect;
  for(std::size_t t = 0; t < weight.size(); ++t)
    if(!(weight[t] >= least_importance && weight[t] <= largest_importance))
      defect.triangles.push_back(static_cast<int>(t));
  if(defect.triangles.empty())
    return defect;
  std::ostringstream text;
  const int t = defect.triangles.front();
  text << "the importance of the face of " << vertex_text(chart, chart.vertex[3 * t]) << ", "
       << vertex_text(chart, chart.vertex[3 * t + 1]) << " and "
       << vertex_text(chart, chart.vertex[3 * t + 2]) << " is " << weight[t] << ", but must be between "
       << least_importance << " and " << largest_importance;
  defect.status = Diagnosis::WRONG_WEIGHT;
  defect.message = text.str();
  return defect;
}

// Sets the weights of the triangles of the chart that was read, from the importance of its faces.
template <typename ChartReader, typename FaceImportance>
Chart_defect read_importance(ChartReader& reader, const FaceImportance& importance)
{
  if(!importance)
    return {};
  std::vector<double>& weight = reader.chart.weight;
  weight.reserve(reader.number_of_faces());
  for(int t = 0; t < reader.number_of_faces(); ++t)
    weight.push_back(importance(reader.face_of_triangle(t)));
  return find_wrong_weight(reader.chart);
}

// The prescribed angle sum of each vertex of a mesh, if there is one. It hides the type of the caller's property map.
template <typename TriangleMesh>
struct Vertex_angle_sums
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  std::function<std::optional<double>(const vertex_descriptor&, const TriangleMesh&)> sum_of;
  bool of_surface = false; // whether they are those of the vertices of a surface before it was cut
};

// The keys are vertices of the mesh, or of a seam mesh also those of the mesh below it.
template <typename TriangleMesh, typename VertexAngleSumMap>
Vertex_angle_sums<TriangleMesh> vertex_angle_sums(VertexAngleSumMap map)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_traits<VertexAngleSumMap>::key_type Key;
  if constexpr(std::is_same_v<Key, typename Seam_sides<TriangleMesh>::surface_vertex_descriptor>)
    return {[map](const vertex_descriptor& v, const TriangleMesh& mesh) {
              return std::optional<double>(get(map, Seam_sides<TriangleMesh>::surface_vertex(v, mesh)));
            },
            true};
  else
    return {
        [map](const vertex_descriptor& v, const TriangleMesh&) { return std::optional<double>(get(map, v)); },
        false};
}

// The border halfedge on the other side of a seam, of each border halfedge. It hides the type of the caller's property
// map.
template <typename TriangleMesh>
using Halfedge_seam_sides = std::function<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor(
    const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor&)>;

// Finds sides that are not those of each other.
inline Chart_defect find_wrong_seam(const Chart& chart)
{
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(const int across = chart.seam[c]; across >= 0 && (across == c || chart.seam[across] != c))
      return {Diagnosis::WRONG_OPTION,
              "a halfedge is not the other side of its other side, at " +
                  vertex_text(chart, chart.edge_source(c)),
              {chart.edge_source(c), chart.edge_target(c)},
              {}};
  return {};
}

// Makes the sides of seams equal, if there are seams. A seam with a side at a hole is an error if `all_of_them`, and
// otherwise keeps different lengths.
inline Chart_defect equalize_seams(Chart& chart, bool all_of_them = false)
{
  for(int k = 0; k < chart.number_of_holes(); ++k)
    for(int c : chart.hole(k))
      if(all_of_them && !chart.seam.empty() && chart.seam[c] >= 0)
        return {Diagnosis::WRONG_OPTION,
                "seams of equal lengths must have both sides on the outer border, but one has a side at a "
                "hole, at " +
                    vertex_text(chart, chart.edge_source(c)),
                {chart.edge_source(c)},
                {}};
  equalize_outer_seams(chart);
  return {};
}

// What a caller prescribes for faces, vertices and seams
template <typename TriangleMesh>
struct Prescriptions
{
  Face_importance<TriangleMesh> importance;
  Vertex_angle_sums<TriangleMesh> angle_sums;
  Halfedge_seam_sides<TriangleMesh> seam_sides;
  std::optional<bool> equal_seam_lengths;
  Vertex_points<TriangleMesh> points;   // of the mesh if it is empty
  Vertex_numbers<TriangleMesh> numbers; // positions if it is empty
  Vertex_pins<TriangleMesh> pins;
  bool may_have_pins = false; // whether the caller gave a map of them

  template <typename HalfedgeSideMap>
  void set_seam_sides(HalfedgeSideMap sides)
  {
    seam_sides = [sides](const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor& h) {
      return get(sides, h);
    };
  }

  // Seams of equal lengths, unless the border of the cut mesh is prescribed
  bool wants_equal_seams() const
  {
    const bool has_border_angles = angle_sums.sum_of && !angle_sums.of_surface;
    return equal_seam_lengths.value_or(Seam_sides<TriangleMesh>::has_seams && !has_border_angles);
  }

  Chart_defect find_conflict() const
  {
    if(equal_seam_lengths.value_or(false) && !seam_sides && !Seam_sides<TriangleMesh>::has_seams)
      return {Diagnosis::WRONG_OPTION,
              "equal_seam_lengths would have no effect: take a Seam_mesh, or call set_seam_sides()",
              {},
              {}};
    if(!angle_sums.of_surface || wants_equal_seams())
      return {};
    return {Diagnosis::WRONG_OPTION,
            "angle sums of the surface before the cut need seams of equal lengths",
            {},
            {}};
  }
};

// Sets the prescribed angles of a chart if they are possible. The body is in `angles/check_surface_sums.h`, as the
// check needs what is there.
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect set_angle_sums(std::vector<double> sums, Chart& chart);

// Reads the prescribed angles of a mesh whose chart knows its seams of equal sides.
template <typename TriangleMesh>
Chart_defect
read_angle_sums(const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices,
                const Vertex_angle_sums<TriangleMesh>& angle_sums, const TriangleMesh& mesh, Chart& chart)
{
  if(!angle_sums.sum_of)
    return {};
  std::vector<double> sums(vertices.size(), (std::numeric_limits<double>::quiet_NaN)());
  bool has_some = false;
  for(std::size_t v = 0; v < vertices.size(); ++v)
    if(const std::optional<double> sum = angle_sums.sum_of(vertices[v], mesh)) {
      // NaN means that no angle is prescribed. A prescribed NaN must not be taken for that.
      sums[v] = std::isnan(*sum) ? -1 : *sum;
      has_some = true;
    }
  // On the surface before the cut, seam vertices missing from the map get 2 pi.
  if(!has_some && !chart.equal_seams)
    return {};
  return set_angle_sums(std::move(sums), chart);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_PRESCRIPTIONS_H
