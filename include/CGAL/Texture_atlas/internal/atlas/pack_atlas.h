// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Gives charts their final coordinates: moves them to their places on the pages, rounds them, and makes polygons
// convex. Also certifies that charts are apart. `build_atlas_impl.h` calls it; `packing/pack.h` finds the places.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_PACK_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_PACK_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/float_grid.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Texture_atlas/internal/packing/chart_shape.h>
#include <CGAL/Texture_atlas/internal/packing/pack.h>
#include <CGAL/Texture_atlas/internal/packing/quantize.h>
#include <CGAL/Texture_atlas/internal/polygons/make_polygons_convex.h>
#include <CGAL/Texture_atlas/internal/polygons/round_to_floats.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Gives each chart of a part the area of its surface, with the lower left corner at the origin.
inline void scale_pieces(Part_atlas& part)
{
  struct Extent
  {
    Bbox_2 box;
    double surface = 0, plane = 0;
  };
  std::vector<Extent> pieces(part.pieces.size());
  std::vector<int> piece_of_vertex(part.uv.size());
  for(int c = 0; c < part.chart.number_of_corners(); ++c) {
    const int v = part.chart.vertex[c];
    piece_of_vertex[v] = part.piece[c / 3];
    pieces[part.piece[c / 3]].box += part.uv[v].bbox();
  }
  for(int t = 0; t < part.chart.number_of_triangles(); ++t) {
    pieces[part.piece[t]].surface += surface_area(part.chart, t);
    pieces[part.piece[t]].plane += std::abs(planar_area(part.chart, part.uv, t));
  }
  for(std::size_t v = 0; v < part.uv.size(); ++v) {
    const Extent& piece = pieces[piece_of_vertex[v]];
    const double factor = piece.surface > 0 ? std::sqrt(piece.surface / piece.plane) * part.chart.scale : 1;
    part.uv[v] = Chart::Point_2(factor * (part.uv[v].x() - piece.box.xmin()),
                                factor * (part.uv[v].y() - piece.box.ymin()));
  }
}

// Packs the charts of an atlas, which have numbers already.
class Atlas_packer
{
public:
  // `weight` multiplies the lengths of each triangle in the plane; empty if all are 1.
  Atlas_packer(const std::vector<Surface_part>& parts, const std::vector<double>& weight,
               const Packing_options& options, Atlas& atlas)
      : m_parts(parts), m_weight(weight), m_options(options), m_atlas(atlas)
  {}

  // Returns whether all charts have places. If not, `degenerate_part()` may be the reason.
  bool run()
  {
    const int charts = static_cast<int>(m_atlas.report.charts.size());
    const Packed_triangles triangles = packed_triangles();
    const Packing packing = pack(triangles.corners, triangles.chart, triangles.areas, charts, m_options);
    if(packing.status != Packing::DONE) {
      if(packing.status == Packing::DEGENERATE_CHART)
        m_degenerate_part = part_of_chart(packing.chart);
      fail(Diagnosis::PACKING_FAILED, describe(packing));
      return false;
    }
    for(int c = 0; c < charts; ++c) {
      m_atlas.report.charts[c].page = packing.page[c];
      m_atlas.report.charts[c].scale = packing.scale[c];
    }
    m_atlas.report.number_of_pages = static_cast<std::size_t>(packing.number_of_pages);
    m_atlas.report.covered_share = packing.covered_share;
    m_atlas.report.scale =
        packing.texels_per_length / m_options.resolution / m_parts.front().chart.scale; // alike for all parts
    move_charts(packing);
    return true;
  }

  // The part of which a chart cannot be scaled to the area of its surface, if there is one
  std::optional<std::size_t> degenerate_part() const { return m_degenerate_part; }

  // Returns whether no two charts share a texel with its gutter.
  bool certify()
  {
    const Packed_triangles triangles = packed_triangles();
    std::vector<int> page;
    for(const Atlas_report::Chart& chart : m_atlas.report.charts)
      page.push_back(chart.page);
    const Packing_check check = certify_packing(triangles.corners, triangles.chart, page, m_options);
    if(check.status == Packing_check::CERTIFIED)
      return true;
    fail(Diagnosis::PACKING_FAILED,
         "chart " + std::to_string(triangles.chart[check.triangle]) + " is not certified to be " +
             (check.status == Packing_check::OUTSIDE ? "in its page" : "apart from other charts"));
    return false;
  }

private:
  struct Packed_triangles : Planar_triangles
  {
    std::vector<int> chart; // of each triangle
  };

  Packed_triangles packed_triangles() const
  {
    Packed_triangles triangles;
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(const Part_atlas& part = m_atlas.parts[i]; part.succeeded()) {
        triangles.add(m_parts[i], m_weight, part);
        for(int piece : part.piece)
          triangles.chart.push_back(static_cast<int>(m_atlas.first_chart[i]) + piece);
      }
    return triangles;
  }

  void move_charts(const Packing& packing)
  {
    for(std::size_t i = 0; i < m_parts.size(); ++i) {
      Part_atlas& part = m_atlas.parts[i];
      std::vector<char> is_moved(part.uv.size(), false);
      for(int c = 0; part.succeeded() && c < part.chart.number_of_corners(); ++c) {
        const int v = part.chart.vertex[c];
        if(is_moved[v])
          continue;
        is_moved[v] = true;
        const std::size_t chart = m_atlas.first_chart[i] + static_cast<std::size_t>(part.piece[c / 3]);
        const Planar_point p = packing.placement[chart](Planar_point(part.uv[v].x(), part.uv[v].y()));
        part.uv[v] = Chart::Point_2(p.x(), p.y());
      }
    }
  }

  std::string describe(const Packing& packing) const
  {
    switch(packing.status) {
    case Packing::TOO_MANY_CHARTS:
      return std::to_string(m_atlas.report.charts.size()) + " charts do not fit into a page of " +
             page_text(m_options) + " with a gutter of " +
             std::to_string(m_options.number_of_gutter_texels());
    case Packing::CHART_TOO_LARGE:
      return chart_text(packing.chart) + too_large_text(packing, m_options);
    case Packing::TOO_MANY_PAGES:
      return too_many_pages_text(packing, m_options);
    case Packing::NO_AREA:
      return "all faces have the weight 0";
    default:
      return "chart " + std::to_string(packing.chart) + " cannot be scaled to the area of its surface";
    }
  }

  std::size_t part_of_chart(int number) const
  {
    std::size_t i = m_parts.size() - 1;
    while(m_atlas.first_chart[i] > static_cast<std::size_t>(number))
      --i;
    return i;
  }

  // With a place on the surface
  std::string chart_text(int number) const
  {
    const std::size_t i = part_of_chart(number);
    const Part_atlas& part = m_atlas.parts[i];
    const int piece = number - static_cast<int>(m_atlas.first_chart[i]);
    const auto t = std::find(part.piece.begin(), part.piece.end(), piece) - part.piece.begin();
    return "chart " + std::to_string(number) + ", with " + vertex_text(part.chart, part.chart.vertex[3 * t]) +
           ",";
  }

  void fail(Diagnosis diagnosis, const std::string& message)
  {
    m_atlas.report.status = diagnosis;
    m_atlas.report.message = message;
  }

  const std::vector<Surface_part>& m_parts;
  const std::vector<double>& m_weight;
  const Packing_options& m_options;
  Atlas& m_atlas;
  std::optional<std::size_t> m_degenerate_part;
};

// Coordinates in files are of the type `float`. Only from 0 to 1, 1 - v has enough digits then, whatever the unit of
// length.
inline Float_grid float_grid(const Atlas_options& options)
{
  return {options.pack_into_square};
}

// Rounds the coordinates of a part to the caller's number type. Borders stay where they were packed. If some triangles
// cannot, the certificate finds them.
inline void round_part(const Atlas_options& options, Rounding round, Part_atlas& part)
{
  if(options.float_coordinates || options.quantization_bits) {
    Float_rounder rounder(part.chart.vertex, float_grid(options), part.uv);
    rounder.keep_gaps(border_edges(part.chart));
    if(options.pack_into_square) {
      std::vector<char> is_border;
      for(int v : part.chart.interior)
        is_border.push_back(v < 0);
      const double texels = (std::max)(options.resolution, options.number_of_rows());
      rounder.bound_moves(std::move(is_border), placement_tolerance / 2 / texels);
    }
    rounder.run();
  }
  round(part.uv);
}

// Moves interior vertices where that makes polygons convex, and returns how many polygons that mended. `is_diagonal` is
// that of the edge that each corner faces. Coordinates are final otherwise, and rounded again.
inline std::size_t make_polygons_convex(const std::vector<char>& is_diagonal, const Atlas_options& options,
                                        Rounding round, Part_atlas& part)
{
  Divided_polygons polygons{part.chart.vertex, part.chart.opposite, is_diagonal, {}};
  for(int v = 0; v < part.chart.number_of_vertices(); ++v)
    polygons.is_fixed.push_back(part.chart.interior[v] < 0);
  const std::size_t mended = Polygon_mender(polygons, float_grid(options), part.uv).run();
  round(part.uv);
  return mended;
}

// Moves the vertices of a part to the grid of coordinates. Polygons that are convex at a corner stay so.
inline void quantize_part(const std::vector<char>& is_diagonal, int bits, Part_atlas& part)
{
  const Chart& chart = part.chart;
  Chart_quantizer quantizer(chart.vertex, bits, part.uv);
  const auto is_inside = [&](int c) { return chart.opposite[c] >= 0 && is_diagonal[c]; };
  for(int c = 0; c < chart.number_of_corners() && !is_diagonal.empty(); ++c) {
    if(is_inside(c))
      continue;
    int next = next_corner(c); // the next side of the polygon
    while(is_inside(next))
      next = next_corner(chart.opposite[next]);
    const std::array<int, 3> corner = {chart.edge_source(c), chart.edge_target(c), chart.edge_target(next)};
    if(corner[0] != corner[2])
      quantizer.protect(corner);
  }
  quantizer.run();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_PACK_ATLAS_H
