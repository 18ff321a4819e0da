// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All stages of an atlas in their order: charts of all parts, polygons, packing, certificate and measures. Included at
// the end of `build_atlas.h`, or by the source file of the compiled library. Parts come from `divided_part_atlas.h`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_BUILD_ATLAS_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_BUILD_ATLAS_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/atlas_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/build_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/certify_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/cover_page.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/divided_part_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/fit_pages.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/isometric_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/measure_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/pack.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/packing.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/polygons/make_polygons_convex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

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

class Atlas_builder
{
  typedef Visited_stage<Atlas_visitor> Stage;

public:
  Atlas_builder(const std::vector<Surface_part>& parts, const std::vector<double>& weight,
                const Atlas_settings& options, const Linear_solvers& solvers, Rounding round)
      : m_parts(parts), m_weight(weight), m_options(options), m_solvers(solvers), m_round(round)
  {
    if(!parts.empty())
      m_options.texels_per_unit *= parts.front().chart.scale; // alike for all parts
    double area = 0;
    for(const Surface_part& part : parts)
      for(int t = 0; t < part.chart.number_of_triangles(); ++t)
        area += surface_area(part.chart, t) * part.chart.scale * part.chart.scale;
    if(options.given_charts == Atlas_options::KEEP)
      m_options.stretch_bound = std::numeric_limits<double>::infinity();
    if(options.pack_into_square && options.texels_per_unit == 0 && std::isfinite(options.stretch_bound))
      m_options.longest_chart = largest_aspect * std::sqrt(area);
  }

  Atlas run()
  {
    make_charts();
    bool is_placed = true;
    do
      is_placed = place_charts();
    while(is_placed && !certify());
    if(is_placed && is_packing_certified())
      measure();
    return std::move(m_atlas);
  }

private:
  // A chart that is longer than this times the square root of the total area would leave most of the page empty.
  static constexpr double largest_aspect = 4;

  // Charts may be packed and certified several times. Visitors hear of each stage only once.
  Atlas_visitor* visitor_of(Atlas_visitor::Stage stage)
  {
    const bool is_new = stage > m_stage;
    m_stage = (std::max)(m_stage, stage);
    return is_new ? m_options.visitor : nullptr;
  }

  // Parts are made in parallel, the largest ones first.
  void make_charts()
  {
    const Stage stage(visitor_of(Atlas_visitor::CHARTS), Atlas_visitor::CHARTS,
                      m_atlas.report.seconds.charts);
    std::vector<double> work;
    for(const Surface_part& part : m_parts) {
      const double n = part.chart.number_of_triangles();
      work.push_back(n * std::log2(n + 1));
    }
    std::vector<double> all_work = work;
    if(m_options.isometric_charts)
      all_work.insert(all_work.end(), work.begin(), work.end());
    Atlas_progress progress(m_options.visitor, all_work);
    std::vector<int> order(m_parts.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return work[i] > work[j]; });
    m_atlas.parts.resize(m_parts.size());
    const auto make = [&](int i) {
      Part_progress part_progress(progress, static_cast<std::size_t>(i));
      if(keeps_charts())
        m_atlas.parts[i] = given_part(m_parts[i]);
      if(m_options.given_charts != Atlas_options::KEEP && !(keeps_charts() && m_atlas.parts[i].succeeded()))
        m_atlas.parts[i] =
            Divided_part_atlas(m_parts[i].chart, m_parts[i].cost, m_options, m_solvers, part_progress).run();
      part_progress.set_stage(1, 1);
    };
    const int n = static_cast<int>(order.size());
    if(m_solvers->is_independent)
      parallel_for(n, [&](int k) { make(order[k]); });
    else
      for(int k = 0; k < n; ++k)
        make(order[k]);
    if(m_options.pack_into_square && !keeps_charts() && std::isfinite(m_options.seam_price))
      Page_coverer(m_parts, m_weight, m_options, m_atlas.parts).run();
    if(m_options.isometric_charts)
      Isometric_charts(m_parts, m_options, m_solvers, progress, m_atlas.parts).run();
    parallel_for(static_cast<int>(m_parts.size()), [&](int i) { fit_pages(i); });
  }

  void fit_pages(std::size_t i)
  {
    if(m_options.pack_into_square && m_options.texels_per_unit > 0 && m_atlas.parts[i].succeeded() &&
       !is_kept(m_atlas.parts[i]))
      Page_fitter(m_parts[i], m_weight, m_options, m_atlas.parts[i]).run();
  }

  bool keeps_charts() const { return m_options.given_charts != Atlas_options::REPLACE; }

  static bool is_kept(const Part_atlas& part) { return part.pieces.front().method == Atlas_report::GIVEN; }

  // Numbers the charts, part by part, and returns how many there are.
  int number_charts()
  {
    m_atlas.first_chart.clear();
    m_atlas.report.charts.clear();
    for(std::size_t i = 0; i < m_parts.size(); ++i) {
      const Part_atlas& part = m_atlas.parts[i];
      const std::size_t first = m_atlas.report.charts.size();
      m_atlas.first_chart.push_back(first);
      if(!part.succeeded())
        continue;
      for(const Atlas_piece& piece : part.pieces) {
        Atlas_report::Chart chart;
        chart.part = i;
        chart.method = piece.method;
        chart.strategy = piece.strategy;
        chart.seam_lengths = piece.seam_lengths;
        chart.overlap_is_predicted = piece.overlap_is_predicted;
        chart.contact = piece.contact;
        chart.rounds = piece.rounds;
        m_atlas.report.charts.push_back(chart);
      }
      for(int piece : part.piece)
        ++m_atlas.report.charts[first + static_cast<std::size_t>(piece)].number_of_faces;
    }
    return static_cast<int>(m_atlas.report.charts.size());
  }

  // Without one of them, the others would be moved onto it.
  bool are_all_kept()
  {
    const auto is_wrong = [](const Part_atlas& part) { return !part.succeeded(); };
    const auto wrong = std::find_if(m_atlas.parts.begin(), m_atlas.parts.end(), is_wrong);
    if(wrong == m_atlas.parts.end())
      return true;
    const auto count = std::count_if(wrong, m_atlas.parts.end(), is_wrong);
    fail(wrong->status, std::to_string(count) + " of " + std::to_string(m_parts.size()) +
                            " given charts cannot be kept; the first: " + wrong->message);
    return false;
  }

  // Returns whether there are charts, and all have places.
  bool place_charts()
  {
    if(m_options.given_charts == Atlas_options::KEEP && !are_all_kept())
      return false;
    const int charts = number_charts();
    if(charts == 0) {
      fail(Diagnosis::NOTHING_FLATTENED, "no part of the surface can be flattened");
      return false;
    }
    take_maps_as_made();
    if(!m_options.pack_into_square)
      scale_charts();
    else if(!pack_charts(charts))
      return false;
    for(Part_atlas& part : m_atlas.parts)
      if(part.succeeded())
        m_round(part.uv);
    make_polygons_convex();
    return true;
  }

  // With their final coordinates, and before these are certified and measured
  void make_polygons_convex()
  {
    std::vector<std::size_t> mended(m_parts.size(), 0);
    parallel_for(static_cast<int>(m_parts.size()), [&](int i) {
      Part_atlas& part = m_atlas.parts[i];
      if(!part.succeeded() || is_kept(part) || m_parts[i].is_diagonal.empty())
        return;
      Divided_polygons polygons{part.chart.vertex, part.chart.opposite, m_parts[i].is_diagonal, {}};
      for(int v = 0; v < part.chart.number_of_vertices(); ++v)
        polygons.is_fixed.push_back(part.chart.interior[v] < 0);
      mended[i] = Polygon_mender(polygons, part.uv).run();
      m_round(part.uv);
    });
    m_atlas.report.number_of_mended_polygons = std::accumulate(mended.begin(), mended.end(), std::size_t(0));
  }

  // Maps that are placed again start from coordinates that are not rounded.
  void take_maps_as_made()
  {
    m_uv_as_made.resize(m_parts.size());
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(m_uv_as_made[i].empty())
        m_uv_as_made[i] = m_atlas.parts[i].uv;
      else
        m_atlas.parts[i].uv = m_uv_as_made[i];
  }

  // Gives each chart the area of its surface, with the lower left corner at the origin. A chart that is a whole part is
  // already so.
  void scale_charts()
  {
    for(Part_atlas& part : m_atlas.parts)
      if(part.succeeded() && (part.pieces.size() > 1 || is_kept(part)))
        scale_pieces(part);
  }

  static void scale_pieces(Part_atlas& part)
  {
    struct Piece
    {
      Bbox_2 box;
      double surface = 0, plane = 0;
    };
    std::vector<Piece> pieces(part.pieces.size());
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
      const Piece& piece = pieces[piece_of_vertex[v]];
      const double factor = piece.surface > 0 ? std::sqrt(piece.surface / piece.plane) * part.chart.scale : 1;
      part.uv[v] = Chart::Point_2(factor * (part.uv[v].x() - piece.box.xmin()),
                                  factor * (part.uv[v].y() - piece.box.ymin()));
    }
  }

  bool pack_charts(int charts)
  {
    const Stage stage(visitor_of(Atlas_visitor::PACK), Atlas_visitor::PACK, m_atlas.report.seconds.pack);
    const Packed_triangles triangles = packed_triangles();
    const Packing packing = pack(triangles.corners, triangles.chart, triangles.area, charts, m_options);
    if(packing.status != Packing::DONE) {
      fail(Diagnosis::PACKING_FAILED, describe(packing));
      return false;
    }
    for(int c = 0; c < charts; ++c)
      m_atlas.report.charts[c].page = packing.page[c];
    m_atlas.report.number_of_pages = static_cast<std::size_t>(packing.number_of_pages);
    m_atlas.report.covered_share = packing.covered_share;
    m_atlas.report.scale =
        packing.texels_per_length / m_options.resolution / m_parts.front().chart.scale; // alike for all parts
    move_charts(packing);
    return true;
  }

  struct Packed_triangles
  {
    std::vector<Planar_point> corners; // three for each triangle
    std::vector<int> chart;
    std::vector<double> area;
  };

  Packed_triangles packed_triangles() const
  {
    Packed_triangles triangles;
    for(std::size_t i = 0; i < m_parts.size(); ++i) {
      const Part_atlas& part = m_atlas.parts[i];
      if(!part.succeeded())
        continue;
      for(int t = 0; t < part.chart.number_of_triangles(); ++t) {
        for(int c = 3 * t; c < 3 * t + 3; ++c) {
          const Chart::Point_2& p = part.uv[part.chart.vertex[c]];
          triangles.corners.emplace_back(p.x(), p.y());
        }
        triangles.chart.push_back(static_cast<int>(m_atlas.first_chart[i]) + part.piece[t]);
        const double weight = m_weight.empty() ? 1 : m_weight[m_parts[i].first_triangle + t];
        triangles.area.push_back(surface_area(part.chart, t) * weight * weight);
      }
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

  // Returns whether all charts are injective with their final coordinates. Parts with other charts first get maps whose
  // borders keep a distance, then several charts, and are finally skipped.
  bool certify()
  {
    const Stage stage(visitor_of(Atlas_visitor::CERTIFY), Atlas_visitor::CERTIFY,
                      m_atlas.report.seconds.certify);
    std::vector<std::string> wrong(m_parts.size());
    parallel_for(static_cast<int>(m_parts.size()), [&](int i) {
      if(m_atlas.parts[i].succeeded())
        wrong[i] = certify_part(m_atlas.parts[i]);
    });
    bool are_injective = true;
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(!wrong[i].empty()) {
        remake(i, wrong[i]);
        are_injective = false;
      }
    return are_injective;
  }

  void remake(std::size_t i, const std::string& wrong)
  {
    m_remakes.resize(m_parts.size(), 0);
    m_uv_as_made[i].clear();
    Atlas_settings options = m_options;
    options.keeps_distance = true;
    Atlas_progress progress(nullptr, {1});
    Divided_part_atlas maker(m_parts[i].chart, m_parts[i].cost, options, m_solvers,
                             Part_progress(progress, 0));
    while(m_remakes[i] < 2 && m_options.given_charts != Atlas_options::KEEP) {
      m_atlas.parts[i] = ++m_remakes[i] == 1 ? maker.run() : maker.divided(Divided_part_atlas::Division());
      fit_pages(i);
      if(m_atlas.parts[i].succeeded())
        return;
    }
    m_atlas.parts[i].status = Diagnosis::PRECISION_EXCEEDED;
    m_atlas.parts[i].message = wrong;
  }

  // Returns whether no two charts share a texel with its gutter.
  bool is_packing_certified()
  {
    if(!m_options.pack_into_square)
      return true;
    const Stage stage(visitor_of(Atlas_visitor::CERTIFY), Atlas_visitor::CERTIFY,
                      m_atlas.report.seconds.certify);
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

  void measure()
  {
    const Stage stage(visitor_of(Atlas_visitor::MEASURE), Atlas_visitor::MEASURE,
                      m_atlas.report.seconds.measure);
    Atlas_report& report = m_atlas.report;
    int triangles = 0;
    double surface = 0;
    for(const Part_atlas& part : m_atlas.parts)
      for(int t = 0; part.succeeded() && t < part.chart.number_of_triangles(); ++t, ++triangles)
        surface += surface_area(part.chart, t);
    Atlas_measurement measurement(triangles, surface, m_options.stretch_bound);
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(m_atlas.parts[i].succeeded()) {
        const Square_texels square_texels(m_options, m_atlas.parts[i].uv);
        measurement.add(m_atlas.parts[i], report, m_atlas.first_chart[i]);
        report.number_of_terminals += m_atlas.parts[i].number_of_terminals;
      }
    report.measures = measurement.measures();
    report.measures.border_is_simple = true; // certify() saw to that
    if(m_options.pack_into_square) {
      report.texel_density = report.covered_share / CGAL::square(report.measures.l2_stretch);
      report.low_texel_density =
          measurement.density_of_share(0.95) * aspect_ratio(m_options) / report.number_of_pages;
    }
    look_at_stretch();
  }

  void look_at_stretch()
  {
    const std::vector<Atlas_report::Chart>& charts = m_atlas.report.charts;
    const auto is_bad = [](const Atlas_report::Chart& chart) { return !chart.is_good; };
    const auto first = std::find_if(charts.begin(), charts.end(), is_bad);
    if(first == charts.end())
      return;
    std::ostringstream text;
    text << std::count_if(first, charts.end(), is_bad) << " of " << charts.size()
         << " charts stretch the surface badly: chart " << first - charts.begin() << " has an L2 stretch of "
         << first->l2_stretch << " and " << first->crushed_faces << " crushed faces";
    fail(Diagnosis::STRETCH_BOUND_MISSED, text.str());
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

  // With a place on the surface
  std::string chart_text(int number) const
  {
    std::size_t i = m_parts.size() - 1;
    while(m_atlas.first_chart[i] > static_cast<std::size_t>(number))
      --i;
    const Part_atlas& part = m_atlas.parts[i];
    const int piece = number - static_cast<int>(m_atlas.first_chart[i]);
    const auto t = std::find(part.piece.begin(), part.piece.end(), piece) - part.piece.begin();
    return "chart " + std::to_string(number) + ", with the vertex at " +
           position_text(part.chart, part.chart.vertex[3 * t]) + ",";
  }

  void fail(Diagnosis diagnosis, const std::string& message)
  {
    m_atlas.report.status = diagnosis;
    m_atlas.report.message = message;
  }

  const std::vector<Surface_part>& m_parts;
  const std::vector<double>& m_weight;
  Atlas_settings m_options;
  const Linear_solvers& m_solvers;
  Rounding m_round;
  Atlas_visitor::Stage m_stage = Atlas_visitor::READ;    // the last one that began
  std::vector<char> m_remakes;                           // of each part: how often it was made anew
  std::vector<std::vector<Chart::Point_2>> m_uv_as_made; // of each part, before it was placed
  Atlas m_atlas;
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Atlas build_atlas(const std::vector<Surface_part>& parts,
                                                     const std::vector<double>& weight,
                                                     const Atlas_settings& options,
                                                     const Linear_solvers& solvers, Rounding round)
{
  return Atlas_builder(parts, weight, options, solvers, round).run();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_BUILD_ATLAS_IMPL_H
