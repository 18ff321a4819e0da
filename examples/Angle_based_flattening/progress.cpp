// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

// Prints a line for each step, and stops the computation when it has taken too long.
class Progress : public SMP::Flattening_visitor
{
public:
  explicit Progress(double seconds) : m_limit(seconds) { m_timer.start(); }

  bool start(Stage) override { return m_timer.time() < m_limit; }

  bool step(const SMP::ABF_plus_plus_step& step) override
  {
    std::cout << "step " << step.iteration << ": energy " << step.energy << ", violation "
              << step.constraint_residual << std::endl;
    return m_timer.time() < m_limit;
  }

private:
  CGAL::Real_timer m_timer;
  double m_limit;
};

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh) || CGAL::is_closed(mesh)) {
    std::cerr << "Cannot read the mesh, or it has no border.\n";
    return 1;
  }

  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  for(double seconds : {0., 60.}) {
    Progress progress(seconds);
    SMP::ABF_plus_plus_options options;
    options.visitor = &progress;
    SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
    if(SMP::parameterize(mesh, parameterizer, PMP::longest_border(mesh).first, uv) == SMP::OK)
      std::cout << "done within " << seconds << " seconds\n";
    else
      std::cout << "not done within " << seconds << " seconds: " << parameterizer.report().message << "\n";
  }
}
