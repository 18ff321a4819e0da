// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads the vertices whose positions in the plane a caller has set, and refuses positions that no map has.
// `run_parameterizer.h` calls it behind `prescriptions.h`; `strategies/pin_map.h` moves the finished map to the pins.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_PINS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_PINS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The position that is set for each vertex of a mesh, if there is one. It hides the types of the caller's property
// maps.
template <typename TriangleMesh>
using Vertex_pins = std::function<std::optional<Chart::Point_2>(
    const typename boost::graph_traits<TriangleMesh>::vertex_descriptor&)>;

template <typename Point>
Chart::Point_2 point_of_doubles(const Point& p)
{
  return Chart::Point_2(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
}

template <typename TriangleMesh, typename VertexPinMap>
Vertex_pins<TriangleMesh> vertex_pins(VertexPinMap map)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  return [map](const vertex_descriptor& v) -> std::optional<Chart::Point_2> {
    const auto& position = get(map, v);
    if(!position)
      return std::nullopt;
    return point_of_doubles(*position);
  };
}

// In place of a property map, where no vertex is parameterized beforehand: programs without pins then have no code for
// them.
struct None_parameterized
{};

// The same pins, and the vertices that count as parameterized, as the concept `Parameterizer_3` has it
template <typename TriangleMesh, typename VertexUVmap, typename VertexParameterizedMap>
Vertex_pins<TriangleMesh> with_parameterized_vertices(const Vertex_pins<TriangleMesh>& pins,
                                                      VertexUVmap uvmap, VertexParameterizedMap vpmap)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  if constexpr(std::is_same<VertexParameterizedMap, None_parameterized>::value) {
    (void)uvmap;
    (void)vpmap;
    return pins;
  } else {
    return [=](const vertex_descriptor& v) -> std::optional<Chart::Point_2> {
      if(get(vpmap, v))
        return point_of_doubles(get(uvmap, v));
      return pins ? pins(v) : std::nullopt;
    };
  }
}

// Finds pins that are not finite, or not apart.
inline Chart_defect find_wrong_pin(const Chart& chart)
{
  Chart_defect defect;
  for(const Chart::Pin& pin : chart.pins)
    if(!std::isfinite(pin.position.x()) || !std::isfinite(pin.position.y()))
      defect.vertices.push_back(pin.vertex);
  if(!defect.vertices.empty()) {
    defect.status = Diagnosis::WRONG_PIN;
    defect.message =
        "the position of the pin at " + vertex_text(chart, defect.vertices.front()) + " is not finite";
    return defect;
  }
  std::vector<Chart::Pin> pins = chart.pins;
  std::sort(pins.begin(), pins.end(),
            [](const Chart::Pin& p, const Chart::Pin& q) { return p.position < q.position; });
  for(std::size_t i = 1; i < pins.size(); ++i)
    if(pins[i - 1].position == pins[i].position)
      return {Diagnosis::WRONG_PIN,
              vertex_text(chart, pins[i - 1].vertex) + " and " + vertex_text(chart, pins[i].vertex) +
                  " are pinned at the same position",
              {pins[i - 1].vertex, pins[i].vertex},
              {}};
  return defect;
}

// Reads the pins of a mesh whose chart knows its prescribed angles.
template <typename TriangleMesh>
Chart_defect
read_pins(const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices,
          const Vertex_pins<TriangleMesh>& pins, Chart& chart)
{
  if(!pins)
    return {};
  for(std::size_t v = 0; v < vertices.size(); ++v)
    if(const std::optional<Chart::Point_2> position = pins(vertices[v]))
      chart.pins.push_back({static_cast<int>(v), *position});
  if(chart.pins.size() > 2 && chart.has_prescribed_angles()) {
    Chart_defect defect{Diagnosis::WRONG_OPTION, "prescribed angle sums allow no more than two pins", {}, {}};
    for(const Chart::Pin& pin : chart.pins)
      defect.vertices.push_back(pin.vertex);
    return defect;
  }
  return find_wrong_pin(chart);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_PINS_H
