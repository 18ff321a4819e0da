// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/run_plain.h"

#include "flatten_mesh/atlas/Atlas_input.h"
#include "pictures/textured_atlas.h"
#include "flatten_mesh/atlas/write_atlas.h"
#include "flatten_mesh/model/read_model.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/Output_files.h"
#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/pictures/draw_plane.h"
#include "flatten_mesh/pictures/draw_surface.h"
#include "flatten_mesh/pictures/Up_axis.h"
#include "flatten_mesh/plain/cut_surface.h"
#include "flatten_mesh/plain/flatten_sheet.h"
#include "flatten_mesh/plain/prescribe_angles.h"
#include "flatten_mesh/plain/report_chart.h"
#include "flatten_mesh/process_memory.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/weld_option.h"

#ifdef ABF_WITH_THREE
#include "flatten_mesh/report/contents_of_chart.h"
#include "flatten_mesh/report/report_page.h"
#endif

#include <CGAL/Real_timer.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace pictures;
using namespace CGAL::Texture_atlas::internal::prepare;

namespace {

// Scanners often put a vertex that they did not measure at the origin. Its faces are needles, for which a map needs a
// huge range of scales. Returns a text that names the vertex with the sharpest needles, and is empty if even there the
// shortest edge is less than ten times as long as all edges around the vertex together.
std::string stray_vertex_text(const Sheet& sheet)
{
  const Mesh& mesh = sheet.mesh();
  const auto length = [&](const Vertex v, const Vertex w) {
    return std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
  };
  Vertex stray = sheet.vertices.front();
  double largest_ratio = 0;
  for(const Vertex v : sheet.vertices) {
    double shortest = std::numeric_limits<double>::infinity(), around = 0;
    for(const Halfedge h : CGAL::halfedges_around_target(v, mesh)) {
      shortest = (std::min)(shortest, length(v, mesh.source(h)));
      if(!mesh.is_border(h)) {
        around += length(mesh.source(h), mesh.source(mesh.prev(h)));
      }
    }
    if(around > 0 && shortest > largest_ratio * around) {
      largest_ratio = shortest / around;
      stray = v;
    }
  }
  if(largest_ratio < 10) {
    return "";
  }
  return "; or remove " +
         CGAL::Texture_atlas::internal::vertex_text(sheet.input_vertex(stray).idx() + 1, mesh.point(stray)) +
         ", which is " + format_number("%.3g", largest_ratio) +
         " times as far from its neighbors as these are around it";
}

class Plain_run
{
public:
  explicit Plain_run(const Command_line& command)
      : m_command(command), m_progress(command.verbose), m_notes(notes_of(command))
  {}

  Exit_status run()
  {
    check_writable(m_command);
    read();
    if(m_seamed) {
      choose_seams();
    }
    m_record.flattening = m_seamed ? flatten_cut_surface() : flatten_uncut_surface();
    m_record.peak_memory_mb = peak_memory_mb();
    m_record.vertices = m_sheet.vertices.size();
    m_record.triangles = m_sheet.faces.size();
    m_record.borders = m_sheet.borders.size();
    look_at_area();
    if(!flattening().note.empty()) {
      m_notes.add(flattening().note);
    }
    if(flattening().succeeded() && writes_floats(m_command)) {
      round_coordinates(m_command, m_sheet, m_record.flattening);
    }
    if(flattening().succeeded()) {
      make_chart();
    } else {
      m_record.flattening.place += remedy();
    }
    m_record.notes = m_notes.texts();
    tell_stages();
    write_files();
    m_progress.stage("write", m_record.write_seconds);
    tell_skipped_parts(m_command, m_record.skipped);
    if(flattening().succeeded()) {
      tell_report(m_command, report_text(m_record));
    }
    m_files.publish();
    if(!flattening().succeeded()) {
      std::cerr << "flatten_mesh: " << m_command.title << ": " << flattening().report.status << ": "
                << flattening().report.message << flattening().place << std::endl;
    }
    return exit_status(m_record);
  }

private:
  const Flattening& flattening() const { return m_record.flattening; }

  void read()
  {
    CGAL::Real_timer timer;
    timer.start();
    m_input.model = read_model(m_command.input, Degenerate_faces::REFUSED, m_notes, m_command.format,
                               gltf_options_of(m_command));
    try {
      build();
    } catch(const Input_error& error) {
      throw Input_error(m_command.title + ": " + error.what());
    }
    m_record.input = name_of_input(m_command);
    m_record.components = m_component.components;
    m_record.read_seconds = timer.time();
    m_progress.stage("read", m_record.read_seconds,
                     std::to_string(m_component.faces.size()) + " triangles to flatten");
  }

  void build()
  {
    {
      Polygon_soup soup = polygon_soup(m_input.model); // large surfaces need its memory
      tell_repetitions(soup, m_notes);
      Surface_of_model built =
          build_mesh(m_input.model, soup, m_command.repair == "on", m_notes, welding_of(m_command));
      m_has_polygons = built.mesh.number_of_faces() > soup.polygons.size();
      m_record.skipped = std::move(soup.left_out);
      m_input.mesh = std::move(built.mesh);
      m_input.origins = std::move(built.origins);
    }
    return_freed_memory();
    m_component = choose_component(m_input.mesh, static_cast<std::size_t>(m_command.component));
    if(!is_cut(m_command, m_input.mesh, m_component)) {
      take_uncut_sheet();
    } else if(prescribes_angles(m_command)) {
      throw Input_error(
          "the surface is closed or has handles, and must be cut open; angles can be prescribed "
          "only at the border of a surface that is not");
    } else {
      m_seamed = make_seamed_component(m_input.mesh, m_component);
    }
  }

  void take_uncut_sheet()
  {
    m_sheet = uncut_sheet(m_input.mesh, m_component, static_cast<std::size_t>(m_command.border));
  }

  // Without need for seams, the surface is flattened as it is.
  void choose_seams()
  {
    CGAL::Real_timer timer;
    timer.start();
    Seam_record seams;
    if(m_command.asks_for_cones) {
      m_record.cones = choose_cones(m_command, *m_seamed);
      tell_cones();
      seams.predicted_stretch = m_record.cones->predicted_stretch;
    }
    flatten_mesh::choose_seams(m_command, m_input, *m_seamed, seams);
    seams.seconds = timer.time();
    m_progress.stage("seams", seams.seconds);
    const Edge_marks& marks = m_seamed->seams;
    if((m_command.cut == "auto" && !m_command.asks_for_cones) ||
       std::find(marks.begin(), marks.end(), true) != marks.end()) {
      m_record.seams = seams;
    } else {
      m_seamed.reset();
      take_uncut_sheet();
    }
  }

  // There are fewer cones than asked for if fewer suffice.
  void tell_cones()
  {
    const Cone_record& cones = *m_record.cones;
    if(cones.cones.size() < cones.wanted) {
      m_notes.add(
          count_text(cones.cones.size(), "cone") + " instead of " + std::to_string(cones.wanted) +
          (cones.multiple > 0 ? ": the angles of others would be 360 degrees" : ": the map needs no more"));
    }
  }

  Flattening flatten_cut_surface()
  {
    Seam_record& seams = *m_record.seams;
    Flat_sheet flat = flatten_along_seams(m_command, m_input.mesh, *m_seamed, seams, m_progress);
    m_sheet = std::move(flat.sheet);
    if(seams.disks > 1) {
      m_notes.add("the seams leave " + count_text(seams.disks, "disk") + "; the largest is flattened, " +
                  std::to_string(m_sheet.faces.size()) + " of " +
                  count_text(m_component.faces.size(), "triangle"));
    }
    if(seams.bound_reached && !*seams.bound_reached) {
      m_notes.add("the scale stretch, " + format_number("%.4g", seams.scale_stretch) +
                  ", misses the bound of " + format_number("%.4g", seams.stretch_bound) +
                  " by more than 3 %, with seams added in " +
                  count_text(static_cast<std::size_t>(seams.rounds), "round"));
    }
    return flat.flattening;
  }

  Flattening flatten_uncut_surface()
  {
    Flattening attempt;
    if(prescribes_angles(m_command) && !prescribe_angles(m_sheet, m_command, m_progress, m_record, attempt)) {
      return attempt;
    }
    if(m_record.split_edges > 0) {
      take_triangles();
      m_notes.add(count_text(m_record.split_edges, "edge") +
                  " between border vertices split in the middle: triangles beside the straight sides would "
                  "be flat; the output has triangles only");
    }
    return flatten_sheet(m_sheet, m_command, m_progress);
  }

  // The polygons of the file have no corners at the middles of split edges, and so the triangles of the mesh become the
  // model that is written.
  void take_triangles()
  {
    const Mesh& mesh = m_input.mesh;
    m_input.model = model_of_mesh(mesh, m_input.model.name);
    m_input.origins = Corner_origins();
    m_input.origins.corners.assign(mesh.number_of_halfedges(), no_index);
    m_input.origins.is_turned.assign(mesh.number_of_faces(), false);
    Index corner = 0;
    for(const Face f : mesh.faces()) {
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        m_input.origins.corners[h.idx()] = corner++;
      }
    }
    m_has_polygons = false;
  }

  void look_at_area()
  {
    const SMP::Flattening_report& report = flattening().report;
    if(report && report.degenerate_triangles > 0) {
      m_notes.add(count_text(static_cast<std::size_t>(report.degenerate_triangles), "triangle") + " of " +
                  std::to_string(report.triangles) +
                  " without area: some measures are infinite, others ignore these triangles");
    }
  }

  // Writes the coordinates of the sheet to the mesh of the input, as an atlas of one chart, or of several pieces.
  void make_chart()
  {
    const std::size_t mended = m_has_polygons ? mend_polygons(m_command, m_sheet, m_record.flattening) : 0;
    look_at_map();
    Mesh& mesh = m_input.mesh;
    m_atlas = empty_atlas(mesh);
    if(m_seamed) {
      for(const Edge e : m_seamed->part.mesh.edges()) {
        m_atlas.seams[m_seamed->part.edge_origins[e.idx()]] = m_seamed->seams[e];
      }
    }
    std::vector<double> distortions(mesh.number_of_faces());
    for(const Face f : m_sheet.faces) {
      const Face origin = m_sheet.input_face(f);
      m_atlas.chart[origin] = 0;
      distortions[origin.idx()] = flattening().distortion[f];
      Halfedge h = mesh.halfedge(origin);
      for(const Vertex v : m_sheet.mesh().vertices_around_face(m_sheet.mesh().halfedge(f))) {
        while(mesh.target(h) != m_sheet.input_vertex(v)) {
          h = mesh.next(h);
        }
        m_atlas.uv[h] = flattening().uv[v];
      }
    }
    for(const Face f : mesh.faces()) {
      if(m_atlas.chart[f] >= 0) {
        m_distortions.push_back(distortions[f.idx()]);
      }
    }
    if(m_command.split_overlaps) {
      m_record.split = split_chart(m_sheet, flattening(), m_atlas);
      m_progress.stage("split", m_record.split->seconds);
    }
    m_is_divided = polygons_to_divide(m_command, m_input, m_atlas, grid_of_outputs(m_command));
    const std::vector<bool> told = m_command.triangles ? std::vector<bool>() : m_is_divided;
    if(const std::string text = polygons_text(mended, told); !text.empty()) {
      m_notes.add(text);
    }
    tell_outputs({Written_model{m_command, m_input, m_atlas, m_is_divided}}, m_notes);
  }

  // Says so if the map changes sizes more than those of good charts of atlases do, unless angles are prescribed; and if
  // it overlaps itself, and nothing was asked for that prevents this.
  void look_at_map()
  {
    if(!prescribes_angles(m_command) && flattening().scale_stretch > 2) {
      m_notes.add(
          "parts of the surface are much smaller in the plane than others, with a scale stretch of " +
          format_number("%.4g", flattening().scale_stretch) +
          ": --stretch-bound 1.5 cuts the surface where that helps, and without --plain it gets an atlas");
    }
    if(flattening().measures.border_is_simple || m_command.split_overlaps) {
      return;
    }
    const std::string split = "--split-overlaps keeps the angles, and splits the chart along ";
    m_notes.add(
        "the map overlaps itself: " +
        (prescribes_angles(m_command)
             ? "other angles may avoid that, or --holes fill where only holes overlap; " + split + "seams"
         : m_command.asks_for_cones ? split + "further seams; other numbers of cones may avoid it"
                                    : "--injective gives one that does not; " + split + "further seams"));
  }

  // Says what else can be done.
  std::string remedy()
  {
    const SMP::Diagnosis status = flattening().report.status;
    if(status == SMP::Diagnosis::LINEAR_SYSTEM_FAILED) {
      return std::string("; the usual cause: ") + memory_text; // solvers only say that they failed
    }
    if(m_seamed) {
      return "";
    }
    const std::string cut = status == SMP::Diagnosis::NONZERO_GENUS ? "; --cut auto does that"
                            : status == SMP::Diagnosis::SCALE_TOO_LARGE
                                ? "; --cut topology does that" + stray_vertex_text(m_sheet)
                                : "";
    return cut + other_component_text(m_input.mesh, m_component.number);
  }

  void tell_stages() const
  {
    Stages stages = stages_of_map(flattening());
    stages.emplace_back("parameterize", flattening().parameterize_seconds);
    stages.emplace_back("measure", flattening().measure_seconds);
    for(const auto& [stage, seconds] : stages) {
      m_progress.stage(stage, seconds, stage == "layout" ? layout_name(flattening().report) : "");
    }
  }

  // Writes the requested files under temporary names.
  void write_files()
  {
    CGAL::Real_timer timer;
    timer.start();
    if(flattening().succeeded()) {
      if(!m_command.output.empty()) {
        write_surface({m_command, m_input, m_atlas, m_is_divided}, Baked_surface(), m_files);
      }
      if(!m_command.svg.empty() || !m_command.picture.empty() || !m_command.report.empty()) {
        draw();
      }
      if(!m_command.seams_to.empty()) {
        m_files.open(m_command.seams_to).write(seams_text(m_input.mesh, m_atlas));
      }
    }
    m_record.write_seconds = timer.time();
    m_record.written = m_files.names();
    if(!m_command.json.empty()) {
      m_files.open(m_command.json).write(report_json(m_record, m_command.batch));
      m_record.written = m_files.names();
    }
  }

  void draw()
  {
    Textured_surface surface = textured_atlas(m_input.mesh, m_atlas, false);
    const std::string up = up_axis(m_command, surface);
    if(!m_command.svg.empty()) {
      std::vector<Angle_mark> marks;
      for(const auto& [v, angle] : m_sheet.marks) {
        marks.push_back({flattening().uv[v], vertex_name(m_sheet.input_vertex(v).idx()) + ": " +
                                                 format_number("%.6g", angle * 180. / CGAL_PI) + " degrees"});
      }
      m_files.open(m_command.svg).write(chart_svg(surface, m_distortions, marks));
    }
    if(!m_command.picture.empty()) {
      m_files.open(m_command.picture).write(checkerboard_picture(surface, Upright::of(up)));
    }
#ifdef ABF_WITH_THREE
    if(!m_command.report.empty()) {
      m_files.open(m_command.report)
          .write(report_page(contents_of_chart(m_input, m_atlas, m_record, std::move(surface), up),
                             m_command.options.threads));
    }
#endif
  }

  const Command_line& m_command;
  Progress m_progress;
  Notes m_notes;
  Atlas_input m_input;
  bool m_has_polygons = false; // of more than three corners
  Component m_component;
  std::optional<Seamed_component> m_seamed; // if it is cut open
  Sheet m_sheet;
  Chart_record m_record;
  Atlas m_atlas;
  std::vector<double> m_distortions; // of each triangle in the chart: change of its angles, in degrees
  std::vector<bool> m_is_divided;    // of each polygon of the model
  Output_files m_files;
};

} // namespace

Exit_status run_plain(const Command_line& command)
{
  return Plain_run(command).run();
}

} // namespace flatten_mesh
