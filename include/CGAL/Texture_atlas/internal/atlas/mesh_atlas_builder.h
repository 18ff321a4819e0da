// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The side of `make_atlas()` and `make_common_atlas()` that knows the caller's meshes. Included by `make_atlas.h`. The
// atlas itself is made by `build_atlas()`, which sees only charts.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_ATLAS_BUILDER_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_ATLAS_BUILDER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/mesh_in_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/atlas/atlas_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Makes an atlas of one or several meshes. All parts are put together, in the order of the meshes, as if they were of
// one mesh.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap, typename FaceChartMap,
          typename NamedParameters>
class Mesh_atlas_builder
{
  typedef Mesh_in_atlas<TriangleMesh, EdgeIsSeamMap, HalfedgeUVMap, FaceChartMap, NamedParameters> Read_mesh;
  typedef typename boost::property_traits<HalfedgeUVMap>::value_type Point;
  typedef Mesh_atlas_report<TriangleMesh> Report;
  typedef Atlas_stage Stage;

public:
  // `round` rounds coordinates to the caller's number type.
  Mesh_atlas_builder(const Atlas_options& options, const Linear_solvers& solvers,
                     const Rounding round = &round_to_points<Point>)
      : m_options(options), m_solvers(solvers), m_round(round)
  {}

  // The named parameters are those of the mesh, and have to live as long as this builder.
  void add(const TriangleMesh& mesh, EdgeIsSeamMap seams, HalfedgeUVMap uv, FaceChartMap charts,
           const NamedParameters& np)
  {
    m_meshes.emplace_back(mesh, seams, uv, charts, keeps_charts(), np);
  }

  Report run()
  {
    Report report;
    report.message = wrong_option(m_options);
    if(report.message.empty() && keeps_charts() && !is_readable<HalfedgeUVMap>)
      report.message = unreadable_text;
    if(!report.message.empty()) {
      report.status = Diagnosis::WRONG_OPTION;
      return report;
    }
    const auto make = [&] {
      double seconds = 0;
      {
        const Stage stage(m_options.visitor, Atlas_visitor::READ, seconds);
        if(!read(report))
          return;
      }
      lend_parts();
      Chart_options options = m_options;
      options.texels_per_unit *= m_weight_scale;
      take_charts(build_atlas(m_parts, m_weight, options, m_solvers, m_round), report);
      report.seconds.read = seconds;
      if(!report.has_atlas())
        return;
      measure_seams(report);
      list_faces_off_grid(report);
      const Stage stage(m_options.visitor, Atlas_visitor::WRITE, report.seconds.write);
      for(Read_mesh& mesh : m_meshes)
        mesh.prepare_to_write();
      for(Read_mesh& mesh : m_meshes)
        mesh.write();
    };
    const auto end = run_bounded(m_options.time_limit, [&] { with_threads(m_options.threads, make); });
    if(!end) {
      report = Report();
      report.status = end.status;
      report.message = end.message;
    }
    return report;
  }

private:
  bool keeps_charts() const { return m_options.given_charts != Atlas_options::REPLACE; }

  // For messages
  std::string name_of_mesh(std::size_t number) const
  {
    return m_meshes.size() < 2 ? "" : "mesh " + std::to_string(number) + ": ";
  }

  // Returns whether there is something to flatten.
  bool read(Report& report)
  {
    std::size_t triangles = 0;
    double largest = 0;
    bool has_faces = false;
    for(std::size_t i = 0; i < m_meshes.size(); ++i) {
      if(!m_meshes[i].input.read_faces(report))
        return fail(report, report.status, name_of_mesh(i) + report.message);
      has_faces = has_faces || m_meshes[i].input.has_faces();
      triangles += m_meshes[i].input.number_of_triangles();
      largest = (std::max)(largest, m_meshes[i].input.surface.largest_coordinate());
    }
    if(!has_faces)
      return fail(report, Diagnosis::EMPTY_MESH, "the mesh has no faces");
    if(triangles == 0) {
      list_parts(report);
      return fail_for_first_part(report);
    }
    if(triangles > static_cast<std::size_t>(largest_number_of_triangles))
      return fail(report, Diagnosis::TOO_LARGE, "the surface has more triangles than 32-bit numbers allow");
    for(std::size_t i = 0; i < m_meshes.size(); ++i)
      if(!m_meshes[i].input.read_attributes(power_of_two(largest), m_weight, report))
        return fail(report, report.status, name_of_mesh(i) + report.message);
    scale_weights();
    return true;
  }

  static bool fail(Report& report, Diagnosis status, const std::string& message)
  {
    report.status = status;
    report.message = message;
    return false;
  }

  // So that no square underflows or overflows
  void scale_weights()
  {
    const double largest = m_weight.empty() ? 0 : *std::max_element(m_weight.begin(), m_weight.end());
    m_weight_scale = power_of_two(largest);
    for(double& weight : m_weight)
      weight /= m_weight_scale;
  }

  // Takes the parts of all meshes, as if they were of one mesh.
  void lend_parts()
  {
    int first_triangle = 0;
    for(Read_mesh& mesh : m_meshes) {
      const int triangles = static_cast<int>(mesh.input.number_of_triangles());
      m_numbers_of_parts.push_back(mesh.input.surface.parts().size());
      for(Surface_part& part : mesh.release_parts()) {
        part.first_triangle += first_triangle;
        m_parts.push_back(std::move(part));
      }
      first_triangle += triangles;
    }
  }

  // Gives all meshes their parts back, with the charts, and reports on them.
  void take_charts(Atlas&& atlas, Report& report)
  {
    std::size_t begin = 0;
    for(std::size_t i = 0; i < m_meshes.size(); begin += m_numbers_of_parts[i++])
      m_meshes[i].set_charts(taken(m_parts, begin, m_numbers_of_parts[i]),
                             taken(atlas.parts, begin, m_numbers_of_parts[i]),
                             taken(atlas.first_chart, begin, m_numbers_of_parts[i]));
    static_cast<Atlas_report&>(report) = std::move(atlas.report);
    if(m_options.pack_into_square)
      report.scale /= m_weight_scale;
    list_parts(report);
    if(atlas.has_no_charts)
      fail_for_first_part(report);
    if(report.status == Diagnosis::STRETCH_BOUND_MISSED && m_meshes.size() == 1)
      m_meshes.front().name_bad_charts(report);
  }

  // Some of the elements. There are none if the atlas was not begun.
  template <typename Element>
  static std::vector<Element> taken(std::vector<Element>& elements, std::size_t begin, std::size_t size)
  {
    const std::size_t first = (std::min)(begin, elements.size()),
                      last = (std::min)(begin + size, elements.size());
    const auto all = elements.begin();
    return std::vector<Element>(std::make_move_iterator(all + static_cast<std::ptrdiff_t>(first)),
                                std::make_move_iterator(all + static_cast<std::ptrdiff_t>(last)));
  }

  // Numbers the parts by their first faces, mesh by mesh, and says which were skipped.
  void list_parts(Report& report) const
  {
    std::vector<std::size_t> numbers, meshes; // of the parts that were read
    report.number_of_parts = 0;
    report.degenerate_triangles = 0;
    for(std::size_t i = 0; i < m_meshes.size(); ++i) {
      report.degenerate_triangles += m_meshes[i].number_of_degenerate_faces();
      for(typename Read_mesh::Listed_part& listed : m_meshes[i].listed_parts()) {
        listed.part.part = report.number_of_parts++;
        listed.part.mesh = i;
        if(listed.is_read) {
          numbers.push_back(listed.part.part);
          meshes.push_back(i);
        }
        if(listed.part.status != Diagnosis::NOTHING_WRONG) {
          report.skipped.push_back(std::move(listed.part));
          report.skipped_elements.push_back(std::move(listed.elements));
        }
      }
    }
    for(typename Report::Chart& chart : report.charts) {
      chart.mesh = meshes[chart.part];
      chart.part = numbers[chart.part];
    }
    if(!report.skipped.empty() && report.has_atlas())
      fail(report, Diagnosis::SOMETHING_SKIPPED,
           std::to_string(report.skipped.size()) + " of " + std::to_string(report.number_of_parts) +
               " parts of the surface have no charts; the first: " + message_of_first_part(report));
    if(m_meshes.size() == 1) // elements of several meshes would be mixed up
      for(const typename Report::Part_elements& elements : report.skipped_elements) {
        report.offending_faces.push_back(elements.faces.front());
        report.offending_vertices.insert(report.offending_vertices.end(), elements.vertices.begin(),
                                         elements.vertices.end());
      }
  }

  std::string message_of_first_part(const Report& report) const
  {
    return name_of_mesh(report.skipped.front().mesh) + report.skipped.front().message;
  }

  bool fail_for_first_part(Report& report) const
  {
    return fail(report, report.skipped.front().status,
                "no part of the surface can be flattened" +
                    std::string(report.skipped.size() > 1 ? "; the first: " : ": ") +
                    message_of_first_part(report));
  }

  void measure_seams(Report& report) const
  {
    double sides = 0, area = 0;
    for(const Read_mesh& mesh : m_meshes)
      mesh.measure_seams(sides, area);
    report.seam_length = sides / 2 * m_meshes.front().input.surface.scale();
    report.relative_seam_length = sides / 2 / std::sqrt(area);
  }

  void list_faces_off_grid(Report& report) const
  {
    if(!m_options.quantization_bits)
      return;
    const Quantization_grid grid(*m_options.quantization_bits);
    std::size_t first = 0;
    for(const Read_mesh& mesh : m_meshes) {
      mesh.list_faces_off_grid(grid, first, report.faces_off_grid);
      first += mesh.number_of_faces();
    }
    std::sort(report.faces_off_grid.begin(), report.faces_off_grid.end());
  }

  const Chart_options m_options;
  const Linear_solvers m_solvers;
  const Rounding m_round;
  std::deque<Read_mesh> m_meshes;
  std::vector<double> m_weight; // of each triangle, divided by the scale; empty if all are 1
  double m_weight_scale = 1;
  std::vector<Surface_part> m_parts;           // of all meshes, while the atlas is made
  std::vector<std::size_t> m_numbers_of_parts; // of each mesh
};

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/atlas/build_atlas_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_ATLAS_BUILDER_H
