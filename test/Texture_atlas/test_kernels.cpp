// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Both parameterizers, measures, certificates and atlases with every kernel that the manual names, and with points that
// belong to no kernel.

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>

BOOST_AUTO_TEST_SUITE(test_kernels)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
typedef CGAL::Simple_cartesian<double> Kernel;

namespace {

template <typename TriangleMesh>
using Direct = SMP::ABF_plus_plus_parameterizer_3<TriangleMesh>;

template <typename TriangleMesh>
using Hierarchical = SMP::Hierarchical_parameterizer_3<TriangleMesh>;

typedef boost::mpl::list<CGAL::Simple_cartesian<double>, CGAL::Simple_cartesian<float>,
                         CGAL::Exact_predicates_inexact_constructions_kernel,
                         CGAL::Exact_predicates_exact_constructions_kernel>
    Kernels;

// A point that belongs to no kernel.
struct Scanned_point
{
  Scanned_point(double x = 0, double y = 0, double z = 0) : xyz{x, y, z} {}
  double x() const { return xyz[0]; }
  double y() const { return xyz[1]; }
  double z() const { return xyz[2]; }

  double xyz[3];
};

template <typename Parameterizer, typename UV_kernel>
void check_mesh_type()
{
  typedef typename Parameterizer::Triangle_mesh Some_mesh;
  typedef typename boost::graph_traits<Some_mesh>::vertex_descriptor Some_vertex;
  Some_mesh mesh;
  test_meshes::make_bump(14, mesh);
  const auto border = test_meshes::border(mesh);
  const auto uv = mesh.template add_property_map<Some_vertex, typename UV_kernel::Point_2>("v:uv").first;
  Parameterizer parameterizer;
  const auto parameterized = boost::make_constant_property<Some_vertex>(false);
  BOOST_TEST(parameterizer.parameterize(mesh, border, uv, get(boost::vertex_index, mesh), parameterized) ==
             SMP::OK);
  BOOST_TEST(parameterizer.report().message == "");

  const Some_mesh& unchanged = mesh;
  BOOST_TEST(SMP::is_injective(unchanged, uv));
  BOOST_TEST(SMP::is_injective(mesh, border, uv));
  const SMP::Flattening_measures measures = SMP::measure_flattening(unchanged, border, uv);
  BOOST_TEST(measures.flipped_triangles == 0);
  BOOST_TEST(measures.smallest_angle == parameterizer.report().smallest_angle);
  BOOST_TEST(SMP::measure_flattening(mesh, border, uv).l2_stretch == measures.l2_stretch);
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(kernels, Some_kernel, Kernels)
{
  typedef CGAL::Surface_mesh<typename Some_kernel::Point_3> Some_mesh;
  check_mesh_type<Direct<Some_mesh>, Some_kernel>();
  check_mesh_type<Hierarchical<Some_mesh>, Some_kernel>();
}

// Seams, map and packing of a closed surface
BOOST_AUTO_TEST_CASE_TEMPLATE(atlases, Some_kernel, Kernels)
{
  typedef typename Some_kernel::Point_3 Point;
  typedef CGAL::Surface_mesh<Point> Some_mesh;
  Some_mesh mesh;
  CGAL::make_tetrahedron(Point(1, 1, 1), Point(-1, 1, -1), Point(-1, -1, 1), Point(1, -1, -1), mesh);
  const auto uv =
      mesh.template add_property_map<typename Some_mesh::Halfedge_index, typename Some_kernel::Point_2>(
              "h:uv")
          .first;
  const auto report = TA::make_atlas(mesh, uv, TA::Atlas_options::FEW_CHARTS);
  BOOST_TEST(bool(report), report.message);
  BOOST_TEST(report.charts.size() == 1u);
  for(const auto h : mesh.halfedges()) {
    BOOST_TEST((uv[h].x() >= 0 && uv[h].x() <= 1 && uv[h].y() >= 0 && uv[h].y() <= 1));
    BOOST_TEST((CGAL::orientation(uv[h], uv[mesh.next(h)], uv[mesh.prev(h)]) == CGAL::LEFT_TURN));
  }
}

// The map's kernel need not be that of the mesh, and the mesh need not have one.
BOOST_AUTO_TEST_CASE(other_points)
{
  check_mesh_type<Direct<CGAL::Surface_mesh<Kernel::Point_3>>, CGAL::Simple_cartesian<float>>();
  check_mesh_type<Hierarchical<CGAL::Surface_mesh<Scanned_point>>, Kernel>();
}

BOOST_AUTO_TEST_SUITE_END()
