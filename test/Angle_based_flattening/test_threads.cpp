// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops on several threads, and many charts that are flattened at the same time by copies of one parameterizer

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_threads)

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> UV_map;

namespace {

const int number_of_threads = 4;

std::vector<Mesh> meshes_of_several_sizes()
{
  std::vector<Mesh> meshes(number_of_threads);
  for(int i = 0; i < number_of_threads; ++i)
    test_meshes::make_bump(15 + 5 * i, meshes[i]);
  return meshes;
}

// The result for each mesh
template <typename Parameterizer>
struct Run
{
  Parameterizer parameterizer;
  UV_map uv;
  SMP::Error_code code;

  void operator()(Mesh& mesh)
  {
    code =
        SMP::parameterize(mesh, parameterizer, CGAL::Polygon_mesh_processing::longest_border(mesh).first, uv);
  }
};

template <typename Parameterizer>
void check_copies(const Parameterizer& original)
{
  std::vector<Mesh> meshes = meshes_of_several_sizes();
  std::vector<Run<Parameterizer>> at_once, alone;
  for(Mesh& mesh : meshes) {
    at_once.push_back(
        {original, mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:a").first, {}});
    alone.push_back({original, mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:b").first, {}});
  }
  std::vector<std::thread> threads;
  for(int i = 0; i < number_of_threads; ++i)
    threads.emplace_back([&, i] { at_once[i](meshes[i]); });
  for(std::thread& thread : threads)
    thread.join();
  for(int i = 0; i < number_of_threads; ++i) {
    alone[i](meshes[i]);
    BOOST_TEST(at_once[i].code == SMP::OK);
    const auto& report = at_once[i].parameterizer.report();
    BOOST_TEST(report.triangles == static_cast<int>(meshes[i].number_of_faces()));
    BOOST_TEST(report.smallest_angle == alone[i].parameterizer.report().smallest_angle);
    for(Mesh::Vertex_index v : meshes[i].vertices())
      BOOST_TEST((at_once[i].uv[v] == alone[i].uv[v]));
    // A copy passes its report to the original. The last run here is the mesh that was flattened alone.
    BOOST_TEST(original.report().triangles == report.triangles);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(copies_flatten_directly_at_once)
{
  check_copies(SMP::ABF_plus_plus_parameterizer_3<Mesh>());
}

BOOST_AUTO_TEST_CASE(copies_flatten_hierarchically_at_once)
{
  check_copies(SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>());
}

BOOST_AUTO_TEST_CASE(copies_flatten_injectively_at_once)
{
  SMP::Hierarchical_options options;
  options.injective = true;
  options.polish = true;
  check_copies(SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>(options));
}

BOOST_AUTO_TEST_SUITE_END()
