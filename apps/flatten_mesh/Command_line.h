// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_COMMAND_LINE_H
#define FLATTEN_MESH_COMMAND_LINE_H

#include "flatten_mesh/batch/Batch_options.h"

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Texture_atlas/internal/options/option_table.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;

// An atlas: the options of `make_atlas()`, and what the program does before and after that
struct Atlas_command : TA::Atlas_options
{
  bool is_shared = false; // all inputs have one atlas
  std::string purpose = "texture";
  std::string seams = "auto"; // or "length", "near-creases", "creases", "creases:DEGREES", "hidden"
  std::string seams_from;     // a file, "uv", or empty
  bool charts_from_materials = false;
  bool is_symmetric = false;   // seams are, if the surface is
  bool repacks = false;        // keeps the charts of the texture coordinates in the input
  bool repairs_charts = false; // of these, flattens those anew that are not injective
  int uv_set = 0;              // which set of texture coordinates the atlas becomes
  std::string only_materials;  // names with commas between them, or empty; likewise:
  std::string ignored;
  bool is_not_packed = false;
  std::string units = "square";
  std::string page = "1024"; // the texels along its sides, also as in "2048x1024"
  int mip_levels = 0;
  std::string bake_from;        // a file, or empty
  int simplified_triangles = 0; // 0: the surface stays as it is

  bool is_in_world_units() const { return units == "world"; }
  bool keeps_all_charts() const { return repacks && !repairs_charts; }

  // Sets the options of `make_atlas()` to what follows from the purpose and from all that stands here. Options that are
  // given come later.
  void set_defaults()
  {
    const std::vector<std::string> purposes = TA::internal::words_of_purposes().words;
    const auto found = std::find(purposes.begin(), purposes.end(), purpose);
    TA::Atlas_options& options = *this;
    options = found == purposes.end() ? TEXTURE : static_cast<Purpose>(found - purposes.begin());
    given_charts = keeps_all_charts() ? KEEP : repacks ? REPAIR : REPLACE;
    stretch_bound = keeps_all_charts() ? 2 : stretch_bound;
    pack_into_square = !is_not_packed;
    if(!seams_from.empty() || charts_from_materials) { // who gives charts wants these
      seam_price = std::numeric_limits<double>::infinity();
    }
  }
};

// What the user asks for.
struct Command_line
{
  std::vector<std::string> inputs;
  std::string input;  // the one that is flattened now: the name of a file; empty if there are several
  std::string title;  // its name to people: that of the file, or "standard input", or "3 models"
  std::string format; // of standard input
  std::string output;
  std::string svg;
  std::string picture;
  std::string up = "auto"; // the axis that points upwards in it
  std::string report;
  std::string chart_image;
  std::string json;
  std::string seams_to;
  bool triangles = false;               // in the output, instead of polygons
  std::string ply_coordinates = "face"; // or "vertex"
  std::string texture;                  // a picture that the output names, "checkerboard", or empty
  bool has_placeholder_texture = false;
  bool is_plain = false;
  Atlas_command atlas;
  Batch_options batch;
  int component = 0;
  bool asks_for_component = false; // whether it is given
  double stretch_bound = 1.1;      // with --plain; an atlas has its own default
  bool asks_for_stretch = false;   // whether the bound is given
  std::string repair = "on";
  std::string weld; // "on", "off", a distance, or empty: see `welding_of()`
  bool unique_instances = false;

  // With --plain
  int border = 0;
  std::string cut = "auto";
  bool split_overlaps = false;
  std::string rectangle;     // four vertices, "auto", or empty
  std::string border_angles; // a file
  int cones = 0;
  bool asks_for_cones = false;    // whether their number is given
  double cone_angle_multiple = 0; // degrees; 0: any angles
  std::string method = "auto";
  std::string solver = "superlu";
  SMP::ABF_plus_plus_options options; // an atlas takes `threads` of these
  SMP::Hierarchical_options hierarchical;

  bool verbose = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

// A text about the input's file, which is a copy if the input is standard input
inline std::string with_title(const Command_line& command, const std::string& text)
{
  return command.input.empty() ? text
                               : boost::replace_all_copy(text, "'" + command.input + "'", command.title);
}

// For the reports
inline std::string name_of_input(const Command_line& command)
{
  return command.input.empty() || command.title == "standard input" ? command.title : command.input;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_COMMAND_LINE_H
