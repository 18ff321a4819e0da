// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DESCRIBE_OPTIONS_H
#define FLATTEN_MESH_DESCRIBE_OPTIONS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/batch/describe_batch_options.h"
#include "flatten_mesh/model/formats.h"
#include "flatten_mesh/texts.h"

#include <boost/program_options.hpp>

#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

namespace po = boost::program_options;

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

inline po::options_description file_options(Command_line& command)
{
  po::options_description options("Files", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("input", po::value(&command.inputs)->value_name("FILE"),
      ("the surface: ." + formats_text(", .", " or .") +
       "; '-' is standard input. The word '--input' may be left out. Several files are flattened one "
       "after the other; see --jobs")
          .c_str());
  add("format", po::value(&command.format)->value_name("NAME"),
      ("of standard input and pipes: " + formats_text(", ", " or ")).c_str());
  add("output,o", po::value(&command.output)->value_name("FILE.obj|ply|glb"),
      "write the model with texture coordinates at each corner; faces without chart have none. Points and "
      "faces are those of the input, in their order; faces with a wrong orientation are turned. OBJ also "
      "keeps the rest of the model. PLY keeps normals and colours of points; texture coordinates are a "
      "list 'texcoord' of each face. GLB (where built with tinygltf) is binary glTF: triangles with "
      "normals, colours and materials, where v points down: 1 - v. From glTF to GLB, all else in the file "
      "stays, too; textures keep their coordinates, which become the second ones");
  add("svg", po::value(&command.svg)->value_name("FILE.svg"),
      "draw the plane: each chart in a colour of its own, and both sides of a seam in the same colour. "
      "--plain: each triangle is coloured by the change of its angles");
  add("picture", po::value(&command.picture)->value_name("FILE.png"),
      "draw the surface from six sides, with a checkerboard in the colour of each chart, and the plane "
      "beside it: squares remain squares where shapes are preserved, and are equally large where sizes are "
      "preserved. --plain: from one side");
  add("up", name_option(command.up),
      "x, y or z: the axis that points upwards in the picture and the report. auto: y or z, by the shape "
      "of the surface, or else by the format of the file");
  add("report", po::value(&command.report)->value_name("FILE.html"),
      "write a page for browsers, which needs no network: the surface, which can be turned, beside the "
      "plane, both with a checkerboard, or coloured by chart or by distortion; the measures; the worst "
      "faces. Surfaces of more than 250,000 triangles are thinned for display (where built with three.js)");
  add("chart-image", po::value(&command.chart_image)->value_name("FILE.png"),
      "write an image with the texels of a page, each in the colour of its chart, as in the SVG; texels "
      "without chart are transparent. With several pages, FILE contains <UDIM>, which stands for 1001, "
      "1002, ... (where built with libpng)");
  add("seams-to", po::value(&command.seams_to)->value_name("FILE.selection.txt"),
      "write the edges along which the surface was cut open, for --seams-from, --cut, CGAL::Seam_mesh and "
      "CGAL's demo: pairs of vertices of the surface in FILE.obj, from 0");
  add("json", po::value(&command.json)->value_name("FILE.json"),
      "write the report for programs. Angles are in radians; 'status' is OK or says what went wrong. If "
      "something is wrong, the file contains at least 'status', 'message' and 'input'. '-' in place of any "
      "of these seven files is standard output; the text for people is then on standard error. With several "
      "inputs, each of these names contains a '%', which stands for the name of the input without folder "
      "and extension. With one input, a '%' behind a digit is itself");
  return options;
}

inline po::options_description surface_options(Command_line& command)
{
  po::options_description options("What is flattened", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("component", po::value(&command.component)->value_name("N"),
      "only this connected component, numbered from 0 by falling number of faces. --plain: 0 by default");
  add("stretch-bound", po::value(&command.stretch_bound)->value_name("BOUND"),
      "seams are added until the scale stretch of each chart is at most this bound; 1 is perfect. Up to "
      "1.03 times the bound is accepted; otherwise, a note says that the bound is missed. 1.07 for textures "
      "if it is not given, and otherwise 1.1. --plain: for --cut auto; if given, surfaces with borders and "
      "without handles also get such seams, which join all "
      "their borders");
  add("area-weight", po::value(&command.options.area_weight)->value_name("THETA"),
      ("how much injective maps preserve areas: 0 not at all, 1 as isometric as possible. If it is not "
       "given, 1 for textures, and 0.02 for other atlases; --plain: with --injective only, " +
       format_number("%g", command.options.area_weight) + " if it is not given")
          .c_str());
  add("equal-seams", po::value(&command.equal_seams)->value_name("on|off"),
      "on: both sides of each edge on a seam get equal lengths, so that the scale does not jump there. "
      "off: their lengths are free. By default, they are free for textures, equal in the charts of other "
      "atlases that ABF++ maps directly, and with --plain where the direct method maps a surface that is "
      "cut; if that fails, "
      "lengths are free, with a note. --plain with on takes the direct method also for large surfaces");
  add("repair", name_option(command.repair),
      "on: vertices at the same place are merged (see --weld), faces with a different orientation are "
      "turned, and parts that touch in a vertex, or meet in an edge of more than two faces, are separated, "
      "with notes. off: such surfaces are refused");
  add("weld", po::value(&command.weld)->value_name("on|off|DISTANCE"),
      "on: faces that do not share their vertices are joined along edges at exactly the same place, for "
      "example where a file was split along the seams of its texture. A distance, in units of the surface: "
      "faces are also joined where vertices are at most this far apart. Closed parts that touch, and both "
      "sides of a sheet, stay separate. off: nothing is joined. By default on for an atlas; with --plain, "
      "on if no two faces share a vertex, and otherwise off. Vertices that glTF splits within a mesh are "
      "joined "
      "unless this is off");
  add("unique-instances", po::bool_switch(&command.unique_instances),
      "of glTF files: where several nodes show one mesh, each gets a part of the atlas, and a mesh, of its "
      "own. "
      "Otherwise the mesh is flattened once for all of them, at the place of the first");
  return options;
}

inline po::options_description atlas_options(Command_line& command)
{
  Atlas_options& atlas = command.atlas;
  po::options_description options("The atlas", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("one-atlas", po::bool_switch(&atlas.is_shared),
      "all inputs share one atlas, with the same texel density. --output and --seams-to contain a '%' and "
      "are written for each input; all other files are written once, for the whole");
  add("for", name_option(atlas.purpose),
      "what the atlas is for, which sets the next three options, --stretch-bound, --area-weight and "
      "--equal-seams, unless they are given. texture: many and even texels, with charts that are as "
      "isometric as possible, and cut so that they cover the square. few-charts: one chart for each "
      "component, if that gives an even scale. conformal: the angles of ABF++ in all charts");
  add("separate", po::value(&atlas.separates)->value_name("on|off"),
      "on: where the map of ABF++ overlaps itself, split the chart into several, which keep their maps. "
      "off: change the map. texture, conformal: on; few-charts: off");
  add("isometric", po::value(&atlas.isometric)->value_name("on|off"),
      "on: all charts get injective maps that are as isometric as possible. off: maps keep the angles of "
      "ABF++ where they can. texture: on; few-charts, conformal: off");
  add("seam-price", po::value<double>()->value_name("PRICE")->notifier([&atlas](const double price) {
    atlas.seam_price = price;
  }),
      "cut charts in two as long as they then cover more of the square: by a factor of e^(price x length), "
      "where the length of new seams is in units of the square root of the area; inf: cut none. texture, "
      "conformal: 0.04; few-charts, or with --seams-from or --charts-from-materials: inf");
  add("seams", po::value(&atlas.seams)->value_name("NAME")->default_value(atlas.seams),
      "where seams run. length: they are short. near-creases: along creases where that is hardly longer. "
      "auto: for textures, creases if few faces between them unfold without stretch, as those of boxes and "
      "cylinders; near-creases on other hard surfaces, which are flat between creases, as machine "
      "parts are; otherwise length. creases, or creases:DEGREES: first along edges whose faces "
      "differ by more than this angle, 40 degrees if it is not given; flat faces stay whole. For machine "
      "parts and buildings. hidden: in folds and cavities, and below and behind other parts. For characters");
  add("symmetric", po::bool_switch(&atlas.is_symmetric),
      "symmetric seams, if the surface is symmetric in a plane, up to 1.5 % of the diagonal of its bounding "
      "box, and if they are at most 5 % longer than others. The program finds the plane, and tries several "
      "atlases: it takes about ten times as long");
  add("seams-from", po::value(&atlas.seams_from)->value_name("FILE.selection.txt|uv"),
      "keep these seams, and add more where they are needed: the seams in a file that --seams-to or "
      "CGAL's demo wrote, or the seams of the texture coordinates in the input");
  add("charts-from-materials", po::bool_switch(&atlas.charts_from_materials),
      "edges between faces of different materials are seams");
  add("repack", po::bool_switch(&atlas.repacks),
      "keep the charts of the texture coordinates in the input, with their shapes, and only pack them anew, "
      "all with the same density of texels. Charts that are flipped or overlap themselves, and faces without "
      "coordinates, are named, and nothing is written");
  add("repair-charts", po::bool_switch(&atlas.repairs_charts),
      "with --repack: flatten such charts anew, and keep all others");
  add("uv-set", count_option(atlas.uv_set),
      "0: the atlas becomes the first texture coordinates. 1: it becomes the second ones, as light maps have "
      "them, and the first ones of the input stay: TEXCOORD_1 of GLB, or a list 'texcoord1' of PLY files");
  add("only-material", po::value(&atlas.only_materials)->value_name("NAME[,NAME]"),
      "only faces of these materials get charts. All others stay in the output with the texture coordinates "
      "that they had; the surface has a border there");
  add("ignore", po::value(&atlas.ignored)->value_name("NAME[,NAME]"),
      "faces of these materials, OBJ objects or groups, or glTF meshes get no charts, and stay likewise");
  add("no-pack", po::bool_switch()->notifier([&atlas](const bool is_given) { atlas.is_packed = !is_given; }),
      "charts have the same size as in space, and lie in rows, in their order, not turned");
  add("units", name_option(atlas.units),
      "square: the atlas fills the unit square. world: it is as large as the surface; charts that are not "
      "packed always are");
  add("resolution", po::value(&atlas.page)->value_name("N|WxH")->default_value(atlas.page),
      "number of texels along each side of a page, or along its width and its height, as in 2048x1024. A "
      "page is the unit square, whatever its texels");
  add("texels-per-unit", po::value(&atlas.texels_per_unit)->value_name("N"),
      "number of texels per unit of length on the surface. There are as many pages as the charts then "
      "take, side by side as in UDIM, ten in a row; charts larger than a page are cut. Without it, there is "
      "one page, which the charts fill");
  add("block", count_option(atlas.block),
      "no block of N x N texels belongs to two charts, for compressed textures; N divides --resolution");
  add("gutter", po::value(&atlas.gutter)->value_name("N"),
      "number of texels that stay free between charts; by default, a 256th of --resolution, at least 1");
  add("mip-levels", po::value(&atlas.mip_levels)->value_name("N"),
      "charts stay apart in N reduced copies of the texture (mipmaps): a gutter of 2^N texels");
  add("rotations", count_option(atlas.rotations), "number of directions in which each large chart is tried");
  add("simplify", po::value(&atlas.simplified_triangles)->value_name("N"),
      "first simplify the surface to N triangles, or to the fewest that keep it valid; the output is then "
      "the simplified surface");
  add("bake-from", po::value(&atlas.bake_from)->value_name("FILE"),
      "bake this fine surface, in any format that is read, into the texture of the input: its normals, its "
      "distance, and its colours, if any. With --output NAME.obj, the pictures are NAME_normals.png, "
      "NAME_displacement.png and NAME_colors.png, and NAME.mtl names them. NAME.glb contains the pictures "
      "of normals and colours (where built with libpng)");
  return options;
}

inline po::options_description plain_options(Command_line& command)
{
  po::options_description options("One chart instead of an atlas", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("plain", po::bool_switch(&command.is_plain),
      "flatten one component, from one border, as one chart with its area in space, by ABF++ alone. Parts "
      "of the map may overlap");
  add("border", po::value(&command.border)->value_name("N")->default_value(command.border),
      "the outer border of the component, numbered from 0 by falling length; all other borders are holes");
  add("cut", po::value(&command.cut)->value_name("NAME|FILE.selection.txt")->default_value(command.cut),
      "auto: closed surfaces and surfaces with handles are cut open along short seams that leave little "
      "stretch; other surfaces are flattened as they are, unless --stretch-bound is given. topology: only "
      "seams that make the surface a disk, and join its borders. none: nothing is cut. A file: only its "
      "seams; if they leave several disks, the largest is flattened");
  add("split-overlaps", po::bool_switch(&command.split_overlaps),
      "where the map overlaps itself, split the chart along further seams into pieces whose maps do not. "
      "Coordinates do not change, so that pieces still lie over one another: move them apart as islands of "
      "the texture");
  add("rectangle", po::value(&command.rectangle)->value_name("V1,V2,V3,V4|auto"),
      "the border becomes a rectangle with straight sides, whose corners are these four vertices, counted "
      "from 1, as in OBJ files. auto: the vertices nearest to the corners of the smallest rectangle around "
      "the map without this option. Edges that would cut off flat triangles are split in their middle; the "
      "output then has the triangles only");
  add("border-angles", po::value(&command.border_angles)->value_name("FILE"),
      "the border gets these inner angles in the plane. The file has a line for each vertex with an angle: "
      "its number, from 1, and its angle in degrees, 180 on straight sides");
  add("cones", po::value(&command.cones)->value_name("N"),
      "choose N vertices as cones, whose angles need not sum to 360 degrees in the plane, cut through "
      "them, and map such that both sides of each seam are equal up to a rigid motion. Borders stay free. "
      "There are fewer cones if fewer suffice");
  add("cone-angle-multiple", po::value(&command.cone_angle_multiple)->value_name("DEGREES"),
      "with --cones: the angles around cones are multiples of this angle, and so are the turns from one "
      "side of a seam to the other; with 90, quarter turns. It divides 360; for spheres and disks");
  add("injective", po::bool_switch(&command.options.injective),
      "no two triangles of the map overlap, and no seam is added: the border is kept from touching itself, "
      "and angles change more. Holes are filled during the computation. With --method auto, the method is "
      "then hierarchical for any number of triangles; add --polish for less change of angles. With direct, "
      "the map of that method is kept if it does not overlap itself; otherwise, a polished injective map "
      "replaces it");
  add("clearance", number_option(command.options.clearance, "LENGTHS"),
      "the distance below which parts of the border of an injective map repel each other, in lengths of "
      "their edges");
  add("holes", name_option(command.holes),
      "solve: holes take the shape that changes angles least. fill: soft triangles cover the holes while the "
      "surface is flattened, so that their borders stay simple. refuse: a surface with holes is an error");
  return options;
}

inline po::options_description method_options(Command_line& command)
{
  SMP::ABF_plus_plus_options& abf = command.options;
  po::options_description options("How it is flattened, with --plain", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("method", name_option(command.method),
      "direct: ABF++ on the whole chart. hierarchical: on a simplified chart, which is then refined; for "
      "large surfaces. auto: hierarchical with --injective; otherwise direct for up to 200,000 triangles, "
      "and for more hierarchical, with a finer coarse chart and final sweeps, if an estimate says that the "
      "energy is at most 20 % higher than that of the direct method; otherwise direct");
  add("simplification-rate", number_option(command.hierarchical.simplification_rate, "PART"),
      "part of the vertices that the hierarchical method removes; auto: 0.85");
  add("sweeps", count_option(command.hierarchical.sweeps),
      "sweeps of relaxation on each level of the hierarchical method");
  add("angle-sweeps", count_option(command.hierarchical.angle_sweeps),
      "final sweeps of the hierarchical method that lower the energy of the direct method; auto: up to 20. "
      "--injective: 10 by default, or 3 to 5 for large charts");
  add("polish", po::bool_switch(&command.hierarchical.polish),
      "lower the distortion of the hierarchical method to that of the direct method");
  add("barrier", number_option(abf.barrier, "KAPPA"),
      "weight of the term that keeps angles away from zero; 0 is exactly the energy of the ABF++ paper");
  add("layout", name_option(command.layout),
      "how coordinates are computed from angles. exact: along the border, then one Laplace equation; for "
      "charts with one border. least-squares: as in the paper. auto: exact where possible");
  add("tolerance", number_option(abf.tolerance, "RADIANS"), "largest violation of a constraint at a vertex");
  add("max-iterations", count_option(abf.max_iterations), "largest number of Newton steps");
  add("step", name_option(command.step),
      "newton: full Newton steps. sqp: without the constraints' second derivatives, as in the paper");
  add("linear-solver", name_option(command.linear_solver),
      "of a Newton step. iterative: preconditioned by small factors. direct: as a whole, as in the paper");
  add("solver", name_option(command.solver),
      "of the linear systems: superlu, eigen, or cholmod where built with it");
  return options;
}

inline po::options_description other_options(Command_line& command)
{
  po::options_description options("Other", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("threads", count_option(command.options.threads), "number of threads; 0: one on each processor");
  add("verbose,v", po::bool_switch(&command.verbose),
      "print the progress on standard error: a line for every stage, and with --plain for every Newton "
      "step");
  add("quiet,q", po::bool_switch(&command.quiet),
      "print nothing but errors: no report, no notes, no progress");
  add("help,h", po::bool_switch(&command.help), "print this text");
  add("version", po::bool_switch(&command.version), "print the version");
  return options;
}

inline po::options_description all_options(Command_line& command)
{
  po::options_description options;
  options.add(file_options(command)).add(surface_options(command)).add(atlas_options(command));
  options.add(plain_options(command)).add(method_options(command)).add(other_options(command));
  options.add(describe_batch_options(command.batch));
  return options;
}

inline std::vector<std::string> names_of(const po::options_description& options)
{
  std::vector<std::string> names;
  for(const auto& option : options.options()) {
    names.push_back(option->long_name());
  }
  return names;
}

} // namespace internal

// The names of the options that have no meaning for an atlas.
inline std::vector<std::string> options_of_plain_charts()
{
  Command_line ignored;
  internal::po::options_description options;
  options.add(internal::plain_options(ignored)).add(internal::method_options(ignored));
  std::vector<std::string> names = internal::names_of(options);
  names.erase(names.begin()); // --plain itself
  return names;
}

// The names of the options that have no meaning with `--plain`.
inline std::vector<std::string> options_of_atlases()
{
  Command_line ignored;
  return internal::names_of(internal::atlas_options(ignored));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DESCRIBE_OPTIONS_H
