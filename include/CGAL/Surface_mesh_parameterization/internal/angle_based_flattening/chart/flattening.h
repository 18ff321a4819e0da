// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a method returns for a chart: coordinates, or the reason why there are none.
// The methods of `strategies/`, the injective maps and the parameterizers pass it on.
//
// Rounds coordinates to the caller's points, and writes them to the mesh.
// The last stage of parameterizers, cones, atlases and packing. The certificate sees the rounded coordinates.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FLATTENING_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FLATTENING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Coordinates as a point of the caller's
template <typename Point>
Point planar_point(const Chart::Point_2& p)
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel::FT FT;
  return Point(FT(p.x()), FT(p.y()));
}

// Rounds `uv` to what points hold. They are read back from an array of such points: a conversion to their number type
// and back in one expression is not enough, as GCC 12 removes it at -O2 where it vectorizes straight-line code.
template <typename Point>
void round_to_points(std::vector<Chart::Point_2>& uv)
{
  std::vector<Point> points;
  points.reserve(uv.size());
  for(const Chart::Point_2& p : uv)
    points.push_back(planar_point<Point>(p));
  for(std::size_t v = 0; v < uv.size(); ++v)
    uv[v] = Chart::Point_2(CGAL::to_double(points[v].x()), CGAL::to_double(points[v].y()));
}

// Writes coordinates that are rounded already, which another conversion does not change.
template <typename TriangleMesh, typename VertexUVmap>
void write_chart(const Chart_reader<TriangleMesh>& reader, const std::vector<Chart::Point_2>& uv,
                 VertexUVmap uvmap)
{
  typedef typename boost::property_traits<VertexUVmap>::value_type Point;
  for(std::size_t v = 0; v < uv.size(); ++v)
    put(uvmap, reader.vertex_descriptors[v], planar_point<Point>(uv[v]));
}

// The planar angles of a map, and the multipliers of their constraints: where a later run on the same triangles can
// start
struct Planar_angles
{
  std::vector<int> vertex, node;   // as in the chart: of the same triangles and constraints
  std::vector<double> beta, alpha; // the target angles and the planar ones, of each corner
  std::vector<double> multipliers;
};

// The map of a chart, or why there is none.
template <typename Report>
struct Flattening
{
  std::vector<Chart::Point_2> uv;
  std::vector<int> invalid;            // the triangles that make the map invalid, if that is what is wrong
  std::vector<int> offending_vertices; // those of pins to which no valid map was found
  Report report;
  std::shared_ptr<const Planar_angles> angles; // if they were asked for

  bool succeeded() const { return report.status == Diagnosis::NOTHING_WRONG; }
};

// Rounds coordinates to what the caller can store.
typedef void (*Rounding)(std::vector<Chart::Point_2>&);

// What becomes of a coarse chart: its map, or nothing if finer charts are to be tried. A diagnosis ends the run with
// it. The rest is what a coarse parameterizer tells of its map, or of its failure.
struct Coarse_map
{
  Coarse_map(std::optional<std::vector<Chart::Point_2>> map, Diagnosis end = Diagnosis::NOTHING_WRONG)
      : uv(std::move(map)), status(end)
  {}

  std::optional<std::vector<Chart::Point_2>> uv;
  Diagnosis status;
  std::optional<Error_code> error; // that was returned
  int flipped_triangles = 0;       // if there is no map
  std::string message;             // why there is no map
  std::string note;                // what the map is, if not what was asked for
};

typedef std::function<Coarse_map(const Chart&)> Coarse_flattening;

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FLATTENING_H
