// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_PRESCRIPTIONS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_PRESCRIPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/check_angle_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/importance.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The prescribed angle sum of each vertex of a mesh, if there is one. It hides the type of the caller's property map.
template <typename TriangleMesh>
using Vertex_angle_sums = std::function<std::optional<double>(
    const typename boost::graph_traits<TriangleMesh>::vertex_descriptor&)>;

template <typename TriangleMesh, typename VertexAngleSumMap>
Vertex_angle_sums<TriangleMesh> vertex_angle_sums(VertexAngleSumMap map)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  return [map](const vertex_descriptor& v) { return std::optional<double>(get(map, v)); };
}

// The border halfedge on the other side of a seam, of each border halfedge. It hides the type of the caller's property map.
template <typename TriangleMesh>
using Halfedge_seam_sides = std::function<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor(
    const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor&)>;

// What a caller prescribes for faces, vertices and seams
template <typename TriangleMesh>
struct Prescriptions
{
  Face_importance<TriangleMesh> importance;
  Vertex_angle_sums<TriangleMesh> angle_sums;
  Halfedge_seam_sides<TriangleMesh> seam_sides;
  bool equal_seam_lengths = false;
};

// Finds sides that are not those of each other.
inline Chart_defect find_wrong_seam(const Chart& chart)
{
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(const int across = chart.seam[c]; across >= 0 && (across == c || chart.seam[across] != c))
      return {Flattening_report::WRONG_OPTION,
              "the sides of a seam do not belong to one another at the vertex at " +
                  position_text(chart, chart.edge_source(c)),
              {chart.edge_source(c), chart.edge_target(c)},
              {}};
  return {};
}

// Makes the sides of seams equal, if there are seams.
inline Chart_defect equalize_seams(Chart& chart)
{
  const bool has_seams = std::any_of(chart.seam.begin(), chart.seam.end(), [](int c) { return c >= 0; });
  if(has_seams && chart.has_prescribed_angles())
    return {Flattening_report::WRONG_OPTION,
            "equal lengths of seams and prescribed angles exclude each other",
            {},
            {}};
  for(int k = 0; k < chart.number_of_holes(); ++k)
    for(int c : chart.hole(k))
      if(has_seams && chart.seam[c] >= 0)
        return {Flattening_report::WRONG_OPTION,
                "equal lengths of seams need all seams on the outer border, but one is on a hole",
                {chart.edge_source(c)},
                {}};
  chart.has_equal_seams = has_seams;
  find_nodes(chart);
  return {};
}

// Puts what rounding left of the total onto the largest angle: the equations cannot be met otherwise.
inline void complete_total(double missing, Chart& chart)
{
  if(!is_whole_border_prescribed(chart))
    return;
  *std::max_element(chart.angle_sums.begin(), chart.angle_sums.end(),
                    [](double a, double b) { return std::isnan(a) ? !std::isnan(b) : a < b; }) += missing;
}

// Sets the prescribed angles of a chart, if there are some that can be met.
template <typename VertexDescriptor, typename VertexAngleSums>
Chart_defect read_angle_sums(const std::vector<VertexDescriptor>& vertices, const VertexAngleSums& angle_sums,
                             Chart& chart)
{
  if(!angle_sums)
    return {};
  chart.angle_sums.assign(vertices.size(), (std::numeric_limits<double>::quiet_NaN)());
  bool has_some = false;
  for(std::size_t v = 0; v < vertices.size(); ++v)
    if(const std::optional<double> sum = angle_sums(vertices[v])) {
      // Not a number stands for none, and must not be taken for that.
      chart.angle_sums[v] = std::isnan(*sum) ? -1 : *sum;
      has_some = true;
    }
  if(!has_some) {
    chart.angle_sums.clear();
    return {};
  }
  const Angle_sum_check check(chart);
  if(Chart_defect defect = check.run())
    return defect;
  complete_total(check.missing_angle(), chart);
  find_nodes(chart);
  return {};
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_PRESCRIPTIONS_H
