// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The parameterizer as CGAL programmers use it, on every kind of mesh.

#include <boost/test/unit_test.hpp>

// Included first, to show that they are self-contained.
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_parameterizer)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel> Polyhedron;
typedef SMP::ABF_plus_plus_report Report;
typedef SMP::ABF_plus_plus_options Options;

namespace {

template <typename Mesh, typename SolverTraits = CGAL::Default>
struct Flattening
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef SMP::ABF_plus_plus_parameterizer_3<Mesh, SolverTraits> Parameterizer;

  explicit Flattening(const Options& options = Options()) : parameterizer(options) {}

  SMP::Error_code run(Mesh& mesh, halfedge_descriptor bhd)
  {
    return SMP::parameterize(mesh, parameterizer, bhd, uvmap());
  }

  SMP::Error_code run(Mesh& mesh) { return run(mesh, PMP::longest_border(mesh).first); }

  boost::associative_property_map<std::map<vertex_descriptor, Point_2>> uvmap() { return {uv}; }

  Parameterizer parameterizer;
  std::map<vertex_descriptor, Point_2> uv;
};

void check_peak_memory(const Report& report)
{
#ifdef __linux__
  BOOST_TEST(report.peak_memory > (report.vertices + 1) * sizeof(Point_2));
#else
  (void)report;
#endif
}

template <typename Mesh>
void check_valid(Mesh& mesh)
{
  const auto bhd = PMP::longest_border(mesh).first;
  Flattening<Mesh> flattening;
  BOOST_TEST(flattening.run(mesh, bhd) == SMP::OK);
  BOOST_TEST(flattening.uv.size() == num_vertices(mesh));

  const Report& report = flattening.parameterizer.report(); // survives the call by value
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(report.converged);
  BOOST_TEST(report.message.empty());
  BOOST_TEST(report.vertices == static_cast<int>(num_vertices(mesh)));
  BOOST_TEST(report.triangles == static_cast<int>(num_faces(mesh)));
  BOOST_TEST(report.flipped_triangles == 0);
  BOOST_TEST(report.layout == Report::EXACT);
  BOOST_TEST(report.seconds.total() > 0);
  check_peak_memory(report);

  const auto measures = SMP::measure_flattening(mesh, bhd, flattening.uvmap());
  BOOST_TEST(measures.flipped_triangles == 0);
  BOOST_TEST(measures.smallest_angle == report.smallest_angle);
  BOOST_TEST(measures.angular_distortion < 0.1);
  BOOST_TEST(measures.l2_stretch >= 1);
}

// An error leaves the map unchanged, and says what is wrong and where.
void check_error(Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd, SMP::Error_code code,
                 SMP::Diagnosis diagnosis, const Options& options = Options())
{
  Flattening<Surface_mesh> flattening(options);
  const auto vimap = get(boost::vertex_index, mesh);
  auto parameterized = mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:done", false).first;
  BOOST_TEST(flattening.parameterizer.parameterize(mesh, bhd, flattening.uvmap(), vimap, parameterized) ==
             code);
  BOOST_TEST(flattening.uv.empty());
  const Report& report = flattening.parameterizer.report();
  BOOST_TEST(error_code(report.status) == code);
  BOOST_TEST(report.status == diagnosis);
  BOOST_TEST(!report.message.empty());
  check_peak_memory(report);
}

} // namespace

#ifdef __linux__
// Memory that was returned counts, in bytes.
BOOST_AUTO_TEST_CASE(peak_memory_is_that_of_the_process)
{
  const std::size_t before = SMP::internal::ABF::peak_resident_size(),
                    size = before + (std::size_t(64) << 20);
  BOOST_TEST(std::vector<char>(size, 'x').back() == 'x');
  const std::size_t after = SMP::internal::ABF::peak_resident_size();
  BOOST_TEST(after > size);
  BOOST_TEST(after < before + 2 * size);
}
#endif

BOOST_AUTO_TEST_CASE(surface_mesh)
{
  Surface_mesh mesh;
  test_meshes::make_bump(20, mesh);
  check_valid(mesh);
}

BOOST_AUTO_TEST_CASE(same_result_on_every_mesh_type)
{
  Surface_mesh mesh;
  Polyhedron polyhedron;
  test_meshes::make_bump(9, mesh);
  test_meshes::make_bump(9, polyhedron);
  Flattening<Surface_mesh> a;
  Flattening<Polyhedron> b;
  BOOST_TEST(a.run(mesh) == SMP::OK);
  BOOST_TEST(b.run(polyhedron) == SMP::OK);
  BOOST_TEST(a.parameterizer.report().energy == b.parameterizer.report().energy,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(one_of_several_components)
{
  Surface_mesh mesh;
  test_meshes::make_bump(5, mesh);
  const auto v = mesh.add_vertex(Point_3(5, 0, 0)), w = mesh.add_vertex(Point_3(6, 0, 0)),
             x = mesh.add_vertex(Point_3(5, 1, 0));
  const auto f = mesh.add_face(v, w, x);
  Flattening<Surface_mesh> flattening;
  BOOST_TEST(flattening.run(mesh, opposite(halfedge(f, mesh), mesh)) == SMP::OK);
  BOOST_TEST(flattening.uv.size() == 3u);
  BOOST_TEST(flattening.run(mesh) == SMP::OK);
  BOOST_TEST(flattening.uv.size() == 3u + 36u);
}

// The indices only have to be different. `SMP::parameterize()` would refuse the isolated vertex.
BOOST_AUTO_TEST_CASE(any_vertex_indices)
{
  Surface_mesh mesh;
  const Surface_mesh::Vertex_index isolated = mesh.add_vertex(Point_3(0, 0, 0));
  test_meshes::make_bump(6, mesh);
  std::map<Surface_mesh::Vertex_index, int> indices;
  int next = 1000000;
  for(Surface_mesh::Vertex_index v : vertices(mesh))
    indices[v] = next -= 7;
  Flattening<Surface_mesh> a, b;
  const auto bhd = PMP::longest_border(mesh).first;
  std::map<Surface_mesh::Vertex_index, bool> parameterized_map;
  const auto parameterized = boost::make_assoc_property_map(parameterized_map);
  BOOST_TEST(a.parameterizer.parameterize(mesh, bhd, a.uvmap(), boost::make_assoc_property_map(indices),
                                          parameterized) == SMP::OK);
  BOOST_TEST(b.parameterizer.parameterize(mesh, bhd, b.uvmap(), get(boost::vertex_index, mesh),
                                          parameterized) == SMP::OK);
  BOOST_TEST(a.uv.size() == 49u);
  BOOST_TEST(a.uv.count(isolated) == 0u);
  for(const auto& [v, uv] : a.uv)
    BOOST_TEST(std::sqrt(CGAL::squared_distance(uv, b.uv[v])) < 1e-9);
}

// The certified coordinates are those that a map of floats stores.
BOOST_AUTO_TEST_CASE(float_kernel)
{
  typedef CGAL::Simple_cartesian<float> Float_kernel;
  typedef CGAL::Surface_mesh<Float_kernel::Point_3> Mesh;
  Mesh mesh;
  test_meshes::make_bump(10, mesh);
  auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Float_kernel::Point_2>("v:uv").first;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  const auto bhd = PMP::longest_border(mesh).first;
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, bhd, uvmap) == SMP::OK);
  BOOST_TEST(SMP::measure_flattening(mesh, bhd, uvmap).smallest_angle ==
             parameterizer.report().smallest_angle);
}

BOOST_AUTO_TEST_CASE(wrong_input)
{
  Surface_mesh mesh;
  test_meshes::make_bump(4, mesh);
  const auto bhd = PMP::longest_border(mesh).first;
  check_error(mesh, Surface_mesh::null_halfedge(), SMP::ERROR_WRONG_PARAMETER, SMP::Diagnosis::NOT_ON_BORDER);
  check_error(mesh, opposite(bhd, mesh), SMP::ERROR_WRONG_PARAMETER, SMP::Diagnosis::NOT_ON_BORDER);
  for(const auto wrong : {Surface_mesh::null_halfedge(), opposite(bhd, mesh)}) { // as users call it
    const auto uv = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("v:uv", {7, 7}).first;
    SMP::ABF_plus_plus_parameterizer_3<Surface_mesh> direct;
    SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Surface_mesh> hierarchical;
    BOOST_TEST(SMP::parameterize(mesh, direct, wrong, uv) == SMP::ERROR_WRONG_PARAMETER);
    BOOST_TEST(SMP::parameterize(mesh, hierarchical, wrong, uv) == SMP::ERROR_WRONG_PARAMETER);
    BOOST_TEST(direct.report().status == SMP::Diagnosis::NOT_ON_BORDER);
    BOOST_TEST(hierarchical.report().status == SMP::Diagnosis::NOT_ON_BORDER);
    BOOST_TEST(uv[Surface_mesh::Vertex_index(0)] == Kernel::Point_2(7, 7));
  }

  Surface_mesh nan = mesh;
  const Surface_mesh::Vertex_index v(7);
  nan.point(v) = Point_3(0, 0, std::numeric_limits<double>::quiet_NaN());
  check_error(nan, bhd, SMP::ERROR_WRONG_PARAMETER, SMP::Diagnosis::NON_FINITE_POINT);
  Flattening<Surface_mesh> flattening;
  flattening.run(nan);
  BOOST_REQUIRE_EQUAL(flattening.parameterizer.report().offending_vertices.size(), 1u);
  BOOST_TEST(flattening.parameterizer.report().offending_vertices.front() == v);

  Surface_mesh quads;
  CGAL::make_grid(
      3, 3, quads, [](std::size_t i, std::size_t j) { return Point_3(i, j, 0); }, false);
  check_error(quads, PMP::longest_border(quads).first, SMP::ERROR_NON_TRIANGULAR_MESH,
              SMP::Diagnosis::NOT_TRIANGULATED);
}

BOOST_AUTO_TEST_CASE(surface_without_a_border_given)
{
  typedef boost::associative_property_map<std::map<Surface_mesh::Vertex_index, Point_2>> Map;
  std::map<Surface_mesh::Vertex_index, Point_2> uv;
  Surface_mesh mesh;
  const auto empty = SMP::flatten_surface(mesh, Map(uv));
  BOOST_TEST(empty.status == SMP::Diagnosis::EMPTY_MESH);
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), mesh);
  const auto closed = SMP::flatten_surface(mesh, Map(uv));
  BOOST_TEST(closed.status == SMP::Diagnosis::NO_BORDER);
  BOOST_TEST(closed.message.find("closed") != std::string::npos);
  BOOST_TEST(SMP::error_code(closed.status) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  BOOST_TEST(uv.empty());

  Surface_mesh bump;
  test_meshes::make_bump(4, bump);
  Flattening<Surface_mesh> flattening;
  flattening.run(bump);
  BOOST_TEST(SMP::flatten_surface(bump, Map(uv)).status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST((uv == flattening.uv));
  for(const Surface_mesh::Vertex_index v : bump.vertices())
    bump.point(v) = Point_3(0, 0, std::numeric_limits<double>::quiet_NaN());
  BOOST_TEST(SMP::flatten_surface(bump, Map(uv)).status == SMP::Diagnosis::NON_FINITE_POINT);
}

BOOST_AUTO_TEST_CASE(report_after_an_exception)
{
  struct Thrower : SMP::Flattening_visitor
  {
    bool start(Stage stage) override
    {
      if(stage == LAYOUT)
        throw std::runtime_error("enough");
      return true;
    }
  } thrower;
  Surface_mesh mesh;
  test_meshes::make_bump(4, mesh);
  Options options;
  options.visitor = &thrower;
  Flattening<Surface_mesh> flattening(options);
  BOOST_CHECK_THROW(flattening.run(mesh), std::runtime_error);
  BOOST_TEST(flattening.uv.empty());
  BOOST_TEST(flattening.parameterizer.report().status == SMP::Diagnosis::CANCELLED);
  BOOST_TEST(flattening.parameterizer.report().message == "an exception ended the computation");
}

BOOST_AUTO_TEST_CASE(wrong_options)
{
  Surface_mesh mesh;
  test_meshes::make_bump(4, mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  std::vector<Options> wrong;
  const auto set = [&](auto member, auto value) { wrong.emplace_back().*member = value; };
  for(double value : {-0.1, nan, infinity})
    set(&Options::barrier, value);
  for(double value : {0., -1e-5, nan}) {
    set(&Options::tolerance, value);
    set(&Options::energy_tolerance, value);
  }
  set(&Options::tolerance, 1e-300);
  set(&Options::layout, static_cast<Options::Layout_type>(3));
  set(&Options::max_iterations, -1);
  set(&Options::threads, -1);
  for(const Options& options : wrong) {
    Flattening<Surface_mesh> flattening(options);
    BOOST_TEST(flattening.run(mesh) == SMP::ERROR_WRONG_PARAMETER);
    BOOST_TEST(flattening.parameterizer.report().status == SMP::Diagnosis::WRONG_OPTION);
    BOOST_TEST(!flattening.parameterizer.report().message.empty());
  }
}

BOOST_AUTO_TEST_CASE(diagnoses_have_names)
{
  std::set<std::string> names;
  const int last = static_cast<int>(SMP::Diagnosis::NO_SUCH_EDGE);
  for(int i = 0; i <= last; ++i)
    names.insert(to_string(static_cast<SMP::Diagnosis>(i)));
  BOOST_TEST(names.size() == last + 1u);
  for(const auto& [diagnosis, name] : std::map<SMP::Diagnosis, std::string>{
          {SMP::Diagnosis::NOTHING_WRONG, "NOTHING_WRONG"},
          {SMP::Diagnosis::NON_MANIFOLD_VERTEX, "NON_MANIFOLD_VERTEX"},
          {SMP::Diagnosis::WRONG_OPTION, "WRONG_OPTION"},
          {SMP::Diagnosis::LINEAR_SYSTEM_FAILED, "LINEAR_SYSTEM_FAILED"},
          {SMP::Diagnosis::STRETCH_BOUND_MISSED, "STRETCH_BOUND_MISSED"},
          {SMP::Diagnosis::NO_TEXTURE_COORDINATES, "NO_TEXTURE_COORDINATES"},
          {SMP::Diagnosis::CANNOT_OPEN, "CANNOT_OPEN"},
          {SMP::Diagnosis::NO_SUCH_EDGE, "NO_SUCH_EDGE"}})
    BOOST_TEST(to_string(diagnosis) == name);
}

BOOST_AUTO_TEST_CASE(wrong_topology)
{
  Surface_mesh punctured;
  test_meshes::make_bump(6, punctured);
  const auto bhd = PMP::longest_border(punctured).first;
  const Surface_mesh::Face_index inner(30);
  for(Surface_mesh::Vertex_index v : vertices_around_face(halfedge(inner, punctured), punctured))
    BOOST_REQUIRE(!punctured.is_border(v));
  CGAL::Euler::remove_face(halfedge(inner, punctured), punctured);
  Options options;
  options.holes = Options::REFUSE;
  check_error(punctured, bhd, SMP::ERROR_NO_TOPOLOGICAL_DISC, SMP::Diagnosis::SEVERAL_BORDERS, options);

  Flattening<Surface_mesh> flattening;
  BOOST_TEST(flattening.run(punctured, bhd) == SMP::OK);
  BOOST_TEST(flattening.parameterizer.report().layout == Report::EXACT);
  BOOST_TEST(flattening.parameterizer.report().converged);

  Surface_mesh slit;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), slit);
  const auto first = halfedge(*faces(slit).begin(), slit);
  CGAL::Euler::remove_face(first, slit);
  Flattening<Surface_mesh> open_tetrahedron;
  BOOST_TEST(open_tetrahedron.run(slit, first) == SMP::OK);
}

BOOST_AUTO_TEST_SUITE_END()
