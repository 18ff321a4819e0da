// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All stages of an atlas in their order: charts of all parts, packing, certificate and measures. Included at the end of
// `mesh_atlas_builder.h`, or by the source file of the compiled library. Charts come from `divide_part.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/atlas_progress.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/certify_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/cut_for_pages.h>
#include <CGAL/Texture_atlas/internal/atlas/divide_part.h>
#include <CGAL/Texture_atlas/internal/atlas/isometric_charts.h>
#include <CGAL/Texture_atlas/internal/atlas/pack_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Makes an atlas, stage by stage.
class Atlas_builder
{
  typedef Atlas_stage Stage;

public:
  Atlas_builder(const std::vector<Surface_part>& parts, const std::vector<double>& weight,
                const Chart_options& options, const Linear_solvers& solvers, Rounding round)
      : m_parts(parts), m_weight(weight), m_options(options), m_solvers(solvers), m_round(round)
  {
    if(!parts.empty())
      m_options.texels_per_unit *= parts.front().chart.scale; // alike for all parts
    double area = 0;
    for(const Surface_part& part : parts)
      for(int t = 0; t < part.chart.number_of_triangles(); ++t)
        area += surface_area(part.chart, t) * part.chart.scale * part.chart.scale;
    if(options.given_charts == Atlas_options::KEEP)
      m_options.stretch_bound = most_stretch_of_given_charts;
    if(options.pack_into_square && options.texels_per_unit == 0 && std::isfinite(options.stretch_bound))
      m_options.longest_chart = largest_aspect * std::sqrt(area);
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
    parallel_for(static_cast<int>(order.size()), [&](int k) {
      const std::size_t i = order[k];
      Part_progress progress_of_part(progress, i);
      Part_atlas& part = m_atlas.parts[i];
      if(keeps_charts())
        part = given_part(m_parts[i], m_options.pack_into_square ? aspect_ratio(m_options) : 1);
      const bool is_given = keeps_charts() && part.succeeded();
      if(!is_given && m_options.given_charts != Atlas_options::KEEP)
        part = divider(i, m_options, progress_of_part).run();
      progress_of_part.set_stage(1, 1);
    });
    if(m_options.pack_into_square && !keeps_charts() && std::isfinite(m_options.seam_price))
      Page_coverer(m_parts, m_weight, m_options, m_atlas.parts).run();
    if(m_options.isometric_charts)
      Isometric_charts(m_parts, m_options, m_solvers, progress, m_atlas.parts).run();
    parallel_for(static_cast<int>(m_parts.size()), [&](int i) { fit_pages(i); });
  }

  // Returns whether there are charts, and all have places.
  bool place_charts()
  {
    if(m_options.given_charts == Atlas_options::KEEP && !are_all_kept())
      return false;
    number_charts();
    if(m_atlas.report.charts.empty()) {
      m_atlas.has_no_charts = true;
      return false;
    }
    take_maps_as_made();
    if(!m_options.pack_into_square)
      scale_charts();
    else if(!pack_charts())
      return false;
    std::vector<std::size_t> mended(m_parts.size(), 0); // polygons of each part
    parallel_for(static_cast<int>(m_parts.size()), [&](int i) {
      Part_atlas& part = m_atlas.parts[i];
      if(!part.succeeded())
        return;
      round_part(m_options, m_round, part);
      if(!is_kept(part) && !m_parts[i].is_diagonal.empty())
        mended[i] = make_polygons_convex(m_parts[i].is_diagonal, m_options, m_round, part);
      if(m_options.quantization_bits)
        quantize_part(m_parts[i].is_diagonal, *m_options.quantization_bits, part);
    });
    m_atlas.report.number_of_mended_polygons = std::accumulate(mended.begin(), mended.end(), std::size_t(0));
    return true;
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

  // Returns whether no two charts share a texel with its gutter.
  bool is_packing_certified()
  {
    if(!m_options.pack_into_square)
      return true;
    const Stage stage(visitor_of(Atlas_visitor::CERTIFY), Atlas_visitor::CERTIFY,
                      m_atlas.report.seconds.certify);
    return Atlas_packer(m_parts, m_weight, m_options, m_atlas).certify();
  }

  void measure()
  {
    const Stage stage(visitor_of(Atlas_visitor::MEASURE), Atlas_visitor::MEASURE,
                      m_atlas.report.seconds.measure);
    measure_atlas(m_options, m_atlas);
  }

  Atlas release() { return std::move(m_atlas); }

private:
  // Nothing is done about it, but larger stretch is reported.
  static constexpr double most_stretch_of_given_charts = 2;

  // A chart that is longer than this times the square root of the total area would leave most of the page empty.
  static constexpr double largest_aspect = 4;

  // Charts may be packed and certified several times. Visitors hear of each stage only once.
  Atlas_visitor* visitor_of(Atlas_visitor::Stage stage)
  {
    const bool is_new = stage > m_stage;
    m_stage = (std::max)(m_stage, stage);
    return is_new ? m_options.visitor : nullptr;
  }

  Part_divider divider(std::size_t i, const Chart_options& options, const Part_progress& progress) const
  {
    return Part_divider(m_parts[i].chart, m_parts[i].cost, options, m_solvers, progress);
  }

  // Returns whether pages can hold all charts of a part that has charts.
  bool fit_pages(std::size_t i)
  {
    return !m_options.pack_into_square || m_options.texels_per_unit == 0 || !m_atlas.parts[i].succeeded() ||
           is_kept(m_atlas.parts[i]) || Page_fitter(m_parts[i], m_weight, m_options, m_atlas.parts[i]).run();
  }

  bool keeps_charts() const { return m_options.given_charts != Atlas_options::REPLACE; }

  static bool is_kept(const Part_atlas& part) { return part.pieces.front().method == Atlas_report::GIVEN; }

  // Part by part
  void number_charts()
  {
    m_atlas.first_chart.clear();
    m_atlas.report.charts.clear();
    for(std::size_t i = 0; i < m_parts.size(); ++i) {
      const Part_atlas& part = m_atlas.parts[i];
      const std::size_t first = m_atlas.report.charts.size();
      m_atlas.first_chart.push_back(first);
      if(!part.succeeded())
        continue;
      for(const Atlas_report::Chart& piece : part.pieces) {
        m_atlas.report.charts.push_back(piece);
        m_atlas.report.charts.back().part = i;
      }
      for(int piece : part.piece)
        ++m_atlas.report.charts[first + static_cast<std::size_t>(piece)].number_of_faces;
    }
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

  // A chart that is a whole part has its size already.
  void scale_charts()
  {
    for(Part_atlas& part : m_atlas.parts)
      if(part.succeeded() && (part.pieces.size() > 1 || is_kept(part)))
        scale_pieces(part);
  }

  // A part with a chart that is nearly a line or a point is made again, or skipped.
  bool pack_charts()
  {
    const Stage stage(visitor_of(Atlas_visitor::PACK), Atlas_visitor::PACK, m_atlas.report.seconds.pack);
    while(!m_atlas.report.charts.empty()) {
      Atlas_packer packer(m_parts, m_weight, m_options, m_atlas);
      if(packer.run())
        return true;
      const std::optional<std::size_t> degenerate = packer.degenerate_part();
      if(!degenerate || m_options.given_charts == Atlas_options::KEEP)
        return false;
      remake(*degenerate, m_atlas.report.message);
      fail(Diagnosis::NOTHING_WRONG, "");
      number_charts();
      take_maps_as_made();
    }
    m_atlas.has_no_charts = true;
    return false;
  }

  void remake(std::size_t i, const std::string& wrong)
  {
    m_remakes.resize(m_parts.size(), 0);
    const int wrong_corner = m_atlas.parts[i].wrong_corner;
    m_uv_as_made[i].clear();
    Chart_options options = m_options;
    options.keeps_distance = true;
    Atlas_progress progress(nullptr, {1});
    const Part_divider maker = divider(i, options, Part_progress(progress, 0));
    while(m_remakes[i] < 2 && m_options.given_charts != Atlas_options::KEEP) {
      m_atlas.parts[i] = ++m_remakes[i] == 1 ? maker.run() : maker.divided(Part_divider::Division());
      if(fit_pages(i) && m_atlas.parts[i].succeeded())
        return;
    }
    m_atlas.parts[i].status = Diagnosis::PRECISION_EXCEEDED;
    m_atlas.parts[i].message = wrong;
    m_atlas.parts[i].wrong_corner = wrong_corner;
  }

  void fail(Diagnosis diagnosis, const std::string& message)
  {
    m_atlas.report.status = diagnosis;
    m_atlas.report.message = message;
  }

  const std::vector<Surface_part>& m_parts;
  const std::vector<double>& m_weight;
  Chart_options m_options;
  const Linear_solvers& m_solvers;
  Rounding m_round;
  Atlas_visitor::Stage m_stage = Atlas_visitor::READ;    // the last one that began
  std::vector<char> m_remakes;                           // of each part: how often it was made anew
  std::vector<std::vector<Chart::Point_2>> m_uv_as_made; // of each part, before it was placed
  Atlas m_atlas;
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Atlas build_atlas(const std::vector<Surface_part>& parts,
                                                     const std::vector<double>& weight,
                                                     const Chart_options& options,
                                                     const Linear_solvers& solvers, Rounding round)
{
  Atlas_builder builder(parts, weight, options, solvers, round);
  builder.make_charts();
  bool is_placed = true;
  do
    is_placed = builder.place_charts();
  while(is_placed && !builder.certify());
  if(is_placed && builder.is_packing_certified())
    builder.measure();
  return builder.release();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_IMPL_H
