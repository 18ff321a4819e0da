// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/run_plain.h"

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/Output_files.h"
#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/model/Polygon_soup.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/process_memory.h"
#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/plain/Seamed_component.h"
#include "flatten_mesh/model/build_mesh.h"
#include "flatten_mesh/model/divide_polygons.h"
#include "flatten_mesh/plain/choose_seams.h"
#include "flatten_mesh/model/components.h"
#include "flatten_mesh/plain/flatten_along_seams.h"
#include "flatten_mesh/plain/flatten_chart.h"
#include "flatten_mesh/plain/mend_polygons.h"
#include "flatten_mesh/model/read_model.h"
#include "flatten_mesh/plain/prescribe_angles.h"
#include "flatten_mesh/plain/report_json.h"
#include "flatten_mesh/plain/report_text.h"
#include "flatten_mesh/plain/round_chart.h"
#include "flatten_mesh/plain/scale_stretch.h"
#include "flatten_mesh/seam_file.h"
#include "flatten_mesh/plain/split_chart.h"
#include "flatten_mesh/plain/stray_vertex.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"
#include "flatten_mesh/model/write_model.h"
#include "flatten_mesh/plain/write_obj.h"
#include "flatten_mesh/plain/write_svg.h"
#include "flatten_mesh/weld_option.h"

#ifdef ABF_WITH_PNG
#include "flatten_mesh/pictures/draw_surface.h"
#endif

#ifdef ABF_WITH_THREE
#include "flatten_mesh/report/contents_of_chart.h"
#include "flatten_mesh/report/report_page.h"
#endif

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace {

// The surface in the file, and the surface that is flattened.
struct Surface
{
  Model model;
  std::optional<Polygon_soup> repaired; // if it is not as in the model
  bool has_polygons = false;            // of more than three corners
  Mesh input;
  Corner_origins origins;                     // of the input, in the model
  std::vector<Index> polygons_of_split_faces; // of each face of the input, in the model, if edges were split
  std::vector<Skipped_part> skipped;
  Component component;
  std::optional<Seamed_component> seamed; // if it is cut open
  Cut_mesh cut;
  Chart chart;

  Polygon_soup soup() const { return repaired ? *repaired : polygon_soup(model); }
  std::vector<Index> polygons() const
  {
    return polygons_of_split_faces.empty() ? polygons_of_faces(model, input, origins)
                                           : polygons_of_split_faces;
  }

  // If nothing was repaired, the mesh has the points and corners of the model, too, until edges are split. Large surfaces
  // need their memory.
  void release_model(const Command_line& command)
  {
    if(!repaired && !prescribes_angles(command)) {
      model.points = std::vector<Kernel::Point_3>();
      model.vertices = std::vector<Index>();
    }
  }

  void restore_model()
  {
    if(!model.vertices.empty()) { // it was not released
      return;
    }
    model.points.assign(input.points().begin(), input.points().end());
    model.vertices.resize(model.first_corners.back());
    for(std::size_t h = 0; h < origins.corners.size(); ++h) {
      if(origins.corners[h] != no_index) {
        model.vertices[origins.corners[h]] = input.target(Halfedge(static_cast<Mesh::size_type>(h)));
      }
    }
  }

  Mesh& mesh() { return chart.is_cut() ? cut.mesh : input; }
  const Mesh& mesh() const { return chart.is_cut() ? cut.mesh : input; }
};

Surface read_surface(const Command_line& command, Notes& notes)
{
  Surface surface;
  surface.model =
      read_model(command.input, Degenerate_faces::REFUSED, notes, command.format, gltf_options_of(command));
  Polygon_soup soup = polygon_soup(surface.model);
  tell_repetitions(soup, notes);
  try {
    Surface_of_model built =
        build_mesh(surface.model, soup, command.repair == "on", notes, welding_of(command));
    surface.has_polygons = built.mesh.number_of_faces() > soup.polygons.size();
    surface.skipped = soup.left_out;
    if(!is_as_in_model(soup, surface.model)) {
      surface.repaired = std::move(soup);
    }
    soup = Polygon_soup(); // large surfaces need its memory
    return_freed_memory();
    surface.input = std::move(built.mesh);
    surface.origins = std::move(built.origins);
    surface.release_model(command);
    surface.component = choose_component(surface.input, static_cast<std::size_t>(command.component));
    if(is_cut(command, surface.input, surface.component)) {
      if(prescribes_angles(command)) {
        throw Input_error(
            "the surface is closed or has handles, and must be cut open; angles can be prescribed "
            "only at the border of a surface that is not");
      }
      surface.seamed = make_seamed_component(surface.input, surface.component);
    } else {
      surface.chart =
          choose_border(surface.input, surface.component, static_cast<std::size_t>(command.border));
    }
  } catch(const Input_error& error) {
    throw Input_error(command.title + ": " + error.what());
  }
  return surface;
}

// The polygons of the soup that other programs would draw with triangles that overlap. GLB files have none.
std::vector<bool> polygons_to_divide(const Command_line& command, const Surface& surface,
                                     const Flattening& flattening)
{
  if(!surface.has_polygons || command.output.empty() || file_format(command.output) == "glb" ||
     !flattening.succeeded()) {
    return {};
  }
  const Polygon_soup before = surface.soup(), soup = with_split_sides(before, surface.input, surface.chart);
  std::vector<bool> is_divided =
      concave_polygons(soup, surface.mesh(), surface.chart, flattening, grid_of_outputs(command));
  for(std::size_t p = 0; p < is_divided.size(); ++p) { // the corner that splits a straight side is no fault
    is_divided[p] = is_divided[p] && soup.polygons[p].size() == before.polygons[p].size();
  }
  return is_divided;
}

// OBJ contains the repaired surface, the other formats the model in the file.
void write_surface(Output_file& file, const std::string& name, Surface& surface, const Flattening& flattening,
                   const std::vector<bool>& is_divided)
{
  const bool divides = std::find(is_divided.begin(), is_divided.end(), true) != is_divided.end();
  if(is_obj_output(name)) {
    Polygon_soup soup = with_split_sides(surface.soup(), surface.input, surface.chart);
    if(divides) {
      divide_polygons(soup, surface.input, surface.polygons(), is_divided);
    }
    write_obj(file, soup, surface.mesh(), surface.chart, flattening);
    return;
  }
  if(divides) {
    std::vector<bool> is_divided_in_model(surface.model.number_of_polygons(), false);
    const Polygon_soup soup = surface.soup();
    for(std::size_t p = 0; p < is_divided.size(); ++p) {
      is_divided_in_model[soup.origins[p]] = is_divided[p];
    }
    divide_polygons(surface.model, surface.input, surface.origins, is_divided_in_model);
  }
  write_model(file, name, surface.model,
              texture_of_chart(surface.model, surface.input, surface.origins, surface.mesh(), surface.chart,
                               flattening));
}

// Writes the requested files under temporary names.
Output_files write_files(const Command_line& command, Surface& surface, const std::vector<bool>& is_divided,
                         Run_record& record)
{
  Output_files files;
  const auto open = [&files](const std::string& name) -> Output_file& { return files.open(name); };
  CGAL::Real_timer timer;
  timer.start();
  if(!command.output.empty() && record.flattening.succeeded()) {
    write_surface(open(command.output), command.output, surface, record.flattening, is_divided);
  }
  if(!command.svg.empty() && record.flattening.succeeded()) {
    write_svg(open(command.svg), surface.mesh(), surface.chart, record.flattening);
  }
#ifdef ABF_WITH_PNG
  if(!command.picture.empty() && record.flattening.succeeded()) {
    open(command.picture)
        .write(checkerboard_picture(command, surface.mesh(), surface.chart, record.flattening.uv));
  }
#endif
#ifdef ABF_WITH_THREE
  if(!command.report.empty() && record.flattening.succeeded()) {
    open(command.report)
        .write(report_page(contents_of_chart(command, surface.input, surface.polygons(), surface.mesh(),
                                             surface.chart, record),
                           command.options.threads));
  }
#endif
  if(!command.seams_to.empty() && record.flattening.succeeded()) {
    open(command.seams_to)
        .write(surface.seamed ? seams_text(surface.input, *surface.seamed) : no_seams_text());
  }
  record.write_seconds = timer.time();
  record.written = files.names();
  if(!command.json.empty()) {
    open(command.json).write(report_json(record, command.batch));
    record.written = files.names();
  }
  return files;
}

void tell_stages(const Run_record& record, const Progress& progress)
{
  for(const auto& stage : seconds_of_stages(record)) {
    if(stage.first != "read" && stage.first != "seams" && stage.first != "split" && stage.first != "write") {
      progress.stage(stage.first, stage.second,
                     stage.first == "layout" ? layout_name(record.flattening.report) : "");
    }
  }
}

void tell_diagnosis(const Command_line& command, const Flattening& flattening)
{
  std::cerr << "flatten_mesh: " << command.title << ": " << status_name(flattening.report) << ": "
            << flattening.report.message << flattening.place << std::endl;
}

void look_at_area(const Run_record& record, Notes& notes)
{
  const SMP::Flattening_report& report = record.flattening.report;
  if(report && report.degenerate_triangles > 0) {
    notes.add(count_text(static_cast<std::size_t>(report.degenerate_triangles), "triangle") + " of " +
              std::to_string(report.triangles) +
              " without area: some measures are infinite, others ignore these triangles");
  }
}

Run_record record_of(const Command_line& command, const Surface& surface)
{
  Run_record record;
  record.input = name_of_input(command);
  record.vertices = surface.component.vertices.size();
  record.triangles = surface.component.faces.size();
  record.borders = surface.chart.borders.size();
  record.components = surface.component.components;
  record.skipped = surface.skipped;
  return record;
}

// There are fewer cones than asked for if fewer suffice.
void tell_cones(const Cone_record& record, Notes& notes)
{
  if(record.cones.size() < record.wanted) {
    notes.add(
        count_text(record.cones.size(), "cone") + " instead of " + std::to_string(record.wanted) +
        (record.multiple > 0 ? ": the angles of others would be 360 degrees" : ": the map needs no more"));
  }
}

// Cuts the surface open. Without need for seams, it is flattened as it is.
void cut_surface(const Command_line& command, Surface& surface, Run_record& record, const Progress& progress,
                 Notes& notes)
{
  CGAL::Real_timer timer;
  timer.start();
  Seam_record seams;
  if(command.asks_for_cones) {
    record.cones = choose_cones(command, *surface.seamed);
    tell_cones(*record.cones, notes);
    seams.predicted_stretch = record.cones->predicted_stretch;
  }
  choose_seams(command, surface.input, *surface.seamed, seams);
  seams.seconds = timer.time();
  progress.stage("seams", seams.seconds);
  if((command.cut != "auto" || command.asks_for_cones) && !has_seams(*surface.seamed)) {
    surface.seamed.reset();
    surface.chart = choose_border(surface.input, surface.component, static_cast<std::size_t>(command.border));
  } else {
    record.seams = seams;
  }
}

Flattening flatten_cut_surface(const Command_line& command, Surface& surface, Run_record& record,
                               Progress& progress, Notes& notes)
{
  Flat_surface flat = flatten_along_seams(command, *surface.seamed, *record.seams, progress);
  surface.cut = std::move(flat.cut);
  surface.chart = std::move(flat.chart);
  if(flat.disks > 1) {
    notes.add("the seams leave " + count_text(flat.disks, "disk") + "; the largest is flattened, " +
              std::to_string(surface.chart.faces.size()) + " of " +
              count_text(surface.component.faces.size(), "triangle"));
  }
  const Seam_record& seams = *record.seams;
  if(seams.bound_reached && !*seams.bound_reached) {
    notes.add("the scale stretch, " + format_number("%.4g", seams.scale_stretch) + ", misses the bound of " +
              format_number("%.4g", seams.stretch_bound) + " by more than 3 %, with seams added in " +
              count_text(static_cast<std::size_t>(seams.rounds), "round"));
  }
  record.vertices = surface.chart.vertices.size();
  record.triangles = surface.chart.faces.size();
  return flat.flattening;
}

// Flattens a chart whose border has prescribed angles.
Flattening flatten_with_angles(const Command_line& command, Surface& surface, Run_record& record,
                               Progress& progress, Notes& notes)
{
  std::vector<Index> polygons = surface.polygons();
  if(const auto failure = prescribe_angles(surface.input, surface.chart, command, progress)) {
    return *failure;
  }
  for(const Vertex v : surface.chart.corners) {
    record.corners.push_back(v.idx());
  }
  record.split_edges = surface.chart.split_edges.size();
  if(record.split_edges > 0 && !command.output.empty() && !is_obj_output(command.output)) {
    throw Input_error(command.title + ": the straight sides need " + count_text(record.split_edges, "edge") +
                      " split in the middle, which only OBJ output can hold: choose a name that ends with "
                      ".obj, or other corners");
  }
  surface.polygons_of_split_faces = polygons_of_parts(std::move(polygons), surface.input, surface.chart);
  record.vertices = surface.chart.vertices.size();
  record.triangles = surface.chart.faces.size();
  if(record.split_edges > 0) {
    notes.add(
        count_text(record.split_edges, "edge") +
        " between border vertices split in the middle: triangles beside the straight sides would be flat");
  }
  return flatten_chart(surface.input, surface.chart, command, progress);
}

Edge input_edge(const Surface& surface, const Edge e)
{
  return surface.chart.is_cut() ? surface.seamed->part.edge_origins[surface.cut.edge_origins[e.idx()].idx()]
                                : e;
}

// Makes polygons convex in the plane where small moves do that, and returns how many. Split edges are no diagonals.
std::size_t mend_surface(const Command_line& command, Surface& surface, Flattening& flattening)
{
  if(!surface.has_polygons || !surface.chart.split_edges.empty()) {
    return 0;
  }
  const Edge_marks is_diagonal = diagonals(surface.input);
  const std::size_t count = mend_polygons(
      surface.mesh(), surface.chart, [&](const Edge e) { return is_diagonal[input_edge(surface, e)]; },
      grid_of_outputs(command), flattening.uv);
  if(count > 0) {
    measure(surface.mesh(), surface.chart, flattening);
  }
  return count;
}

// Splits the chart where its map overlaps itself.
void split_surface(Surface& surface, Run_record& record, const Progress& progress)
{
  CGAL::Real_timer timer;
  timer.start();
  record.split = Split_record();
  const Edge_marks is_diagonal = diagonals(surface.input);
  Split_chart split = split_chart(
      surface.mesh(), surface.chart, record.flattening,
      [&](const Edge e) { return is_diagonal[input_edge(surface, e)]; }, *record.split);
  if(record.split->pieces > 1) {
    std::vector<bool> is_new(surface.input.number_of_edges(), false);
    for(const Edge e : split.new_seams) {
      is_new[input_edge(surface, e).idx()] = true;
    }
    if(!surface.seamed) {
      surface.seamed = make_seamed_component(surface.input, surface.component);
    }
    for(const Edge e : surface.seamed->part.mesh.edges()) {
      if(is_new[surface.seamed->part.edge_origins[e.idx()].idx()]) {
        surface.seamed->seams[e] = true;
      }
    }
    surface.cut = std::move(split.cut);
    surface.chart = std::move(split.chart);
    record.flattening = std::move(split.flattening);
  }
  record.split->seconds = timer.time();
  progress.stage("split", record.split->seconds);
}

// Says what else can be done.
std::string remedy(Surface& surface, const SMP::ABF_plus_plus_report& report)
{
  if(report.status == SMP::Diagnosis::LINEAR_SYSTEM_FAILED) {
    return std::string("; the usual cause: ") + memory_text; // solvers only say that they failed
  }
  if(surface.seamed) {
    return "";
  }
  const std::string cut = report.status == SMP::Diagnosis::NONZERO_GENUS ? "; --cut auto does that"
                          : report.status == SMP::Diagnosis::SCALE_TOO_LARGE
                              ? "; --cut topology does that" + stray_vertex_text(surface.input, surface.chart)
                              : "";
  return cut + other_component_text(surface.input, surface.component.number);
}

// Says so if the map changes sizes more than those of good charts of atlases do, unless angles are prescribed.
void look_at_stretch(const Command_line& command, const Surface& surface, const Flattening& flattening,
                     Notes& notes)
{
  if(!flattening.succeeded() || prescribes_angles(command)) {
    return;
  }
  const double stretch = scale_stretch(surface.mesh(), surface.chart, flattening.uv);
  if(stretch > 2) {
    notes.add(
        "parts of the surface are much smaller in the plane than others, with a scale stretch of " +
        format_number("%.4g", stretch) +
        ": --stretch-bound 1.5 cuts the surface where that helps, and without --plain it gets an atlas");
  }
}

// Says so if the map overlaps itself and nothing was asked for that prevents this.
void look_at_overlap(const Command_line& command, const Flattening& flattening, Notes& notes)
{
  if(!flattening.succeeded() || flattening.measures.border_is_simple || command.split_overlaps) {
    return;
  }
  if(prescribes_angles(command)) {
    notes.add(
        "the map overlaps itself: other angles may avoid that, or --holes fill where only holes overlap; "
        "--split-overlaps keeps the angles, and splits the chart along seams");
  } else if(command.asks_for_cones) {
    notes.add(
        "the map overlaps itself: --split-overlaps keeps the angles, and splits the chart along further "
        "seams; other numbers of cones may avoid it");
  } else {
    notes.add("the map overlaps itself: --injective gives one that does not; --split-overlaps keeps the "
              "angles, and splits the chart along further seams");
  }
}

} // namespace

Exit_status run_plain(const Command_line& command)
{
  Progress progress(command.verbose);
  check_writable(command);

  CGAL::Real_timer timer;
  timer.start();
  Notes notes(command);
  Surface surface = read_surface(command, notes);
  Run_record record = record_of(command, surface);
  record.read_seconds = timer.time();
  progress.stage("read", record.read_seconds, std::to_string(record.triangles) + " triangles to flatten");

  if(surface.seamed) {
    cut_surface(command, surface, record, progress, notes);
  }
  record.flattening = surface.seamed ? flatten_cut_surface(command, surface, record, progress, notes)
                      : prescribes_angles(command)
                          ? flatten_with_angles(command, surface, record, progress, notes)
                          : flatten_chart(surface.input, surface.chart, command, progress);
  record.peak_memory_mb = peak_memory_mb();
  look_at_area(record, notes);
  record.borders = surface.chart.borders.size();
  if(!record.flattening.note.empty()) {
    notes.add(record.flattening.note);
  }
  if(record.flattening.succeeded() && writes_floats(command)) {
    round_chart(command, surface.mesh(), surface.chart, record.flattening);
  }
  const std::size_t mended =
      record.flattening.succeeded() ? mend_surface(command, surface, record.flattening) : 0;
  look_at_stretch(command, surface, record.flattening, notes);
  look_at_overlap(command, record.flattening, notes);
  if(command.split_overlaps && record.flattening.succeeded()) {
    split_surface(surface, record, progress);
  }
  surface.restore_model();
  const std::vector<bool> is_divided = polygons_to_divide(command, surface, record.flattening);
  if(const std::string text = polygons_text(mended, is_divided); !text.empty()) {
    notes.add(text);
  }
  record.notes = notes.texts();
  if(!record.flattening.succeeded()) {
    record.flattening.place += remedy(surface, record.flattening.report);
  }
  tell_stages(record, progress);
  Output_files files = write_files(command, surface, is_divided, record);
  progress.stage("write", record.write_seconds);
  tell_skipped_parts(command, record.skipped);
  if(record.flattening.succeeded()) {
    tell_report(command, report_text(record));
  }
  files.publish();
  if(!record.flattening.succeeded()) {
    tell_diagnosis(command, record.flattening);
  }
  return exit_status(record);
}

} // namespace flatten_mesh
