// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_OPTIONS_H
#define FLATTEN_MESH_CHECK_OPTIONS_H

#include "flatten_mesh/plain/corner_numbers.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Option_table.h"
#include "flatten_mesh/check_outputs.h"
#include "flatten_mesh/commands_of_inputs.h"
#include "flatten_mesh/describe_options.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/formats.h"
#include "flatten_mesh/page_options.h"
#include "flatten_mesh/texts.h"
#include "flatten_mesh/weld_option.h"

#include <CGAL/Texture_atlas/internal/options/option_table.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline void check_files(Command_line& command)
{
  if(command.inputs.empty() && command.batch.shard.empty()) {
    throw Usage_error(
        "no input: name a mesh file, as in 'flatten_mesh scan.ply --output flat.obj'; see --help");
  }
  const auto from_stream = std::count(command.inputs.begin(), command.inputs.end(), standard_input),
             from_pipes = std::count_if(command.inputs.begin(), command.inputs.end(), is_other_file);
  if(from_stream > 1) {
    throw Usage_error("standard input, '-', can be read once only");
  }
  if(from_stream == 1 && command.format.empty()) {
    throw Usage_error("the format of standard input is unknown: give --format " + formats_text(", ", " or "));
  }
  if(!command.format.empty() && from_stream + from_pipes == 0) {
    throw Usage_error(
        "--format goes with standard input, '-', and pipes only: the names of files tell their format");
  }
  if(!command.format.empty()) {
    check_name("format", command.format, formats_read());
  }
  if(command.inputs.size() == 1 && !command.atlas.is_shared && command.batch.shard.empty()) {
    command = command_of_input(command, command.inputs.front());
  }
  check_outputs_of_inputs(command);
#ifndef ABF_WITH_PNG
  if(!command.chart_image.empty()) {
    throw Usage_error(
        "this program was built without libpng, which --chart-image needs: install libpng-dev and "
        "build it again, or use --svg");
  }
#endif
#ifndef ABF_WITH_THREE
  if(!command.report.empty()) {
    throw Usage_error(
        "this program was built without three.js, which --report needs: install libjs-three and build "
        "it again, or use --picture");
  }
#endif
}

inline void check_gutter(const Values& values, Atlas_command& atlas)
{
  if(is_given(values, "mip-levels")) {
    if(is_given(values, "gutter")) {
      throw Usage_error("--mip-levels and --gutter exclude each other: N levels are a gutter of 2^N texels");
    }
    atlas.gutter = 1 << atlas.mip_levels;
  }
  if(const std::string wrong = abf::wrong_gutter(atlas); !wrong.empty()) {
    throw Usage_error((is_given(values, "gutter") ? "--" : "--mip-levels: the ") + wrong + "; see --help");
  }
}

inline void check_quantization(const Values& values, const Atlas_command& atlas)
{
  if(!is_given(values, "quantize")) {
    return;
  }
  if(atlas.is_in_world_units()) {
    throw Usage_error("--quantize goes without --units world: the grid is that of the unit square");
  }
  if(atlas.texels_per_unit > 0) {
    throw Usage_error("--quantize and --texels-per-unit exclude each other: the grid is that of one page");
  }
  if(const std::string wrong = abf::wrong_quantization(atlas); !wrong.empty()) {
    throw Usage_error("--quantize: " + wrong + "; see --help");
  }
}

inline void check_seams(const Values& values, Command_line& command)
{
  command.asks_for_stretch = is_given(values, "stretch-bound");
  command.stretch_bound = command.asks_for_stretch ? command.atlas.stretch_bound : command.stretch_bound;
  if(command.asks_for_stretch && command.cut != "auto") {
    throw Usage_error("--stretch-bound goes with --cut auto only");
  }
  if(!command.seams_to.empty() && command.seams_to != standard_output &&
     !is_selection_file(command.seams_to) && !is_other_file(resolved(command.seams_to))) {
    throw Usage_error("--seams-to takes a name that ends with .selection.txt");
  }
}

inline void check_injective(const Values& values, const Command_line& command)
{
  for(const char* option : {"area-weight", "clearance"}) {
    if(is_given(values, option) && !command.options.injective) {
      throw Usage_error(std::string("--") + option + " goes with --injective only");
    }
  }
  if(command.options.injective && command.split_overlaps) {
    throw Usage_error("--injective and --split-overlaps exclude each other: in an injective map nothing "
                      "overlaps that could be split");
  }
}

inline void check_angles(const Command_line& command)
{
  if(command.rectangle.empty() && command.border_angles.empty()) {
    return;
  }
  const std::string option = command.rectangle.empty() ? "--border-angles" : "--rectangle";
  const auto check = [&option](const bool is_right, const std::string& rule) {
    if(!is_right) {
      throw Usage_error(option + rule);
    }
  };
  check(command.rectangle.empty() || command.border_angles.empty(),
        " and --border-angles exclude each other");
  check(command.rectangle.empty() || command.rectangle == "auto" || corner_numbers(command.rectangle),
        " takes four different vertices, as in '--rectangle 1,20,300,4000', or 'auto'");
  check(command.method != "hierarchical",
        " goes with --method direct or auto: the hierarchical method cannot prescribe angles");
  check((command.cut == "auto" || command.cut == "none") && !command.asks_for_stretch,
        " goes with a surface that is not cut open");
  check(command.options.layout != SMP::ABF_plus_plus_options::LEAST_SQUARES_LAYOUT,
        " goes with --layout exact or auto: least squares bend straight sides");
}

inline bool divides_turn(const double degrees)
{
  const double parts = std::round(360 / degrees);
  return degrees > 0 && parts >= 1 && parts <= 1e6 && std::abs(parts * degrees - 360) <= 1e-8;
}

inline void check_cones(const Values& values, Command_line& command)
{
  command.asks_for_cones = is_given(values, "cones");
  const bool has_multiple = is_given(values, "cone-angle-multiple");
  if(!command.asks_for_cones) {
    if(has_multiple) {
      throw Usage_error("--cone-angle-multiple goes with --cones only");
    }
    return;
  }
  const auto check = [](const bool is_right, const std::string& rule) {
    if(!is_right) {
      throw Usage_error(rule);
    }
  };
  check(!has_multiple || divides_turn(command.cone_angle_multiple),
        "--cone-angle-multiple takes an angle in degrees that divides 360, as 90, 60 or 45 do");
  check(command.rectangle.empty(), "--cones and --rectangle exclude each other");
  check(command.border_angles.empty(), "--cones and --border-angles exclude each other");
  check(!is_given(values, "cut"), "--cones and --cut exclude each other: seams lead to the cones");
  check(!is_given(values, "stretch-bound"),
        "--cones and --stretch-bound exclude each other: more cones reduce the stretch");
  check(command.options.equal_seam_lengths.value_or(true),
        "--cones and --equal-seams off exclude each other: both sides of a seam are equal");
  check(command.method != "hierarchical",
        "--cones goes with --method direct or auto: the hierarchical method cannot prescribe angles");
  check(!command.options.injective,
        "--cones and --injective exclude each other: injective maps do not keep the angles of cones");
  check(command.options.layout != SMP::ABF_plus_plus_options::LEAST_SQUARES_LAYOUT,
        "--cones goes with --layout exact or auto: least squares leave gaps between both sides of a seam");
  command.options.equal_seam_lengths = true;
}

inline void check_equal_seams(const Values& values, const Command_line& command)
{
  if(!is_given(values, "equal-seams") || !command.is_plain || !*command.options.equal_seam_lengths) {
    return;
  }
  if(command.method == "hierarchical") {
    throw Usage_error("--equal-seams goes with --method direct or auto");
  }
  if(command.options.injective) {
    throw Usage_error(
        "--equal-seams and --injective exclude each other: injective maps have no equal lengths");
  }
}

inline void check_up(const Values& values, const Command_line& command)
{
  if(is_given(values, "up") && command.picture.empty() && command.report.empty()) {
    throw Usage_error("--up goes with --picture or --report: it says which axis points upwards there");
  }
}

inline void check_weld(const Values& values, const Command_line& command)
{
  if(!is_given(values, "weld")) {
    return;
  }
  if(command.weld != "on" && command.weld != "off" && !weld_tolerance(command.weld)) {
    throw Usage_error("--weld takes 'on', 'off' or a distance of at least 0 in units of the surface, not '" +
                      command.weld + "'");
  }
  if(command.weld != "off" && command.repair == "off") {
    throw Usage_error("--weld and --repair off exclude each other: without repairs, nothing is joined");
  }
}

// An option that would have no effect is refused.
inline void check_kind(const Values& values, const Command_line& command)
{
  for(const std::string& option : command.is_plain ? options_of_atlases() : options_of_plain_charts()) {
    if(is_given(values, option)) {
      throw Usage_error("--" + option +
                        (command.is_plain ? " goes with an atlas, and not with --plain"
                                          : " goes with --plain only: an atlas chooses that itself") +
                        "; see --help");
    }
  }
}

inline void check_baking(const Values& values, const Command_line& command)
{
  const Atlas_command& atlas = command.atlas;
  if(is_given(values, "simplify") && (!atlas.seams_from.empty() || atlas.charts_from_materials)) {
    throw Usage_error(
        "--simplify excludes --seams-from and --charts-from-materials: the simplified surface has neither "
        "the edges nor the materials of the file");
  }
  if(!is_given(values, "bake-from")) {
    return;
  }
#ifndef ABF_WITH_PNG
  throw Usage_error(
      "this program was built without libpng, which --bake-from needs: install libpng-dev and build "
      "it again");
#endif
  if(!atlas.pack_into_square || atlas.is_in_world_units()) {
    throw Usage_error(std::string("--bake-from goes without ") +
                      (atlas.pack_into_square ? "--units world" : "--no-pack") +
                      ": textures cover the unit square");
  }
}

inline void check_way_of_seams(const std::string& seams)
{
  if(is_selection_file(seams)) {
    throw Usage_error("--seams says where seams run: give --seams-to '" + seams +
                      "' to write them, or --seams-from '" + seams + "' to keep them");
  }
  if(const std::string wrong = CGAL::Texture_atlas::internal::wrong_seams(seams); !wrong.empty()) {
    throw Usage_error("--" + wrong);
  }
}

// Seams that are given stay where they are.
inline void check_symmetric(const Values& values, const Atlas_command& atlas)
{
  if(!atlas.is_symmetric) {
    return;
  }
  for(const char* option : {"one-atlas", "seams-from", "charts-from-materials", "repack"}) {
    if(is_given(values, option)) {
      throw Usage_error(std::string("--symmetric and --") + option + " exclude each other");
    }
  }
}

// Charts that are kept are neither cut nor flattened.
inline void check_repack(const Values& values, const Atlas_command& atlas)
{
  if(!atlas.repacks) {
    if(atlas.repairs_charts) {
      throw Usage_error("--repair-charts goes with --repack only");
    }
    return;
  }
  std::vector<const char*> excluded = {"seams",      "seams-from", "charts-from-materials",
                                       "seam-price", "simplify",   "component"};
  if(!atlas.repairs_charts) {
    excluded.insert(excluded.end(),
                    {"for", "separate", "isometric", "stretch-bound", "area-weight", "equal-seams"});
  }
  for(const char* option : excluded) {
    if(is_given(values, option)) {
      throw Usage_error(std::string("--repack and --") + option +
                        " exclude each other: the charts of the input are kept");
    }
  }
}

inline void check_atlas(const Values& values, Command_line& command)
{
  Atlas_command& atlas = command.atlas;
  check_way_of_seams(atlas.seams);
  if(is_given(values, "seams-from") && atlas.seams_from != "uv" && !is_selection_file(atlas.seams_from)) {
    throw Usage_error("--seams-from takes the name of a .selection.txt file, or 'uv' for the texture "
                      "coordinates in the input");
  }
  check_baking(values, command);
  check_symmetric(values, atlas);
  check_repack(values, atlas);
  check_page_size(atlas);
  check_pages(command);
  check_gutter(values, atlas);
  if(atlas.pack_into_square) {
    check_quantization(values, atlas);
    return;
  }
  for(const char* option : {"resolution", "texels-per-unit", "block", "gutter", "mip-levels", "rotations",
                            "seam-price", "quantize"}) {
    if(is_given(values, option)) {
      throw Usage_error(std::string("--") + option +
                        " goes without --no-pack: it says how charts are packed");
    }
  }
  static_cast<TA::Packing_options&>(atlas) = TA::Packing_options();
  if(is_given(values, "units") && !atlas.is_in_world_units()) {
    throw Usage_error("--no-pack goes with --units world: only packed charts fill the unit square");
  }
  atlas.units = "world";
}

inline void check_method(const Command_line& command)
{
  if(!is_selection_file(command.cut)) {
    check_name("cut", command.cut, {"auto", "topology", "none", "the name of a .selection.txt file"});
  }
#ifndef ABF_WITH_CHOLMOD
  if(command.solver == "cholmod") {
    throw Usage_error("this program was built without CHOLMOD: use --solver superlu or --solver eigen");
  }
#endif
}

// Options that are not given are chosen for a result close to that of the direct method.
inline void refine_method(const Values& values, SMP::Hierarchical_options& hierarchical)
{
  if(values["simplification-rate"].defaulted()) {
    hierarchical.simplification_rate = 0.85;
  }
  if(values["angle-sweeps"].defaulted()) {
    hierarchical.angle_sweeps = 20;
  }
  if(hierarchical.angle_sweeps > 0) {
    hierarchical.energy_tolerance = 0.01;
  }
}

inline void check_names_of_files(const Values& values, const Command_line& command)
{
  std::vector<std::string> empty;
  if(std::count(command.inputs.begin(), command.inputs.end(), "") != 0) {
    empty.push_back("input");
  }
  for(const Output_option& option : output_options()) {
    if(values.count(option.name) != 0 && (command.*option.file).empty()) {
      empty.push_back(option.name);
    }
  }
  if(values.count("bake-from") != 0 && command.atlas.bake_from.empty()) {
    empty.push_back("bake-from");
  }
  if(values.count("texture") != 0 && command.texture.empty()) {
    empty.push_back("texture");
  }
  if(!empty.empty()) {
    throw Usage_error("the name after --" + empty.front() + " is empty: give the name of a file");
  }
}

inline void check_plain(const Values& values, Command_line& command)
{
  check_method(command);
  check_seams(values, command);
  if(command.is_plain) {
    check_injective(values, command);
    check_angles(command);
    check_cones(values, command);
  }
  check_equal_seams(values, command);
  if(command.method == "auto" && !command.options.injective) {
    refine_method(values, command.hierarchical);
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_OPTIONS_H
