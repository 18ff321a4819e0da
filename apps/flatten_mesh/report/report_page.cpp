// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/report/report_page.h"

#include "flatten_mesh/report/Displayed_surface.h"
#include "flatten_mesh/report/Measure_summary.h"
#include "flatten_mesh/report/Wedge_mesh.h"
#include "flatten_mesh/report/measure_triangles.h"
#include "flatten_mesh/report/page_arrays.h"
#include "flatten_mesh/report/page_json.h"
#include "flatten_mesh/report/page_text.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace {

// More take long to open, and their files are large: this many make one of about 16 MB.
constexpr std::size_t most_triangles = 250000;

std::vector<std::size_t> worst_triangles(const std::array<Measure_summary, 3>& summaries)
{
  std::vector<std::size_t> worst;
  for(const Measure_summary& summary : summaries) {
    worst.insert(worst.end(), summary.worst.begin(), summary.worst.end());
  }
  return worst;
}

// The elements with the data
std::string page_data(const Report_contents& contents)
{
  const Wedge_mesh mesh = wedge_mesh(contents.surface);
  const Triangle_measures measures = measure_triangles(mesh);
  Page_measures all{measures_of_page(measures), {}, measures.scale};
  abf::parallel_for(static_cast<int>(all.measures.size()), [&](const int i) {
    const auto k = static_cast<std::size_t>(i);
    all.summaries[k] = summarize(all.measures[k], measures.areas);
  });
  const Displayed_surface shown =
      mesh.triangles.size() <= most_triangles
          ? whole_surface(mesh, measures)
          : thinned_surface(mesh, measures, worst_triangles(all.summaries), most_triangles);
  const Display_factors factors = display_factors(mesh, contents.box);
  return "<script type=\"application/json\" id=\"report\">" +
         internal::json_for_html(page_json(contents, all, shown, factors)) + "</script>\n" +
         page_arrays(shown, factors, contents.faces);
}

} // namespace

std::string report_page(const Report_contents& contents, const int threads)
{
  std::string data;
  abf::with_threads(threads, [&] { data = page_data(contents); });
  return page_text(report_page_parts, contents.title, data);
}

} // namespace flatten_mesh
