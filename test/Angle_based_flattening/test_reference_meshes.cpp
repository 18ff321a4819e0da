// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Real meshes, compared with the values of an independent prototype. They are not part of the repository.

#include <boost/test/unit_test.hpp>
#include <boost/test/data/test_case.hpp>

#include "test_data.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <cstdlib>
#include <iterator>
#include <ostream>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_reference_meshes)

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> UV_map;
typedef SMP::ABF_plus_plus_options Options;

namespace {

// Angular distortion and stretch; 0 where the energy does not determine the stretch.
struct Expected
{
  double barrier, angular_distortion, l2_stretch;
};

struct Reference
{
  const char* file;
  int triangles;
  Expected expected[2];
};

std::ostream& operator<<(std::ostream& out, const Reference& reference)
{
  return out << reference.file;
}

const std::vector<Reference> disks = {
    {"cow_disk.ply", 5804, {{0, 1.3023e-2, 108.01}, {0.1, 1.3030e-2, 95.53}}},
    {"dino_disk.ply", 7828, {{0, 1.4370e-2, 281.62}, {0.1, 1.4375e-2, 246.24}}},
    {"lionhead_disk.ply", 16674, {{0, 1.4823e-3, 1.1680}, {0.1, 1.4825e-3, 1.1672}}},
    {"camel_disk.ply", 19536, {{0, 3.8661e-3, 2.4888}, {0.1, 3.8664e-3, 2.4746}}},
    {"armadillo_disk.ply", 52000, {{0, 2.1907e-3, 7.4768}, {0.1, 2.1909e-3, 7.3048}}},
    {"bunny_disk.ply", 75408, {{0, 1.4634e-4, 1.1178}, {0.1, 1.4634e-4, 1.1178}}},
    {"horse_disk.ply", 96966, {{0, 3.5586e-4, 0}, {0.1, 3.5611e-4, 1.1867}}},
};
const std::vector<Reference> CGAL_meshes = {
    {"nefertiti.off", 562, {{0, 1.0172e-3, 1.0221}, {0.1, 1.0172e-3, 1.0221}}},
    {"three_peaks.off", 3671, {{0, 7.5754e-3, 9.879}, {0.1, 7.5788e-3, 9.450}}},
    {"lion-head.off", 16674, {{0, 2.2778e-3, 5.606}, {0.1, 2.2779e-3, 5.601}}},
    {"mannequin-devil.off", 25888, {{0, 5.4465e-3, 12.47}, {0.1, 5.4483e-3, 12.32}}},
};

std::vector<Reference> chosen(const std::vector<Reference>& all)
{
  const int most = std::getenv("ABF_TEST_QUICK") ? 10000 : 1000000;
  std::vector<Reference> result;
  std::copy_if(all.begin(), all.end(), std::back_inserter(result),
               [=](const Reference& reference) { return reference.triangles <= most; });
  return result;
}

// Largest distance between two layouts after the best similarity, relative to the first one's size.
double distance_up_to_similarity(const Mesh& mesh, UV_map a, UV_map b)
{
  typedef std::complex<double> Complex;
  Eigen::VectorXcd p(num_vertices(mesh)), q(num_vertices(mesh));
  for(Mesh::Vertex_index v : vertices(mesh)) {
    p[v.idx()] = Complex(a[v].x(), a[v].y());
    q[v.idx()] = Complex(b[v].x(), b[v].y());
  }
  p.array() -= p.mean();
  q.array() -= q.mean();
  return (p - q.dot(p) / q.squaredNorm() * q).cwiseAbs().maxCoeff() / p.cwiseAbs().maxCoeff();
}

void check(const SMP::Flattening_measures& measures, const Expected& expected)
{
  BOOST_TEST(measures.flipped_triangles == 0);
  BOOST_TEST(measures.angular_distortion == expected.angular_distortion, boost::test_tools::tolerance(5e-3));
  if(expected.l2_stretch > 0)
    BOOST_TEST(measures.l2_stretch == expected.l2_stretch, boost::test_tools::tolerance(5e-3));
}

void check(const test_data::Folder& folder, const Reference& reference)
{
  Mesh mesh;
  BOOST_TEST_REQUIRE(CGAL::IO::read_polygon_mesh(folder / reference.file, mesh));
  BOOST_TEST_REQUIRE(static_cast<int>(num_faces(mesh)) == reference.triangles);
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  for(const Expected& expected : reference.expected) {
    UV_map uv[2] = {mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:exact").first,
                    mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:least_squares").first};
    Options options;
    options.barrier = expected.barrier;
    for(int i : {0, 1}) {
      options.layout = i == 0 ? Options::EXACT_LAYOUT : Options::LEAST_SQUARES_LAYOUT;
      SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
      BOOST_TEST(SMP::parameterize(mesh, parameterizer, bhd, uv[i]) == SMP::OK);
      BOOST_TEST(parameterizer.report().converged);
      check(SMP::measure_flattening(mesh, bhd, uv[i]), expected);
    }
    BOOST_TEST(distance_up_to_similarity(mesh, uv[0], uv[1]) < 1e-6);
  }
}

} // namespace

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes, *test_data::needs(test_data::CGAL_meshes))

BOOST_DATA_TEST_CASE(values, boost::unit_test::data::make(chosen(CGAL_meshes)), reference)
{
  check(test_data::CGAL_meshes, reference);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(of_reference_disks, *test_data::needs(test_data::reference_disks))

BOOST_DATA_TEST_CASE(values, boost::unit_test::data::make(chosen(disks)), reference)
{
  check(test_data::reference_disks, reference);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
