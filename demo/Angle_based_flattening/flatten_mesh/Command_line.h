// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_COMMAND_LINE_H
#define FLATTEN_MESH_COMMAND_LINE_H

#include "texts.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>

#include <boost/program_options.hpp>

#include <sstream>
#include <string>

namespace flatten_mesh {

namespace SMP = CGAL::Surface_mesh_parameterization;

// What the user asks for.
struct Command_line
{
  std::string input;
  std::string output;
  std::string svg;
  std::string picture;
  std::string json;
  std::string seams;
  int component = 0;
  int border = 0;
  std::string cut = "auto";
  double stretch_bound = 1.1;
  bool asks_for_stretch = false; // whether the bound is given
  bool split_overlaps = false;
  std::string holes = "solve";
  std::string repair = "on";
  std::string method = "auto";
  std::string solver = "superlu";
  std::string layout = "auto";
  std::string step = "newton";
  std::string linear_solver = "iterative";
  SMP::ABF_plus_plus_options options;
  SMP::Hierarchical_options hierarchical;
  bool verbose = false;
  bool help = false;
  bool version = false;
};

namespace internal {

namespace po = boost::program_options;

inline po::options_description file_options(Command_line& command)
{
  po::options_description options("Files", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("input", po::value(&command.input)->value_name("FILE"),
      "the surface: OFF, OBJ, PLY, STL or TS (also VTP where built with VTK); the word '--input' may be left "
      "out");
  add("output,o", po::value(&command.output)->value_name("FILE.obj"),
      "write the surface with texture coordinates 'vt' as OBJ; vertices, faces and their order are those of "
      "the input; faces outside the chart have no 'vt'. The chart has the area it has in space.");
  add("svg", po::value(&command.svg)->value_name("FILE.svg"),
      "draw the chart, every triangle coloured by how much its angles change");
  add("picture", po::value(&command.picture)->value_name("FILE.png"),
      "draw the surface with a checkerboard of the plane: squares remain squares where shapes are preserved "
      "(where built with libpng)");
  add("seams", po::value(&command.seams)->value_name("FILE.selection.txt"),
      "write the edges along which the surface was cut open, for --cut, CGAL::Seam_mesh and CGAL's demo: "
      "pairs of "
      "vertices of the surface in FILE.obj, from 0");
  add("json", po::value(&command.json)->value_name("FILE.json"),
      "write the report for programs. Angles are in radians; 'status' is OK or the name of what went wrong. "
      "Also written when something is wrong, with 'status', 'message' and 'input' at least. A '-' in place "
      "of any of "
      "these five files is standard output; the text for people is then on standard error");
  return options;
}

// A number with its default, shown as it is meant and not with all the digits of a double.
inline po::typed_value<double>* number_option(double& number, const std::string& unit)
{
  return po::value(&number)->value_name(unit)->default_value(number, format_number("%g", number));
}

inline po::typed_value<int>* count_option(int& number)
{
  return po::value(&number)->value_name("N")->default_value(number);
}

inline po::typed_value<std::string>* name_option(std::string& name)
{
  return po::value(&name)->value_name("NAME")->default_value(name);
}

inline po::options_description chart_options(Command_line& command)
{
  po::options_description options("What is flattened", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("component", po::value(&command.component)->value_name("N")->default_value(command.component),
      "the connected component, numbered from 0 by falling number of faces");
  add("border", po::value(&command.border)->value_name("N")->default_value(command.border),
      "the component's outer border, numbered from 0 by falling length; all others are holes");
  add("cut", po::value(&command.cut)->value_name("NAME|FILE.selection.txt")->default_value(command.cut),
      "auto: closed surfaces and surfaces with handles are cut open along short seams that leave little "
      "stretch; all others are flattened as they are, unless --stretch-bound is given. topology: only seams "
      "that make the surface a disk; they also join its borders. none: nothing is cut. A file: its seams are "
      "used, "
      "and no others; of several disks that they leave, the largest is flattened");
  add("stretch-bound", number_option(command.stretch_bound, "BOUND"),
      "for --cut auto: seams are added until the scale stretch is at most this, where 1 is perfect and up to "
      "1.03 "
      "times the bound is let pass; if it is missed after five rounds or when more seams gain little, a note "
      "says so. If given, surfaces with borders and without handles get such seams, too, "
      "which join all their borders");
  add("split-overlaps", po::bool_switch(&command.split_overlaps),
      "where the map overlaps itself, split the chart along further seams into pieces whose maps do not. The "
      "coordinates stay as they are, so that pieces still lie over one another: move them apart as islands "
      "of "
      "the texture");
  add("injective", po::bool_switch(&command.options.injective),
      "a map in which no two triangles overlap, without further seams: where the map would overlap itself, "
      "its border is kept from touching itself, and angles change more. Holes are filled meanwhile. --method "
      "auto is hierarchical then, for any number of triangles; add --polish for less change of angles. "
      "direct: the result of that method if it does not overlap itself, and else a polished injective map");
  add("area-weight", number_option(command.options.area_weight, "THETA"),
      "how much an injective map keeps areas: 0 not at all, 1 as isometric as possible");
  add("clearance", number_option(command.options.clearance, "LENGTHS"),
      "parts of the border of an injective map that come nearer to one another than this many lengths of "
      "their edges repel each other");
  add("holes", name_option(command.holes),
      "solve: holes take the shape that changes angles least. fill: soft triangles cover the holes while the "
      "surface is flattened, so that their borders stay simple. refuse: a surface with holes is an error");
  add("repair", name_option(command.repair),
      "on: faces with vertices of their own are welded, faces that are oriented differently turned, and "
      "parts that "
      "touch in a vertex separated, each with a note. off: such surfaces are refused");
  return options;
}

inline po::options_description method_options(Command_line& command)
{
  SMP::ABF_plus_plus_options& abf = command.options;
  po::options_description options("How it is flattened", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("method", name_option(command.method),
      "direct: ABF++ on the whole chart. hierarchical: on a simplified chart, which is then refined; for "
      "large surfaces. auto: hierarchical with --injective. Else direct for up to 200,000 triangles. For "
      "more "
      "it is hierarchical, with a finer coarse chart and final sweeps, if that comes close to the direct "
      "method: energy at most 20 % higher. Else it is direct. An estimate decides");
  add("simplification-rate", number_option(command.hierarchical.simplification_rate, "PART"),
      "part of the vertices that the hierarchical method removes; auto: 0.85");
  add("sweeps", count_option(command.hierarchical.sweeps),
      "sweeps of relaxation on each level of the hierarchical method");
  add("angle-sweeps", count_option(command.hierarchical.angle_sweeps),
      "sweeps of the hierarchical method that lower the energy of the direct one in the end; auto: up to 20. "
      "--injective: 5 if none are asked for, or 3 for large charts");
  add("polish", po::bool_switch(&command.hierarchical.polish),
      "bring the result of the hierarchical method down to the distortion of the direct one");
  add("barrier", number_option(abf.barrier, "KAPPA"),
      "weight of the term that keeps angles away from zero; 0 is exactly the energy of the ABF++ paper");
  add("layout", name_option(command.layout),
      "the way from angles to coordinates. exact: along the border, then one Laplace equation; for charts "
      "with one border. least-squares: the way of the paper. auto: exact where it applies");
  add("tolerance", number_option(abf.tolerance, "RADIANS"), "largest violation of a constraint at a vertex");
  add("max-iterations", count_option(abf.max_iterations), "largest number of Newton steps");
  add("step", name_option(command.step),
      "newton: full Newton steps. sqp: without the constraints' second derivatives, as in the paper");
  add("linear-solver", name_option(command.linear_solver),
      "of a Newton step. iterative: preconditioned by small factors. direct: as a whole, as in the paper");
  add("threads", count_option(abf.threads), "at once; 0: one on each processor");
  add("solver", name_option(command.solver),
      "of the linear systems: superlu, eigen, or cholmod where built with it");
  return options;
}

inline po::options_description other_options(Command_line& command)
{
  po::options_description options("Other", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("verbose,v", po::bool_switch(&command.verbose),
      "tell on standard error what is done: a line for every stage and every Newton step");
  add("help,h", po::bool_switch(&command.help), "print this text");
  add("version", po::bool_switch(&command.version), "print the version");
  return options;
}

inline po::options_description all_options(Command_line& command)
{
  po::options_description options;
  options.add(file_options(command)).add(chart_options(command));
  options.add(method_options(command)).add(other_options(command));
  return options;
}

} // namespace internal

inline std::string help_text()
{
  Command_line defaults;
  std::ostringstream text;
  text << "flatten_mesh: flattens a surface into the plane, angle by angle (ABF++).\n\n"
          "usage: flatten_mesh FILE [options]\n"
       << internal::all_options(defaults)
       << "\nExamples:\n"
          "  flatten_mesh scan.ply --output flat.obj --svg flat.svg\n"
          "  flatten_mesh garment.obj --component 2 --output sleeve.obj --json sleeve.json\n"
          "  flatten_mesh mask.off --barrier 0 --layout least-squares --step sqp --verbose\n"
          "  flatten_mesh cow.off --output flat.obj --svg flat.svg --seams cow.selection.txt\n"
          "  flatten_mesh cow.off --cut cow.selection.txt --output flat.obj\n"
          "  flatten_mesh scan.ply --injective --output flat.obj\n"
          "\nMessages count vertices, faces and lines from 1, as OBJ files do.\n"
          "\nExit status: 0 when the flattening is valid, with no flipped triangle, and written where asked\n"
          "for; 1 when the computation failed; 2 when the command line or the input is wrong, or an output\n"
          "cannot be written; in these two cases neither OBJ nor SVG nor PNG are written. 3 when there is a\n"
          "layout, written where asked for, but of a surface without area, so that it means nothing.\n";
  return text.str();
}

inline std::string version_text()
{
  return "flatten_mesh " ABF_VERSION "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_COMMAND_LINE_H
