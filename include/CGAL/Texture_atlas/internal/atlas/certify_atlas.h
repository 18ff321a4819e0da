// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Certifies and measures the charts of an atlas with their final, rounded coordinates. Packing moves and scales charts,
// so earlier tests do not count. `build_atlas_impl.h` makes parts anew that fail.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CERTIFY_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CERTIFY_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/measure_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The border edges of each chart of a part
inline std::vector<std::vector<Border_edge>> borders_of_pieces(const Part_atlas& part)
{
  std::vector<std::vector<Border_edge>> borders(part.pieces.size());
  for(const std::vector<int>& border : part.chart.borders)
    for(int c : border)
      borders[part.piece[c / 3]].push_back({part.chart.edge_source(c), part.chart.edge_target(c)});
  return borders;
}

// What keeps the map of a part from being injective, if anything
struct Map_defect
{
  Diagnosis status = Diagnosis::NOTHING_WRONG;
  int vertex = -1;                   // of the chart
  std::size_t number_of_flipped = 0; // triangles
};

// By exact predicates
inline Map_defect find_map_defect(const Part_atlas& part)
{
  const std::vector<Exact_point_2> uv = exact_points(part.uv);
  const std::vector<int> flipped = flipped_triangles(part.chart.vertex, uv);
  if(!flipped.empty())
    return {Diagnosis::FLIPPED_TRIANGLES, part.chart.vertex[3 * flipped.front()], flipped.size()};
  for(const std::vector<Border_edge>& border : borders_of_pieces(part))
    if(!bounds_region(border, uv))
      return {Diagnosis::OVERLAPPING, border.front().source, 0};
  return {};
}

// Returns why the final map of a part is not injective, or nothing, and notes where.
inline std::string certify_part(Part_atlas& part)
{
  const Map_defect defect = find_map_defect(part);
  if(defect.status == Diagnosis::NOTHING_WRONG)
    return "";
  part.wrong_corner = part.corner_at(defect.vertex);
  return "the final coordinates have too few digits for " +
         (defect.number_of_flipped > 0 ? std::to_string(defect.number_of_flipped) + " triangle(s), one"
                                       : std::string("the border")) +
         " at " + vertex_text(part.chart, defect.vertex);
}

// Says what is wrong with a map that was given.
inline std::string defect_text(const Part_atlas& part, const Map_defect& defect)
{
  const std::string chart = "the given chart of " + std::to_string(part.piece.size()) + " triangle(s)",
                    vertex = " " + vertex_text(part.chart, defect.vertex);
  if(defect.status == Diagnosis::FLIPPED_TRIANGLES)
    return chart + " has " + std::to_string(defect.number_of_flipped) +
           " that are flipped or have no area, one at" + vertex;
  return chart +
         (defect.status == Diagnosis::OVERLAPPING ? " overlaps itself; its border runs through"
                                                  : " has no coordinates at") +
         vertex;
}

// A part with the map that it has, as one chart, on a page whose sides have this ratio. Fails if the map is not
// injective.
inline Part_atlas given_part(const Surface_part& part, double page_aspect)
{
  Part_atlas atlas;
  Piece whole = opened_along_seams(part.chart, part.cost, {});
  atlas.uv = whole.map_from(part.given_map);
  atlas.chart = std::move(whole.chart);
  atlas.piece.assign(whole.triangles.size(), 0);
  atlas.pieces.resize(1);
  atlas.pieces.front().method = Atlas_report::GIVEN;
  atlas.pieces.front().seam_lengths = Atlas_report::OTHER_METHOD;
  const auto bad = std::find_if(atlas.uv.begin(), atlas.uv.end(), [](const Chart::Point_2& p) {
    return !(std::isfinite(p.x()) && std::isfinite(p.y()));
  });
  Map_defect defect;
  if(bad != atlas.uv.end())
    defect = {Diagnosis::NO_TEXTURE_COORDINATES, static_cast<int>(bad - atlas.uv.begin()), 0};
  else
    defect = find_map_defect(atlas);
  atlas.status = defect.status;
  if(!atlas.succeeded()) {
    atlas.message = defect_text(atlas, defect);
    atlas.wrong_corner = atlas.corner_at(defect.vertex);
  }
  for(Chart::Point_2& p : atlas.uv) // where texels are squares
    p = Chart::Point_2(p.x(), p.y() / page_aspect);
  return atlas;
}

// Measures the distortion of the charts, one by one and all together.
class Atlas_measurement
{
public:
  Atlas_measurement(int triangles, double surface, double stretch_bound)
      : m_totals(triangles, surface), m_bound(stretch_bound)
  {}

  // Adds the charts of a part, which are in the report from number `first` on.
  void add(const Part_atlas& part, Atlas_report& report, std::size_t first)
  {
    const std::vector<Stretch_sums> sums = stretch_of_pieces(part);
    measure_triangles(part, sums);
    for(std::size_t i = 0; i < sums.size(); ++i) {
      Atlas_report::Chart& chart = report.charts[first + i];
      const Map_stretch stretch = sums[i].stretch();
      chart.area = sums[i].surface() * part.chart.scale * part.chart.scale;
      chart.scale_stretch = stretch.scale;
      chart.bound_reached = !(chart.scale_stretch > stretch_tolerance * m_bound);
      chart.l2_stretch = stretch.l2;
      chart.crushed_faces = static_cast<std::size_t>(stretch.crushed_triangles);
      chart.skewed_share = stretch.skewed_share;
      chart.is_good = !stretch.is_bad(m_bound);
    }
    for(const std::vector<int>& border : part.chart.borders)
      for(int c : border)
        report.charts[first + part.piece[c / 3]].border_length +=
            edge_length(part.chart, c) * part.chart.scale;
    measure_seams(part, report, first);
  }

  Flattening_measures measures() { return m_totals.measures(); }

  // The density of texels that this share of the surface has at least, where the plane is the page
  double density_of_share(double share)
  {
    std::sort(m_densities.begin(), m_densities.end());
    double sum = 0;
    for(const auto& [density, area] : m_densities) {
      sum += area;
      if(sum >= (1 - share) * m_surface)
        return density * m_surface;
    }
    return 0;
  }

private:
  static void measure_seams(const Part_atlas& part, Atlas_report& report, std::size_t first)
  {
    std::vector<char> has_seams(part.pieces.size(), false);
    for(const std::vector<int>& border : part.chart.borders)
      for(int c : border) {
        const int piece = part.piece[c / 3], across = part.chart.seam[c];
        if(across < 0 || part.piece[across / 3] != piece)
          continue;
        has_seams[piece] = true;
        double& jump = report.charts[first + piece].largest_seam_jump;
        jump = (std::max)(jump, seam_jump(part.chart, part.uv, c));
      }
    for(std::size_t i = 0; i < has_seams.size(); ++i) {
      Atlas_report::Chart& chart = report.charts[first + i];
      chart.seam_lengths = has_seams[i] ? part.pieces[i].seam_lengths : Atlas_report::NO_SEAMS;
      chart.has_equal_seams = chart.seam_lengths == Atlas_report::EQUAL_LENGTHS;
      if(chart.has_equal_seams)
        report.largest_equal_seam_jump = (std::max)(report.largest_equal_seam_jump, chart.largest_seam_jump);
    }
  }

  // Each relative to the scale of its chart
  void measure_triangles(const Part_atlas& part, const std::vector<Stretch_sums>& sums)
  {
    const Target_angles target(part.chart);
    const int triangles = part.chart.number_of_triangles(), batch = 64 * block_size;
    std::vector<Flattening_face_measures> faces((std::min)(triangles, batch));
    for(int first = 0; first < triangles; first += batch) {
      const int size = (std::min)(batch, triangles - first);
      parallel_for_blocks(size, [&](int begin, int end) {
        for(int i = begin; i < end; ++i) {
          const Stretch_sums& sum = sums[part.piece[first + i]];
          faces[i] = measure_triangle(part.chart, target, part.uv, std::sqrt(sum.surface() / sum.plane()),
                                      first + i);
        }
      });
      for(int i = 0; i < size; ++i) {
        m_totals.add(faces[i]);
        add_density(faces[i], sums[part.piece[first + i]]);
      }
    }
  }

  // In the direction with the fewest texels, for the area 1 of the surface
  void add_density(const Flattening_face_measures& face, const Stretch_sums& chart)
  {
    if(!(face.area > 0))
      return;
    const double squared_scale = chart.surface() / chart.plane();
    m_densities.emplace_back(1 / (face.linf_stretch * face.linf_stretch * squared_scale), face.area);
    m_surface += face.area;
  }

  Measure_totals m_totals;
  double m_bound;
  std::vector<std::pair<float, float>> m_densities; // and areas, of all triangles
  double m_surface = 0;
};

// While it exists, texels are squares in the plane of a map, also if pages are not.
class Square_texels
{
public:
  Square_texels(const Atlas_options& options, std::vector<Chart::Point_2>& uv) : m_map(uv), m_uv(uv)
  {
    const double aspect = options.pack_into_square ? aspect_ratio(options) : 1;
    for(Chart::Point_2& p : m_map)
      p = Chart::Point_2(p.x(), p.y() / aspect);
  }

  ~Square_texels() { m_map = std::move(m_uv); }

  Square_texels(const Square_texels&) = delete;
  Square_texels& operator=(const Square_texels&) = delete;

private:
  std::vector<Chart::Point_2>& m_map;
  std::vector<Chart::Point_2> m_uv; // as it was
};

inline void look_at_stretch(Atlas_report& report)
{
  const std::vector<Atlas_report::Chart>& charts = report.charts;
  const auto is_bad = [](const Atlas_report::Chart& chart) { return !chart.is_good; };
  const auto first = std::find_if(charts.begin(), charts.end(), is_bad);
  if(first == charts.end())
    return;
  std::ostringstream text;
  text << std::count_if(first, charts.end(), is_bad) << " of " << charts.size()
       << " charts stretch the surface badly: chart " << first - charts.begin() << " has an L2 stretch of "
       << first->l2_stretch << ", " << first->crushed_faces << " crushed faces, and "
       << 100 * first->skewed_share << " % of skewed area";
  report.status = Diagnosis::STRETCH_BOUND_MISSED;
  report.message = text.str();
}

// Measures the charts of an atlas, and says if some are not good. The charts must be injective.
inline void measure_atlas(const Atlas_options& options, Atlas& atlas)
{
  Atlas_report& report = atlas.report;
  int triangles = 0;
  double surface = 0;
  for(const Part_atlas& part : atlas.parts)
    for(int t = 0; part.succeeded() && t < part.chart.number_of_triangles(); ++t, ++triangles)
      surface += surface_area(part.chart, t);
  Atlas_measurement measurement(triangles, surface, options.stretch_bound);
  for(std::size_t i = 0; i < atlas.parts.size(); ++i)
    if(atlas.parts[i].succeeded()) {
      const Square_texels square_texels(options, atlas.parts[i].uv);
      measurement.add(atlas.parts[i], report, atlas.first_chart[i]);
      report.number_of_terminals += atlas.parts[i].number_of_terminals;
    }
  report.measures = measurement.measures();
  report.measures.border_is_simple = true;
  if(options.pack_into_square) {
    report.texel_density = report.covered_share / CGAL::square(report.measures.l2_stretch);
    report.low_texel_density =
        measurement.density_of_share(0.95) * aspect_ratio(options) / report.number_of_pages;
  }
  look_at_stretch(report);
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CERTIFY_ATLAS_H
