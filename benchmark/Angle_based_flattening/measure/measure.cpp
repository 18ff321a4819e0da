// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures one thing and prints it as a line of JSON. The scripts in the folder above run it, each time in a process of
// its own, and make tables and plots of many such lines. See `measure` without arguments.

#include "subcommands.h"

#include <boost/program_options.hpp>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <vector>

namespace po = boost::program_options;

int main(int argc, char* argv[])
{
  using namespace ABF_benchmark;
  CGAL::Surface_mesh_parameterization::Hierarchical_options hierarchical;
  std::vector<std::string> words;
  Mesh_changes changes;
  Seam_choice_options seam_options;
  Atlas_choice atlas_choice;
  Packing_choice packing_choice;
  Control_choice control_choice;
  int first_run = 0;
  std::string output;
  po::options_description options(
      "measure mesh FILE [--triangles N] [--noise] [--holes N] [--rings N] [--any-topology] [--output FILE]\n"
      "measure flatten METHOD FILE [--simplification-rate X] [--sweeps N] [--angle-sweeps N] [--polish]\n"
      "                            [--injective] [--area-weight X] [--clearance X]\n"
      "measure seams cones|farthest|peaks|random FILE [--bound X] [--terminals N] [--method METHOD]\n"
      "measure overlaps FILE [--bound X]\n"
      "measure atlas FILE [--bound X] [--for PURPOSE] [--check] [--output FILE]\n"
      "measure packing FILE [--regions N] [--resolution N] [--gutter N] [--pages N]\n"
      "measure cones FILE [--cones N] [--repeat N]\n"
      "measure rectangle FILE [--repeat N]\n"
      "measure solve SOLVER FILE full|block\n"
      "measure scalar-blocks FILE [--repeat N]\n"
      "measure algorithm heat|fairing|deformation superlu|eigen FILE\n"
      "measure layouts FILE TOLERANCE\n"
      "measure sweep FILE direct|hierarchical [--first-run N]\n"
      "measure software\n\nOptions");
  options.add_options()("triangles", po::value(&changes.triangles),
                        "simplify or subdivide to about that many")(
      "noise", po::bool_switch(&changes.noise), "move each vertex by a tenth of its shortest edge")(
      "holes", po::value(&changes.holes), "punch that many holes")("rings", po::value(&changes.rings),
                                                                   "rings of triangles that a hole removes")(
      "output", po::value(&output), "write the mesh there")("simplification-rate",
                                                            po::value(&hierarchical.simplification_rate),
                                                            "simplification rate of hierarchical methods")(
      "sweeps", po::value(&hierarchical.sweeps), "sweeps on each level")(
      "polish", po::bool_switch(&hierarchical.polish), "start the direct solver from the refined map")(
      "angle-sweeps", po::value(&hierarchical.angle_sweeps), "final sweeps on the energy of the angles")(
      "injective", po::bool_switch(&hierarchical.injective), "make a map that does not overlap itself")(
      "area-weight", po::value(&hierarchical.area_weight), "of injective maps; 1 is isometric")(
      "clearance", po::value(&hierarchical.clearance), "between parts of the border, in edge lengths")(
      "any-topology", po::bool_switch(&changes.any_topology), "the mesh need not be a disk")(
      "bound", po::value(&seam_options.bound), "of the stretch that is predicted")(
      "terminals", po::value(&seam_options.terminals), "number of ends of seams")(
      "for", po::value(&atlas_choice.purpose), "few-charts, conformal or texture: what the atlas is for")(
      "check", po::bool_switch(&atlas_choice.checks), "look for flips, overlaps and shared texels")(
      "method", po::value(&seam_options.method), "what flattens the surface that is cut open")(
      "regions", po::value(&packing_choice.regions), "number of regions that a surface is cut into")(
      "pages", po::value(&packing_choice.pages), "number of pages that charts would fill without gaps")(
      "resolution", po::value(&packing_choice.resolution),
      "texels along a side of the unit square")("cones", po::value(&control_choice.cones), "number of cones")(
      "repeat", po::value(&control_choice.repeat),
      "number of runs in turn")("gutter", po::value(&packing_choice.gutter), "texels between two charts")(
      "first-run", po::value(&first_run), "number of runs to leave out")(
      "words", po::value(&words), "the subcommand and its arguments; the word '--words' is left out");
  Measurement m;
  try {
    po::variables_map values;
    po::store(po::command_line_parser(argc, argv)
                  .options(options)
                  .positional(po::positional_options_description().add("words", -1))
                  .run(),
              values);
    po::notify(values);
    const auto is = [&](const char* subcommand, const std::size_t arguments) {
      return words.size() == arguments + 1 && words[0] == subcommand;
    };
    if(is("mesh", 1)) {
      make_mesh(words[1], changes, output, m);
    } else if(is("flatten", 2)) {
      flatten(words[1], words[2], hierarchical, m);
    } else if(is("seams", 2)) {
      seams(words[1], words[2], seam_options, m);
    } else if(is("overlaps", 1)) {
      overlaps(words[1], seam_options.bound, m);
    } else if(is("atlas", 1)) {
      if(values.count("bound") > 0)
        atlas_choice.bound = seam_options.bound;
      atlas_choice.output = output;
      atlas(words[1], atlas_choice, m);
    } else if(is("packing", 1)) {
      packing(words[1], packing_choice, m);
    } else if(is("cones", 1)) {
      cones(words[1], control_choice, m);
    } else if(is("rectangle", 1)) {
      rectangle(words[1], control_choice, m);
    } else if(is("solve", 3)) {
      solve(words[1], words[2], words[3], m);
    } else if(is("scalar-blocks", 1)) {
      scalar_blocks(words[1], control_choice.repeat, m);
    } else if(is("algorithm", 3)) {
      algorithm(words[1], words[2], words[3], m);
    } else if(is("layouts", 2)) {
      lay_out(words[1], std::stod(words[2]), m);
    } else if(is("sweep", 2)) {
      sweep(words[1], words[2], first_run, m);
    } else if(is("software", 0)) {
      describe_software(m);
    } else {
      std::cerr << options;
      return EXIT_FAILURE;
    }
  } catch(const std::bad_alloc&) {
    m.fail("out of memory");
  } catch(const std::exception& error) {
    m.fail(error.what());
  }
  std::cout << m;
  return EXIT_SUCCESS;
}
