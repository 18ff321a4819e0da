// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DESCRIBE_OPTIONS_H
#define FLATTEN_MESH_DESCRIBE_OPTIONS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Option_table.h"
#include "flatten_mesh/batch/describe_batch_options.h"
#include "flatten_mesh/model/formats.h"

#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline void describe_file_options(Command_line& command, Option_table& table)
{
  table.begin("Files");
  table.text(
      "input", command.inputs, "FILE",
      "the surface: ." + formats_text(", .", " or .") +
          "; '-' is standard input. The word '--input' may be left out. Several files are flattened one "
          "after the other; see --jobs");
  table.changes_no_result();
  table.text("format", command.format, "NAME", "of standard input and pipes: " + formats_text(", ", " or "));
  table.text(
      "output,o", command.output, "FILE.obj|ply|glb",
      "write the model with texture coordinates at each corner; faces without chart have (0, 0) there. "
      "Points and faces are those of the input, in their order; faces with a wrong orientation are turned. "
      "OBJ also "
      "keeps the rest of the model. PLY keeps normals and colours of points; texture coordinates are a "
      "list 'texcoord' of each face. GLB (where built with tinygltf) is binary glTF: triangles with "
      "normals, colours and materials, where v points down: 1 - v. From glTF to GLB, all else in the file "
      "stays, too; textures keep their coordinates, which become the second ones.");
  table.flag(
      "triangles", command.triangles,
      "OBJ and PLY: write triangles instead of polygons, which are divided such that all triangles have "
      "their front in front, in the plane and in space. For programs that draw polygons as fans, or read "
      "none");
  table.word(
      "ply-coordinates", command.ply_coordinates, {"face", "vertex"},
      "PLY: where texture coordinates are. face: a list 'texcoord' of each face. vertex: properties s and t, "
      "u and v, and texture_u and texture_v of vertices, which are there several times on seams. For "
      "programs that do not read such lists");
  table.text("texture", command.texture, "FILE.png|checkerboard",
             "OBJ and PLY: name this picture as the texture, also that of --chart-image, in NAME.mtl beside "
             "NAME.obj or a comment 'TextureFile'. Some programs show, or keep, texture coordinates only "
             "then. checkerboard: write NAME_checkerboard.png, and name it (where built with libpng)");
  table.flag(
      "placeholder-texture", command.has_placeholder_texture,
      "GLB: materials get a tiny texture, which changes no colours. Tools for glTF files remove texture "
      "coordinates that no texture refers to");
  table.text(
      "svg", command.svg, "FILE.svg",
      "draw the plane: each chart in a colour of its own, and both sides of a seam in the same colour. "
      "--plain: each triangle is coloured by the change of its angles");
  table.text(
      "picture", command.picture, "FILE.png",
      "draw the surface from six sides, with a checkerboard in the colour of each chart, and the plane "
      "beside it: squares remain squares where shapes are preserved, and are equally large where sizes are "
      "preserved. --plain: from one side");
  table.word(
      "up", command.up, {"auto", "x", "y", "z"},
      "x, y or z: the axis that points upwards in the picture and the report. auto: y or z, by the shape "
      "of the surface, or else by the format of the file");
  table.text(
      "report", command.report, "FILE.html",
      "write a page for browsers, which needs no network: the surface, which can be turned, beside the "
      "plane, both with a checkerboard, or coloured by chart or by distortion; the measures; the worst "
      "faces. Surfaces of more than 250,000 triangles are thinned for display (where built with three.js)");
  table.text(
      "chart-image", command.chart_image, "FILE.png",
      "write an image with the texels of a page, each in the colour of its chart, as in the SVG; texels "
      "without chart are transparent. With several pages, FILE contains <UDIM>, which stands for 1001, "
      "1002, ... (where built with libpng)");
  table.text(
      "seams-to", command.seams_to, "FILE.selection.txt",
      "write the edges along which the surface was cut open, for --seams-from, --cut, CGAL::Seam_mesh and "
      "CGAL's demo: pairs of vertices of the surface in FILE.obj, from 0");
  table.text(
      "json", command.json, "FILE.json",
      "write the report for programs. Angles are in radians; 'status' is OK or says what went wrong. If "
      "something is wrong, the file contains at least 'status', 'message' and 'input'. '-' in place of any "
      "of these seven files is standard output; the text for people is then on standard error. With several "
      "inputs, each of these names contains a '%', which stands for the name of the input without folder "
      "and extension. With one input, a '%' behind a digit is itself");
}

inline void describe_surface_options(Command_line& command, Option_table& table)
{
  table.begin("What is flattened");
  table.number(
      "component", command.component, "N", abf::Option_range{0},
      "only this connected component, numbered from 0 by falling number of faces. --plain: 0 by default");
  table.of_library(
      "stretch_bound", "BOUND",
      "--plain: 1.1, for --cut auto; if given, surfaces with borders and without handles also get such "
      "seams, which join all their borders",
      command.atlas);
  table.of_library("area_weight", "THETA",
                   "--plain: with --injective only, " +
                       abf::text_of_default<SMP::ABF_plus_plus_options>("area_weight") +
                       " if it is not given",
                   command.atlas, command.options);
  table.of_library(
      "equal_seam_lengths", "on|off",
      "An atlas has equal lengths only in charts that ABF++ maps directly. --plain: on where the direct "
      "method maps a surface that is cut; if that fails, lengths are free, with a note. With on, --plain "
      "takes the direct method also for large surfaces",
      command.atlas, command.options);
  table.word(
      "repair", command.repair, {"on", "off"},
      "on: vertices at the same place are merged (see --weld), faces with a different orientation are "
      "turned, and parts that touch in a vertex, or meet in an edge of more than two faces, are separated, "
      "with notes. off: such surfaces are refused");
  table.text(
      "weld", command.weld, "on|off|DISTANCE",
      "on: faces that do not share their vertices are joined along edges at exactly the same place, for "
      "example where a file was split along the seams of its texture. A distance, in units of the surface: "
      "faces are also joined where vertices are at most this far apart. Closed parts that touch, and both "
      "sides of a sheet, stay separate. off: nothing is joined. By default on for an atlas; with --plain, "
      "on if no two faces share a vertex, and otherwise off. Vertices that glTF splits within a mesh are "
      "joined "
      "unless this is off");
  table.flag(
      "unique-instances", command.unique_instances,
      "of glTF files: where several nodes show one mesh, each gets a part of the atlas, and a mesh, of its "
      "own. "
      "Otherwise the mesh is flattened once for all of them, at the place of the first");
}

inline void describe_atlas_options(Command_line& command, Option_table& table)
{
  Atlas_command& atlas = command.atlas;
  table.begin("The atlas");
  table.flag(
      "one-atlas", atlas.is_shared,
      "all inputs share one atlas, with the same texel density. --output and --seams-to contain a '%' and "
      "are written for each input; all other files are written once, for the whole");
  table.word("for", atlas.purpose, TA::internal::words_of_purposes().words,
             "what the atlas is for, which sets the next three options, --stretch-bound, --area-weight and "
             "--equal-seams, unless they are given. texture: many and even texels, with charts that are as "
             "isometric as possible, and cut so that they cover the square. few-charts: one chart for each "
             "component, if that gives an even scale. conformal: the angles of ABF++ in all charts");
  table.of_library("separate_overlaps", "on|off", "", command.atlas);
  table.of_library("isometric_charts", "on|off", "", command.atlas);
  table.of_library("seam_price", "PRICE", "With --seams-from or --charts-from-materials: inf", command.atlas);
  table.text_with_default(
      "seams", atlas.seams, "NAME",
      "where seams run. length: they are short. near-creases: along creases where that is hardly longer. "
      "auto: for textures, creases if few faces between them unfold without stretch, as those of boxes and "
      "cylinders; near-creases on other hard surfaces, which are flat between creases, as machine "
      "parts are; otherwise length. creases, or creases:DEGREES: first along edges whose faces "
      "differ by more than this angle, 40 degrees if it is not given; flat faces stay whole. For machine "
      "parts and buildings. hidden: in folds and cavities, and below and behind other parts. For characters");
  table.flag(
      "symmetric", atlas.is_symmetric,
      "symmetric seams, if the surface is symmetric in a plane, up to 1.5 % of the diagonal of its bounding "
      "box, and if they are at most 5 % longer than others. The program finds the plane, and tries several "
      "atlases: it takes about ten times as long");
  table.text("seams-from", atlas.seams_from, "FILE.selection.txt|uv",
             "keep these seams, and add more where they are needed: the seams in a file that --seams-to or "
             "CGAL's demo wrote, or the seams of the texture coordinates in the input");
  table.flag("charts-from-materials", atlas.charts_from_materials,
             "edges between faces of different materials are seams");
  table.flag(
      "repack", atlas.repacks,
      "keep the charts of the texture coordinates in the input, with their shapes, and only pack them anew, "
      "all with the same density of texels. Charts that are flipped or overlap themselves, and faces without "
      "coordinates, are named, and nothing is written");
  table.flag("repair-charts", atlas.repairs_charts,
             "with --repack: flatten such charts anew, and keep all others");
  table.number_with_default(
      "uv-set", atlas.uv_set, "N", abf::Option_range{0, 1},
      "0: the atlas becomes the first texture coordinates. 1: it becomes the second ones, as light maps have "
      "them, and the first ones of the input stay: TEXCOORD_1 of GLB, or a list 'texcoord1' of PLY files");
  table.text(
      "only-material", atlas.only_materials, "NAME[,NAME]",
      "only faces of these materials get charts. All others stay in the output with the texture coordinates "
      "that they had; the surface has a border there");
  table.text(
      "ignore", atlas.ignored, "NAME[,NAME]",
      "faces of these materials, OBJ objects or groups, or glTF meshes get no charts, and stay likewise");
  table.flag("no-pack", atlas.is_not_packed,
             "charts have the same size as in space, and lie in rows, in their order, not turned");
  table.word(
      "units", atlas.units, {"square", "world"},
      "square: the atlas fills the unit square. world: it is as large as the surface; charts that are not "
      "packed always are");
  table.text_with_default(
      "resolution", atlas.page, "N|WxH",
      "number of texels along each side of a page, or along its width and its height, as in 2048x1024. A "
      "page is the unit square, whatever its texels");
  table.of_library("texels_per_unit", "N", "", command.atlas);
  table.of_library("block", "N", "", command.atlas);
  table.of_library("gutter", "N", "", command.atlas);
  table.number("mip-levels", atlas.mip_levels, "N", abf::Option_range{0, 10},
               "charts stay apart in N reduced copies of the texture (mipmaps): a gutter of 2^N texels");
  table.of_library("number_of_rotations", "N", "", command.atlas);
  table.of_library("quantization_bits", "BITS",
                   "Faces with a corner that finds no place there are named. It goes with one page",
                   command.atlas);
  table.number(
      "simplify", atlas.simplified_triangles, "N", abf::Option_range{4},
      "first simplify the surface to N triangles, or to the fewest that keep it valid; the output is then "
      "the simplified surface");
  table.text(
      "bake-from", atlas.bake_from, "FILE",
      "bake this fine surface, in any format that is read, into the texture of the input: its normals, its "
      "distance, and its colours, if any. With --output NAME.obj, the pictures are NAME_normals.png, "
      "NAME_displacement.png and NAME_colors.png, and NAME.mtl names them. NAME.glb contains the pictures "
      "of normals and colours (where built with libpng)");
}

inline void describe_plain_options(Command_line& command, Option_table& table)
{
  table.begin("One chart instead of an atlas");
  table.flag(
      "plain", command.is_plain,
      "flatten one component, from one border, as one chart with its area in space, by ABF++ alone. Parts "
      "of the map may overlap");
  table.number_with_default(
      "border", command.border, "N", abf::Option_range{0},
      "the outer border of the component, numbered from 0 by falling length; all other borders are holes");
  table.text_with_default(
      "cut", command.cut, "NAME|FILE.selection.txt",
      "auto: closed surfaces and surfaces with handles are cut open along short seams that leave little "
      "stretch; other surfaces are flattened as they are, unless --stretch-bound is given. topology: only "
      "seams that make the surface a disk, and join its borders. none: nothing is cut. A file: only its "
      "seams; if they leave several disks, the largest is flattened");
  table.flag(
      "split-overlaps", command.split_overlaps,
      "where the map overlaps itself, split the chart along further seams into pieces whose maps do not. "
      "Coordinates do not change, so that pieces still lie over one another: move them apart as islands of "
      "the texture");
  table.text(
      "rectangle", command.rectangle, "V1,V2,V3,V4|auto",
      "the border becomes a rectangle with straight sides, whose corners are these four vertices, counted "
      "from 1, as in OBJ files. auto: the vertices nearest to the corners of the smallest rectangle around "
      "the map without this option. Edges that would cut off flat triangles are split in their middle; "
      "the output then has the triangles only");
  table.text(
      "border-angles", command.border_angles, "FILE",
      "the border gets these inner angles in the plane. The file has a line for each vertex with an angle: "
      "its number, from 1, and its angle in degrees, 180 on straight sides");
  table.number(
      "cones", command.cones, "N", abf::Option_range{0, 1000},
      "choose N vertices as cones, whose angles need not sum to 360 degrees in the plane, cut through "
      "them, and map such that both sides of each seam are equal up to a rigid motion. Borders stay free. "
      "There are fewer cones if fewer suffice");
  table.text(
      "cone-angle-multiple", command.cone_angle_multiple, "DEGREES",
      "with --cones: the angles around cones are multiples of this angle, and so are the turns from one "
      "side of a seam to the other; with 90, quarter turns. It divides 360; for spheres and disks");
  table.of_library(
      "injective", "",
      "With --method auto, the method is then hierarchical for any number of triangles; add --polish for "
      "less change of angles. With direct, the map of that method is kept if it does not overlap itself; "
      "otherwise, a polished injective map replaces it",
      command.options);
  table.of_library("clearance", "LENGTHS", "", command.options);
  table.of_library("holes", "NAME", "", command.options);
}

inline void describe_method_options(Command_line& command, Option_table& table)
{
  table.begin("How it is flattened, with --plain");
  table.word(
      "method", command.method, {"direct", "hierarchical", "auto"},
      "direct: ABF++ on the whole chart. hierarchical: on a simplified chart, which is then refined; for "
      "large surfaces. auto: hierarchical with --injective; otherwise direct for up to 200,000 triangles, "
      "and for more hierarchical, with a finer coarse chart and final sweeps, if an estimate says that the "
      "energy is at most 20 % higher than that of the direct method; otherwise direct");
  table.of_library("simplification_rate", "PART", "--method auto: 0.85", command.hierarchical);
  table.of_library("sweeps", "N", "", command.hierarchical);
  table.of_library("angle_sweeps", "N",
                   "--method auto: up to 20. --injective: 10 by default, or 3 to 5 for large charts",
                   command.hierarchical);
  table.of_library("polish", "", "", command.hierarchical);
  table.of_library(
      "fallbacks", "on|off",
      "Seams that cannot have equal lengths are then an error, too, if --equal-seams is not given",
      command.options);
  table.of_library("barrier", "KAPPA", "", command.options);
  table.of_library("layout", "NAME", "", command.options);
  table.of_library("tolerance", "RADIANS", "", command.options);
  table.of_library("max_iterations", "N", "", command.options);
  table.of_library("step", "NAME", "", command.options);
  table.of_library("linear_solver", "NAME", "", command.options);
  table.word("solver", command.solver, {"superlu", "eigen", "cholmod"},
             "of the linear systems: superlu, eigen, or cholmod where built with it");
}

inline void describe_other_options(Command_line& command, Option_table& table)
{
  table.begin("Other");
  table.of_library("threads", "N", "", command.options);
  table.changes_no_result();
  table.flag(
      "verbose,v", command.verbose,
      "print the progress on standard error: a line for every stage, and with --plain for every Newton "
      "step");
  table.changes_no_result();
  table.flag("quiet,q", command.quiet, "print nothing but errors: no report, no notes, no progress");
  table.changes_no_result();
  table.flag("help,h", command.help, "print this text");
  table.flag("version", command.version, "print the version");
}

inline Option_table all_options(Command_line& command)
{
  Option_table table;
  describe_file_options(command, table);
  describe_surface_options(command, table);
  describe_atlas_options(command, table);
  describe_plain_options(command, table);
  describe_method_options(command, table);
  describe_other_options(command, table);
  describe_batch_options(command.batch, table);
  return table;
}

} // namespace internal

// The names of the options that have no meaning for an atlas.
inline std::vector<std::string> options_of_plain_charts()
{
  Command_line ignored;
  internal::Option_table table;
  internal::describe_plain_options(ignored, table);
  std::vector<std::string> names = table.names_of_last_group();
  names.erase(names.begin()); // --plain itself
  internal::describe_method_options(ignored, table);
  for(const std::string& name : table.names_of_last_group()) {
    names.push_back(name);
  }
  return names;
}

// The names of the options that have no meaning with `--plain`.
inline std::vector<std::string> options_of_atlases()
{
  Command_line ignored;
  internal::Option_table table;
  internal::describe_atlas_options(ignored, table);
  return table.names_of_last_group();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DESCRIBE_OPTIONS_H
