// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/flatten_sheet.h"

#include "flatten_mesh/output_floats.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Real_timer.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/internal/polygons/make_polygons_convex.h>
#include <CGAL/Texture_atlas/internal/polygons/round_to_floats.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/SparseCholesky>

#ifdef ABF_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace {

namespace ABF = CGAL::Texture_atlas::internal;

// The solver that `--solver` names. The parameterizers are compiled once for all of them.
ABF::Linear_solvers linear_solvers(const std::string& name)
{
  using Matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;
#ifdef ABF_WITH_CHOLMOD
  if(name == "cholmod") {
    return CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Matrix>>();
  }
#endif
  if(name == "eigen") {
    return CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Matrix>>();
  }
  return CGAL::SuperLU_solver_traits<>();
}

// The numbers of the first few of many vertices, as in "vertices 3, 17, ..."
std::string vertices_text(const Sheet& sheet, const std::vector<Vertex>& vertices)
{
  std::vector<std::size_t> numbers; // a vertex on a seam has several copies
  for(const Vertex v : vertices) {
    const std::size_t number = sheet.input_vertex(v).idx() + 1;
    if(numbers.size() < 7 && std::find(numbers.begin(), numbers.end(), number) == numbers.end()) {
      numbers.push_back(number);
    }
  }
  std::string text = numbers.size() == 1 ? "vertex " : "vertices ";
  for(std::size_t i = 0; i < numbers.size(); ++i) {
    text += (i == 0 ? "" : ", ") + (i == 6 ? "..." : std::to_string(numbers[i]));
  }
  return text;
}

// Where the fault is, unless the message says so, in the numbers that the user knows. Of faces these are the vertices:
// larger polygons were divided.
template <class Report>
std::string place_text(const Sheet& sheet, const Report& report)
{
  const auto is_told = [&](const Vertex v) {
    return report.message.find(vertex_name(sheet.input_vertex(v).idx()) + " (") != std::string::npos;
  };
  const std::vector<Vertex>& vertices = report.offending_vertices;
  if(!vertices.empty()) {
    return std::all_of(vertices.begin(), vertices.end(), is_told)
               ? ""
               : " (" + vertices_text(sheet, vertices) + ")";
  }
  if(report.offending_faces.empty()) {
    return "";
  }
  const auto corners =
      sheet.mesh().vertices_around_face(sheet.mesh().halfedge(report.offending_faces.front()));
  return " (the triangle of " + vertices_text(sheet, {corners.begin(), corners.end()}) +
         (report.offending_faces.size() > 1 ? ", and others)" : ")");
}

// What the program says of both methods in the same way
void take_report(const SMP::ABF_plus_plus_report& report, Flattening& flattening)
{
  flattening.report = report;
}

void take_report(const SMP::Hierarchical_report& report, Flattening& flattening)
{
  flattening.hierarchical = report;
  static_cast<SMP::Flattening_report&>(flattening.report) = report;
  flattening.report.iterations = report.polish_iterations;
  flattening.report.energy = report.energy;
  flattening.report.constraint_residual = report.constraint_residual;
}

// Whether another way to a map may succeed where one failed
bool is_worth_another_way(const SMP::Diagnosis status)
{
  return is_failure_of_computation(status) || status == SMP::Diagnosis::PRECISION_EXCEEDED;
}

// From more triangles on, the direct method takes several seconds, and the other one a third to a half of that.
constexpr std::size_t direct_is_slow = 200000;

// Chooses the method, and another one if it fails.
class Sheet_flattener
{
  using Direct = SMP::ABF_plus_plus_parameterizer_3<Mesh, ABF::Linear_solvers>;
  using Coarse = SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh, ABF::Linear_solvers>;

public:
  Sheet_flattener(const Sheet& sheet, const Command_line& command, Progress& progress)
      : m_sheet(sheet), m_command(command), m_options(command.options),
        m_solver(linear_solvers(command.solver))
  {
    m_options.visitor = &progress;
    m_flattening.uv = sheet.mesh().add_property_map<Vertex, Kernel::Point_2>("v:flatten_mesh_uv").first;
  }

  Flattening run()
  {
    const bool is_direct_fast = m_sheet.faces.size() <= direct_is_slow && !m_options.injective;
    if(m_command.method == "direct" || (m_command.method == "auto" && is_direct_fast) || m_sheet.angles ||
       m_options.equal_seam_lengths.value_or(false)) {
      flatten_with_equal_seams();
    } else if(!flatten_hierarchically() && m_command.method == "auto") {
      m_flattening.note =
          m_flattening.succeeded()
              ? "the direct method replaced the hierarchical one, whose result was not close enough"
              : "the direct method replaced the hierarchical one, which failed: " +
                    m_flattening.report.message;
      flatten_with_equal_seams();
    }
    return std::move(m_flattening);
  }

private:
  template <class Parameterizer>
  void run_parameterizer(Parameterizer& parameterizer)
  {
    Mesh& mesh = m_sheet.mesh();
    const auto is_parameterized = mesh.add_property_map<Vertex, bool>("v:flatten_mesh_done", false).first;
    m_flattening.attempt_seconds = m_flattening.parameterize_seconds;
    CGAL::Real_timer timer;
    timer.start();
    parameterizer.set_vertex_numbers(boost::make_function_property_map<Vertex>(
        [this](const Vertex v) { return std::size_t(m_sheet.input_vertex(v).idx()) + 1; }));
    parameterizer.parameterize(mesh, m_sheet.border, m_flattening.uv, get(boost::vertex_index, mesh),
                               is_parameterized);
    m_flattening.parameterize_seconds += timer.time();
    take_report(parameterizer.report(), m_flattening);
    m_flattening.place = place_text(m_sheet, parameterizer.report());
  }

  void flatten_directly(const SMP::ABF_plus_plus_options& options)
  {
    m_flattening.method = "direct";
    m_flattening.has_equal_seams = options.equal_seam_lengths.value_or(false);
    Direct direct(options, m_solver);
    if(m_sheet.angles) {
      direct.set_angle_sums(*m_sheet.angles);
    }
    if(m_sheet.cut) {
      direct.set_seam_sides(boost::make_function_property_map<Halfedge>(
          [this](const Halfedge h) { return m_sheet.seam_sides[h.idx()]; }));
    }
    run_parameterizer(direct);
  }

  // Both sides of seams get equal lengths, unless something else is asked for, or that fails.
  void flatten_with_equal_seams()
  {
    SMP::ABF_plus_plus_options options = m_options;
    if(!m_sheet.cut) {
      options.equal_seam_lengths.reset();
    }
    const bool is_default = !options.equal_seam_lengths && m_sheet.cut;
    if(is_default) {
      options.equal_seam_lengths = true;
    }
    flatten_directly(options);
    if(is_default && options.fallbacks && !m_flattening.succeeded() &&
       is_worth_another_way(m_flattening.report.status)) {
      m_flattening.note +=
          (m_flattening.note.empty() ? "" : "; ") +
          ("the two sides of a seam have different lengths, because the map with equal lengths failed: " +
           m_flattening.report.message);
      options.equal_seam_lengths = false;
      flatten_directly(options);
    }
  }

  // Returns whether `auto` takes the result: if it comes close to the direct one, or if the direct method would fail
  // too.
  bool flatten_hierarchically()
  {
    m_flattening.method = "hierarchical";
    SMP::Hierarchical_options options = m_command.hierarchical;
    static_cast<SMP::Flattening_options&>(options) = m_options;
    options.visitor = nullptr;                 // the coarse parameterizer tells its steps
    if(options.polish && !options.injective) { // injective maps are polished by another solver
      options.polish_options = m_options;
      static_cast<SMP::Flattening_options&>(options.polish_options) = SMP::Flattening_options();
      options.polish_options.barrier = m_options.barrier;
      options.polish_options.visitor = m_options.visitor;
      options.polish_options.equal_seam_lengths.reset();
    }
    SMP::Hierarchical_parameterizer_3<Mesh, Coarse> parameterizer(options, Coarse(m_options, m_solver));
    run_parameterizer(parameterizer);
    if(!m_flattening.succeeded()) {
      return !is_worth_another_way(m_flattening.report.status);
    }
    m_flattening.note = m_flattening.hierarchical.note;
    return options.injective || m_flattening.hierarchical.polished ||
           is_close_to_direct(parameterizer.coarse_parameterizer().report(), options);
  }

  // Whether the energy of the map is at most about 20 % above that of the direct method, by an estimate: sweeps until
  // they gain little leave up to 15 %, and errors on the scale of the coarse chart were at most 1.6 % of its energy
  // (per triangle) on all terrains that were measured.
  bool is_close_to_direct(const SMP::ABF_plus_plus_report& coarse,
                          const SMP::Hierarchical_options& options) const
  {
    const SMP::Hierarchical_report& report = m_flattening.hierarchical;
    return report.start == SMP::Hierarchical_report::COARSE_PARAMETERIZER &&
           report.angle_sweeps < options.angle_sweeps &&
           coarse.energy / coarse.triangles <= 9 * (report.energy / report.triangles);
  }

  const Sheet& m_sheet;
  const Command_line& m_command;
  SMP::ABF_plus_plus_options m_options;
  const ABF::Linear_solvers m_solver;
  Flattening m_flattening;
};

// How much the scale jumps at seams, which the hierarchical method leaves free
double seam_jump(const Sheet& sheet, const UV_map& uv)
{
  const Mesh& mesh = sheet.mesh();
  ABF::Chart_reader<Mesh> reader(mesh);
  reader.read(sheet.border);
  reader.link_seams([&](const Halfedge h) {
    const Halfedge across = sheet.seam_sides[mesh.opposite(h).idx()];
    return across == Mesh::null_halfedge() ? across : mesh.opposite(across);
  });
  std::vector<ABF::Chart::Point_2> places;
  for(const Vertex v : reader.vertex_descriptors) {
    places.emplace_back(uv[v].x(), uv[v].y());
  }
  return ABF::largest_seam_jump(reader.chart, places);
}

void measure(const Sheet& sheet, Flattening& flattening)
{
  Mesh& mesh = sheet.mesh();
  CGAL::Real_timer timer;
  timer.start();
  flattening.distortion = mesh.add_property_map<Face, double>("f:flatten_mesh_distortion", 0.).first;
  double area = 0, stretched = 0;
  const auto add = [&](const Face f, const SMP::Flattening_face_measures& measures) {
    flattening.distortion[f] = measures.rms_angle_change * 180. / CGAL_PI;
    area += measures.area;
    stretched += measures.area > 0 ? measures.area / (measures.scale * measures.scale) : 0;
  };
  flattening.measures =
      SMP::measure_flattening(mesh, sheet.border, flattening.uv, CGAL::parameters::visitor(add));
  flattening.scale_stretch = std::sqrt(stretched / area);
  if(flattening.method == "hierarchical" && sheet.cut) {
    flattening.report.largest_seam_jump = seam_jump(sheet, flattening.uv);
  }
  flattening.measure_seconds += timer.time();
}

// A map of a sheet as arrays. Vertices have the numbers that they have in the mesh.
class Planar_sheet
{
public:
  Planar_sheet(const Sheet& sheet, Flattening& flattening)
      : uv(sheet.mesh().number_of_vertices()), m_sheet(sheet), m_flattening(flattening)
  {
    const Mesh& mesh = sheet.mesh();
    const Edge_marks is_diagonal = diagonals(*sheet.input);
    std::vector<int> corner(mesh.number_of_halfedges(), -1); // that faces each halfedge
    for(const Face f : sheet.faces) {
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        corner[h.idx()] = polygons.number_of_corners();
        polygons.vertex.push_back(number(mesh.target(mesh.next(h))));
        targets.push_back(number(mesh.target(h)));
      }
    }
    polygons.is_fixed.assign(mesh.number_of_vertices(), false);
    for(const Face f : sheet.faces) {
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        polygons.opposite.push_back(corner[mesh.opposite(h).idx()]);
        polygons.is_diagonal.push_back(is_diagonal[sheet.input_edge(mesh.edge(h))]);
        if(mesh.is_border(mesh.opposite(h))) {
          border.push_back({number(mesh.source(h)), number(mesh.target(h))});
          polygons.is_fixed[mesh.target(h).idx()] = true;
        }
      }
    }
    for(const Vertex v : sheet.vertices) {
      uv[v.idx()] = {flattening.uv[v].x(), flattening.uv[v].y()};
    }
  }

  // Takes the coordinates, and measures them.
  void take()
  {
    for(const Vertex v : m_sheet.vertices) {
      m_flattening.uv[v] = Kernel::Point_2(uv[v.idx()].x(), uv[v.idx()].y());
    }
    measure(m_sheet, m_flattening);
  }

  ABF::Divided_polygons polygons; // their borders stay where they are
  std::vector<int> targets;       // of the edge that each corner faces
  std::vector<ABF::Border_edge> border;
  std::vector<ABF::Chart::Point_2> uv;

private:
  static int number(const Vertex v) { return static_cast<int>(v.idx()); }

  const Sheet& m_sheet;
  Flattening& m_flattening;
};

} // namespace

Flattening flatten_sheet(const Sheet& sheet, const Command_line& command, Progress& progress)
{
  Flattening flattening = Sheet_flattener(sheet, command, progress).run();
  if(flattening.succeeded()) {
    measure(sheet, flattening);
  }
  return flattening;
}

void round_coordinates(const Command_line& command, const Sheet& sheet, Flattening& flattening)
{
  Planar_sheet map(sheet, flattening);
  ABF::Float_rounder rounder(map.targets, grid_of_outputs(command), map.uv);
  rounder.keep_gaps(map.border);
  const std::vector<int> bad = rounder.run();
  const bool was_simple = flattening.measures.border_is_simple;
  map.take();
  if(!bad.empty() || (was_simple && !flattening.measures.border_is_simple)) {
    flattening.report.status = SMP::Diagnosis::PRECISION_EXCEEDED;
    flattening.report.message =
        "the output holds coordinates in float, which has too few digits for " +
        (bad.empty() ? std::string("the border") : count_text(bad.size(), "triangle")) + "; use an OBJ file";
  }
}

std::size_t mend_polygons(const Command_line& command, const Sheet& sheet, Flattening& flattening)
{
  Planar_sheet map(sheet, flattening);
  const std::size_t count = ABF::Polygon_mender(map.polygons, grid_of_outputs(command), map.uv).run();
  if(count > 0) {
    map.take();
  }
  return count;
}

} // namespace flatten_mesh
