// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/atlas/Recorded_atlas.h"

#include "flatten_mesh/atlas/join_models.h"
#include "flatten_mesh/atlas/keep_seams.h"
#include "flatten_mesh/atlas/place_charts.h"
#include "flatten_mesh/atlas/round_charts.h"
#include "flatten_mesh/choose_component.h"
#include "flatten_mesh/crease_option.h"
#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/texts.h"

#include <CGAL/number_type_config.h>
#include <CGAL/Texture_atlas/internal/prepare/surface_atlas.h>
#include <CGAL/Texture_atlas/internal/prepare/texture_of_atlas.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace {

Soup_options options_of_atlas(const Command_line& command)
{
  Soup_options options;
  static_cast<TA::Atlas_options&>(options) = command.atlas;
  options.float_coordinates = !command.atlas.is_in_world_units() && writes_floats(command);
  options.threads = command.options.threads;
  options.seams = seam_choice(command.atlas.seams, command.atlas.purpose);
  options.is_symmetric = command.atlas.is_symmetric;
  return options;
}

// Makes charts of the mesh or of the component that is asked for, and says where seams run.
Report_on_atlas make_atlas_of_input(const Command_line& command, Atlas_input& input, const Atlas& atlas,
                                    Seam_way& way, TA::Atlas_visitor& visitor)
{
  Soup_options options = options_of_atlas(command);
  std::vector<Given_surface> given;
  for(Joined_model& model : input.joined) {
    try {
      if(!model.input.mesh.is_empty()) {
        keep_seams(model.command.atlas, model.input, seam_marks(model.input.mesh));
      }
    } catch(const Input_error& error) {
      throw Input_error(model.command.title + ": " + error.what());
    }
    given.push_back(given_surface(model));
  }
  if(!given.empty()) {
    return make_common_surface_atlas(options, given, input.mesh, atlas, way, visitor);
  }
  try {
    keep_seams(command.atlas, input, atlas.seams);
    if(command.asks_for_component) {
      options.component = choose_component(input.mesh, static_cast<std::size_t>(command.component)).number;
    }
    return make_surface_atlas(options, {input.model, input, command.title}, atlas, way, visitor);
  } catch(const Input_error& error) {
    throw Input_error(command.title + ": " + error.what());
  }
}

// The number of faces of the file that a part without chart consists of
std::size_t count_faces(const Atlas_input& input, const Atlas& atlas, const Face first)
{
  const Mesh& mesh = input.mesh;
  std::set<std::size_t> faces;
  std::set<Face> triangles = {first};
  for(std::vector<Face> stack = {first}; !stack.empty();) {
    const Face f = stack.back();
    stack.pop_back();
    faces.insert(face_in_file(input, f));
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Face next = mesh.face(mesh.opposite(h));
      if(next != Mesh::null_face() && !atlas.seams[mesh.edge(h)] && triangles.insert(next).second) {
        stack.push_back(next);
      }
    }
  }
  return faces.size();
}

// Tells of the polygons of a model that have no area, and lists those that no neighbor gives coordinates. If only one
// component is to be flattened, it is not known whether they belong to it.
void look_at_polygons_without_area(const Command_line& command, const Atlas_input& input, const Atlas& atlas,
                                   const std::size_t model, Atlas_record& record, Notes& notes)
{
  const std::vector<bool>& has_no_area = input.origins.has_no_area;
  if(has_no_area.empty()) {
    return;
  }
  const Model_texture texture = texture_of(input.model, input.mesh, input.origins, atlas);
  std::vector<std::size_t> with, without;
  for(std::size_t p = 0; p < has_no_area.size(); ++p) {
    if(has_no_area[p]) {
      (texture.charts[p] == no_index ? without : with).push_back(p);
    }
  }
  if(!with.empty()) {
    notes.add(count_text(with.size(), "face") + " without area, the first is " + face_name(with.front()) +
              ": coordinates on an edge of a neighbor");
  }
  if(!without.empty() && !command.asks_for_component) {
    record.skipped.push_back({without.front(), without.size(), to_string(SMP::Diagnosis::NO_AREA),
                              face_name(without.front()) + " has no area, and no neighbor with a chart",
                              model});
  }
}

void look_at_polygons_without_area(const Command_line& command, Atlas_input& input, const Atlas& atlas,
                                   Atlas_record& record, Notes& notes)
{
  look_at_polygons_without_area(command, input, atlas, 0, record, notes);
  for(std::size_t i = 0; i < input.joined.size(); ++i) {
    Joined_model& model = input.joined[i];
    if(!model.input.origins.has_no_area.empty()) {
      notes.set_subject(model.command.title);
      look_at_polygons_without_area(command, model.input, atlas_of_model(atlas, model), i, record, notes);
    }
  }
  notes.set_subject("");
}

void list_skipped_parts(const Atlas_input& input, const Atlas& atlas, Atlas_record& record)
{
  record.skipped.insert(record.skipped.end(), input.set_aside.begin(), input.set_aside.end());
  for(const TA::Atlas_report::Skipped& part : record.report.skipped) {
    const Face first(static_cast<Mesh::size_type>(part.first_face));
    record.skipped.push_back({face_in_file(input, first), count_faces(input, atlas, first),
                              to_string(part.status), part.message, model_of_face(input, first.idx())});
  }
  std::stable_sort(record.skipped.begin(), record.skipped.end(), [](const auto& a, const auto& b) {
    return std::pair(a.model, a.first_face) < std::pair(b.model, b.first_face);
  });
}

void measure_charts(Atlas_record& record)
{
  double area = 0;
  for(const TA::Atlas_report::Chart& chart : record.report.charts) {
    area += chart.area;
  }
  for(const TA::Atlas_report::Chart& chart : record.report.charts) {
    record.share_of_area.push_back(chart.area / area);
  }
}

void place_charts(const Command_line& command, const Mesh& mesh, const Atlas& atlas,
                  const TA::Atlas_report& report)
{
  const Atlas_command& options = command.atlas;
  if(!options.is_in_world_units()) {
    return;
  }
  if(options.pack_into_square) {
    scale_charts(mesh, atlas, 1 / report.scale, options.number_of_rows() / report.scale / options.resolution);
  } else {
    place_in_rows(mesh, atlas, report.charts.size());
  }
  if(writes_floats(command)) {
    round_charts(mesh, atlas, report.charts.size(), grid_of_outputs(command));
  } else {
    check_orientation(mesh, atlas);
  }
}

// Says so if there was no crease to lay seams along.
void look_at_creases(const Atlas_record& record, Notes& notes)
{
  if(record.seam_way.lacks_creases) {
    notes.add("--seams creases: no creases divide the surface where faces differ by more than " +
              format_number("%.4g degrees", *record.seam_way.crease_angle * 180 / CGAL_PI) +
              ", so all seams are chosen to be short");
  }
}

// Says so if charts of the file were mirrored.
void look_at_mirrored_charts(const Atlas_record& record, Notes& notes)
{
  if(const std::size_t edges = record.seam_way.mirrored.new_seam_edges; edges > 0) {
    notes.add("--repack: the texture in the file is mirrored along " + count_text(edges, "edge") +
              (edges == 1 ? ", which is a seam now" : ", which are seams now"));
  }
  if(const std::size_t charts = record.seam_way.mirrored.number; charts > 0) {
    notes.add("--repack: " + count_text(charts, "chart") + " of the file turned over, because " +
              (charts == 1 ? "it is" : "they are") + " mirrored as a whole");
  }
}

// Says so if seams are not symmetric, but should be.
void look_at_symmetry(const Atlas_record& record, Notes& notes)
{
  const std::optional<Symmetry>& symmetry = record.seam_way.symmetry;
  if(!symmetry || symmetry->has_symmetric_seams) {
    return;
  }
  notes.add("--symmetric: " +
            (symmetry->has_symmetric_surface
                 ? "no symmetric seams were found that are at most 5 % longer than others"
                 : "the surface is not symmetric: in the best plane, its mirror image is " +
                       format_number("%.2g", 100 * symmetry->plane.deviation) +
                       " % of the diagonal of the bounding box away from it, and not at most 1.5 %") +
            ", so the seams are not made symmetric");
}

// Says so if charts stretch more than was asked for.
void look_at_stretch(const Atlas_record& record, Notes& notes)
{
  std::size_t missed = 0;
  double worst = 1;
  for(const TA::Atlas_report::Chart& chart : record.report.charts) {
    missed += !chart.bound_reached;
    worst = (std::max)(worst, chart.scale_stretch);
  }
  if(missed > 0) {
    notes.add("the scale stretch of " + count_text(missed, "chart") + ", at most " +
              format_number("%.4g", worst) + ", misses the bound of " +
              format_number("%.4g", record.stretch_bound) + " by more than 3 %");
  }
}

// Of those that faces use
std::size_t number_of_vertices(const Mesh& mesh)
{
  const auto vertices = mesh.vertices();
  return static_cast<std::size_t>(std::count_if(vertices.begin(), vertices.end(),
                                                [&mesh](const Vertex v) { return !mesh.is_isolated(v); }));
}

Atlas_record record_of(const Command_line& command, const Atlas_input& input)
{
  Atlas_record record;
  record.input = name_of_input(command);
  record.options = command.atlas;
  record.stretch_bound = options_of_atlas(command).stretch_bound;
  record.vertices = number_of_vertices(input.mesh);
  record.triangles = input.mesh.number_of_faces();
  record.left_out = input.left_out;
  return record;
}

// What the record says of several models
void list_models(const Atlas_input& input, const Atlas& atlas, Atlas_record& record)
{
  std::size_t first_chart = 0;
  for(const Joined_model& model : input.joined) {
    const Mesh& mesh = model.input.mesh;
    std::set<int> charts;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      charts.insert(atlas.chart[Face(static_cast<Mesh::size_type>(model.first_face + f))]);
    }
    charts.erase(-1);
    record.models.push_back({model.command.input, record.report.has_atlas() ? model.command.output : "",
                             number_of_vertices(mesh), mesh.number_of_faces(), first_chart, charts.size()});
    first_chart += charts.size();
  }
}

void make_charts(const Command_line& command, Atlas_input& input, const Atlas& atlas, Atlas_record& record,
                 TA::Atlas_visitor& visitor)
{
  if(input.mesh.is_empty()) {
    record.report.status = SMP::Diagnosis::NOTHING_FLATTENED;
    record.report.message = "no part of the surface can be flattened";
    return;
  }
  record.components = components_by_size(input.mesh).size();
  record.report = make_atlas_of_input(command, input, atlas, record.seam_way, visitor);
  if(record.report.has_atlas()) {
    place_charts(command, input.mesh, atlas, record.report);
  }
}

} // namespace

Recorded_atlas make_recorded_atlas(const Command_line& command, Atlas_input& input, Notes& notes,
                                   TA::Atlas_visitor& visitor)
{
  Recorded_atlas made{empty_atlas(input.mesh), record_of(command, input)};
  make_charts(command, input, made.atlas, made.record, visitor);
  look_at_polygons_without_area(command, input, made.atlas, made.record, notes);
  list_skipped_parts(input, made.atlas, made.record);
  list_models(input, made.atlas, made.record);
  measure_charts(made.record);
  look_at_mirrored_charts(made.record, notes);
  look_at_creases(made.record, notes);
  look_at_symmetry(made.record, notes);
  look_at_stretch(made.record, notes);
  return made;
}

} // namespace flatten_mesh
