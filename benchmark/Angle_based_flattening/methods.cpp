// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flattens the meshes in files by the methods that ABF++ is compared with, once each, and prints a Markdown table: for a
// look. `methods --method abf --method stretch FILE...`; see `--help`.

#include "methods/Method.h"
#include "solvers/format.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certify.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/read_chart.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ABF_benchmark {

using solvers::format_number;

Chart read_chart(const std::string& file)
{
  typedef CGAL::Surface_mesh<Chart::Point_3> Mesh;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read a mesh from '" + file + "'");
  abf::Chart_reader<Mesh> reader(mesh);
  abf::Chart_defect defect = reader.read(CGAL::Polygon_mesh_processing::longest_border(mesh).first);
  if(!defect)
    defect = abf::diagnose(reader.chart, false);
  if(defect)
    throw std::runtime_error("'" + file + "' cannot be flattened: " + defect.message);
  return reader.chart;
}

std::vector<std::string> measures(const Chart& chart, const std::vector<Point_2>& uv)
{
  const std::vector<double> beta = abf::target_angles(chart);
  double distortion = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    distortion += abf::angular_distortion(chart, beta, uv, t) / chart.number_of_triangles();
  const abf::Stretch_and_shear both = abf::stretch_and_shear(chart, uv);
  return {format_number("%.4g", both.l2_shear), format_number("%.4g", both.l2_stretch),
          format_number("%.3e", distortion), std::to_string(abf::flipped_triangles(chart, uv).size())};
}

std::string row(const Chart& chart, const Method& method)
{
  std::vector<Point_2> uv;
  Run_report report;
  CGAL::Real_timer timer;
  timer.start();
  const bool done = method.flatten(chart, uv, report);
  std::vector<std::string> cells = {method.title, solvers::format_seconds(timer.time()),
                                    report.iterations > 0 ? std::to_string(report.iterations) : "–"};
  if(uv.size() == chart.points.size())
    for(const std::string& cell : measures(chart, uv))
      cells.push_back(cell);
  else
    cells.insert(cells.end(), 4, "–");
  cells.push_back(done ? "" : "FAILED: " + report.failure);
  return solvers::markdown_row(cells);
}

std::vector<Method> choose(const std::vector<std::string>& names)
{
  const std::vector<Method> methods = all_methods();
  std::vector<Method> chosen;
  for(const std::string& name : names) {
    const auto found =
        std::find_if(methods.begin(), methods.end(), [&](const Method& m) { return m.name == name; });
    if(found == methods.end())
      throw std::runtime_error("there is no method '" + name + "'; see --help");
    chosen.push_back(*found);
  }
  return names.empty() ? methods : chosen;
}

std::string help_text(const boost::program_options::options_description& options)
{
  std::ostringstream text;
  text << "methods: flattens meshes by the methods that ABF++ is compared with.\n\n"
          "usage: methods [options] FILE...\n"
       << options << "\nMethods:\n";
  for(const Method& method : all_methods())
    text << "  " << method.name << ": " << method.title << "\n";
  return text.str();
}

int run(int argc, char* argv[])
{
  namespace po = boost::program_options;
  std::vector<std::string> names, files;
  po::options_description visible("Options"), hidden;
  visible.add_options()("method", po::value(&names)->value_name("NAME"),
                        "a method; may be given again; all by default")("help,h", "print this text");
  hidden.add(visible).add_options()("mesh", po::value(&files));
  po::variables_map values;
  const po::positional_options_description positional = po::positional_options_description().add("mesh", -1);
  po::store(po::command_line_parser(argc, argv).options(hidden).positional(positional).run(), values);
  po::notify(values);
  if(values.count("help") > 0 || files.empty()) {
    std::cout << help_text(visible);
    return values.count("help") > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  const std::vector<Method> methods = choose(names);
  for(const std::string& file : files) {
    const Chart chart = read_chart(file);
    std::cout << "\n"
              << file << ", " << chart.number_of_triangles() << " triangles:\n\n"
              << solvers::markdown_head({"method", "seconds", "steps", "L2 shear", "L2 stretch",
                                         "angular distortion", "flips", ""},
                                        1);
    for(const Method& method : methods)
      std::cout << row(chart, method) << std::flush;
  }
  return EXIT_SUCCESS;
}

} // namespace ABF_benchmark

int main(int argc, char* argv[])
{
  try {
    return ABF_benchmark::run(argc, argv);
  } catch(const std::exception& error) {
    std::cerr << "methods: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
