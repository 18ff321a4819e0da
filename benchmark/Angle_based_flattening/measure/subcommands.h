// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_SUBCOMMANDS_H
#define ABF_BENCHMARK_SUBCOMMANDS_H

#include "Measurement.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>

#include <cstddef>
#include <string>

namespace ABF_benchmark {

struct Surface;

struct Mesh_changes
{
  std::size_t triangles = 0; // about that many; 0 for those that are there
  bool noise = false;
  int holes = 0, rings = 3;  // of triangles that a hole removes, around a vertex
  bool any_topology = false; // the result need not be a disk
};

// Reads a mesh, changes it, writes it (if `output` is not empty), and reports the number of its triangles. Fails if it
// has to be a disk, or a disk with holes, and is none.
void make_mesh(const std::string& file, const Mesh_changes& changes, const std::string& output,
               Measurement& m);

// Runs a method on a mesh, and measures the map.
void flatten(const std::string& method, const std::string& file,
             const CGAL::Surface_mesh_parameterization::Hierarchical_options& options, Measurement& m);

// The same for a surface that is already there
void flatten(const std::string& method, Surface& surface,
             const CGAL::Surface_mesh_parameterization::Hierarchical_options& options, Measurement& m);

struct Seam_choice_options
{
  double bound = 1.1; // of the stretch that is predicted, for `cones`
  int terminals = 10; // for the other choices
  std::string method = "abf++";
};

// Cuts a connected surface open along seams of our own choice (`cones`), or to the `farthest` points or to the `peaks`
// of curvature. Runs a method on the disk, and measures the map. Only cuts it open through `random` vertices.
void seams(const std::string& choice, const std::string& file, const Seam_choice_options& options,
           Measurement& m);

// Flattens a disk, or a surface that is cut open for that bound of its stretch, by ABF++, and splits the chart where it
// overlaps itself.
void overlaps(const std::string& file, double bound, Measurement& m);

struct Atlas_choice
{
  double bound = 0;                   // of the stretch; 0: that of the purpose
  std::string purpose = "few-charts"; // or "conformal" or "texture"
  bool checks = false;                // looks for flips, overlaps and shared texels
  std::string output;                 // a file for the surface, cut open; empty for none
};

// Makes an atlas of a surface. Polygons are triangulated before.
void atlas(const std::string& file, const Atlas_choice& choice, Measurement& m);

struct Packing_choice
{
  int regions = 0; // into which a surface is cut; 0 for seams that flatten it well
  int resolution = 1024;
  int gutter = 2;
  double pages = 0; // that charts would fill without gaps; 0 for one page, at the largest scale
};

// Cuts and flattens a surface, splits its charts where they overlap, and packs them, also by their rectangles.
void packing(const std::string& file, const Packing_choice& choice, Measurement& m);

struct Control_choice
{
  std::size_t cones = 16;
  int repeat = 3; // of how many runs in turn the medians of times are taken
};

// Selects cones of a connected surface, and leads seams through them. Maps the surface in several ways, in turn: cut
// first, with equal lengths along seams, with prescribed angles around cones, and with multiples of a right angle
// (spheres only). Prints a measurement for each, the last one by `m`.
void cones(const std::string& file, const Control_choice& choice, Measurement& m);

// The same for a disk: with a free border, with four right angles, and as a rectangle
void rectangle(const std::string& file, const Control_choice& choice, Measurement& m);

// Runs a linear solver on the matrix of the first Newton step: `full`, or the `block` of planarity.
void solve(const std::string& solver, const std::string& file, const std::string& matrix, Measurement& m);

// Factors both scalar blocks of that matrix with SuperLU and with Eigen, in turn, in single precision, and solves with
// them. Times are the least ones of several rounds.
void scalar_blocks(const std::string& file, int repeat, Measurement& m);

// Runs an algorithm of CGAL (`heat`, `fairing` or `deformation`) with `superlu`, or with `eigen`, its default solver.
// Reports the largest and the mean distance: from a vertex, or by which vertices moved.
void algorithm(const std::string& name, const std::string& solver, const std::string& file, Measurement& m);

// Solves the angles up to a gradient of that norm, and lays them out in three ways.
void lay_out(const std::string& file, double tolerance, Measurement& m);

// Flattens all components with a border by the `direct` or the `hierarchical` method, and those with several borders
// a second time with holes allowed. Skips the first runs. Prints a measurement before each run too, so that a crash
// can be attributed.
void sweep(const std::string& file, const std::string& method, int first_run, Measurement& m);

// The versions of the compiler and the libraries
void describe_software(Measurement& m);

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_SUBCOMMANDS_H
