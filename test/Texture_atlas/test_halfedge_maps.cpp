// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coordinates of halfedges, as atlases have them: certificates, measures and OBJ files.

#include <boost/test/unit_test.hpp>

#include "atlas_surfaces.h"
#include "seam_surfaces.h"
#include "test_options.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/overlapping_faces.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_halfedge_maps)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<test_charts::Point_3> Mesh;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;
typedef Kernel::Point_2 Point_2;

namespace {

// An atlas of several components
struct Atlas
{
  Mesh mesh;
  Mesh::Property_map<Halfedge, Point_2> uv;
  Mesh::Property_map<Mesh::Edge_index, bool> seams;
  Mesh::Property_map<Face, int> chart;
  TA::Atlas_report report;

  Atlas(const Mesh& surface, const TA::Atlas_options& options = few_charts()) : mesh(surface)
  {
    uv = mesh.add_property_map<Halfedge, Point_2>("h:uv", {0, 0}).first;
    seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    chart = mesh.add_property_map<Face, int>("f:chart", -1).first;
    report = TA::make_atlas(mesh, seams, uv, chart, options);
  }

  explicit Atlas(unsigned seed) : Atlas(atlas_surfaces::random_union(seed, 4).mesh<Mesh>()) {}

  std::vector<Face> overlapping() const
  {
    std::vector<Face> result;
    TA::overlapping_faces(mesh, uv, std::back_inserter(result));
    return result;
  }
};

// The same map with a vertex for each place in the plane, by another way: corners are joined where edges have equal
// coordinates.
struct Opened
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Point_2> uv;

  explicit Opened(const Atlas& atlas)
  {
    uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
    std::map<std::pair<std::size_t, std::pair<double, double>>, Vertex>
        vertices; // of each chart and place: charts are apart
    for(const Face f : atlas.mesh.faces()) {
      std::vector<Vertex> corners;
      for(const Halfedge h : atlas.mesh.halfedges_around_face(atlas.mesh.halfedge(f))) {
        const Point_2& p = atlas.uv[h];
        const auto [found, is_new] =
            vertices.try_emplace({static_cast<std::size_t>(atlas.chart[f]), {p.x(), p.y()}}, Vertex());
        if(is_new) {
          found->second = mesh.add_vertex(atlas.mesh.point(atlas.mesh.target(h)));
          uv[found->second] = p;
        }
        corners.push_back(found->second);
      }
      BOOST_REQUIRE(mesh.add_face(corners) != Mesh::null_face());
    }
  }
};

void check_equal(const SMP::Flattening_measures& measures, const SMP::Flattening_measures& expected)
{
  typedef SMP::Flattening_measures Measures;
  for(double Measures::*measure :
      {&Measures::mean_angle_change, &Measures::rms_corner_angle_change, &Measures::angular_distortion,
       &Measures::l2_stretch, &Measures::linf_stretch, &Measures::mean_quasi_conformal_ratio,
       &Measures::quasi_conformal_ratio_95, &Measures::max_quasi_conformal_ratio, &Measures::min_scale,
       &Measures::max_scale, &Measures::l2_area_distortion, &Measures::symmetric_dirichlet_energy,
       &Measures::smallest_angle, &Measures::l2_principal_shear})
    BOOST_TEST((measures.*measure) == (expected.*measure), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(measures.flipped_triangles == expected.flipped_triangles);
  BOOST_TEST(measures.border_is_simple == expected.border_is_simple);
}

} // namespace

BOOST_AUTO_TEST_CASE(atlases_are_injective)
{
  std::size_t charts = 0;
  for(unsigned seed = 0; seed < 25; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Atlas atlas(seed);
    if(!atlas.report.has_atlas() || !atlas.report.skipped.empty())
      continue;
    charts += atlas.report.charts.size();
    BOOST_TEST(SMP::is_injective(atlas.mesh, atlas.uv));
    BOOST_TEST(SMP::is_locally_injective(atlas.mesh, atlas.uv));
    BOOST_TEST(atlas.overlapping().empty());
    const Opened opened(atlas);
    BOOST_TEST(SMP::is_injective(opened.mesh, opened.uv));
    check_equal(SMP::measure_flattening(atlas.mesh, atlas.uv),
                SMP::measure_flattening(opened.mesh, opened.uv));

    // The first chart is laid over the last one.
    const auto middle_of_face = [&](int chart) {
      for(const Face f : atlas.mesh.faces())
        if(const Halfedge h = atlas.mesh.halfedge(f); atlas.chart[f] == chart)
          return CGAL::centroid(atlas.uv[h], atlas.uv[atlas.mesh.next(h)], atlas.uv[atlas.mesh.prev(h)]);
      throw std::logic_error("there is no such chart");
    };
    const int last = static_cast<int>(atlas.report.charts.size()) - 1;
    if(last == 0)
      continue;
    const Kernel::Vector_2 move = middle_of_face(last) - middle_of_face(0);
    for(const Face f : atlas.mesh.faces())
      if(atlas.chart[f] == 0)
        for(const Halfedge h : atlas.mesh.halfedges_around_face(atlas.mesh.halfedge(f)))
          atlas.uv[h] = atlas.uv[h] + move;
    BOOST_TEST(!SMP::is_injective(atlas.mesh, atlas.uv));
    BOOST_TEST(SMP::is_locally_injective(atlas.mesh, atlas.uv));
    bool has_first = false, has_last = false;
    for(const Face f : atlas.overlapping()) {
      has_first = has_first || atlas.chart[f] == 0;
      has_last = has_last || atlas.chart[f] == last;
    }
    BOOST_TEST(has_first);
    BOOST_TEST(has_last);
    BOOST_TEST(!SMP::measure_flattening(atlas.mesh, atlas.uv).border_is_simple);
  }
  BOOST_TEST(charts > 30u);
}

BOOST_AUTO_TEST_CASE(one_chart_is_measured_as_a_seam_mesh)
{
  TA::Atlas_options options(TA::Atlas_options::FEW_CHARTS);
  options.pack_into_square = false;
  for(const auto& surface : {seam_surfaces::sphere(2), seam_surfaces::torus(12, 8)}) {
    const Atlas atlas(surface.mesh<Mesh>(), options);
    BOOST_TEST_REQUIRE(atlas.report.charts.size() == 1u);
    Mesh copy = atlas.mesh;
    const auto cut = TA::make_seam_mesh(copy, atlas.seams).mesh;
    typedef std::decay_t<decltype(cut)> Cut;
    const auto uv_of_vertex = boost::make_function_property_map<boost::graph_traits<Cut>::vertex_descriptor>(
        [&](const auto& v) { return get(atlas.uv, static_cast<Halfedge>(v)); });
    const SMP::Flattening_measures expected =
        SMP::measure_flattening(cut, TA::border_halfedge(cut), uv_of_vertex);
    check_equal(SMP::measure_flattening(atlas.mesh, atlas.uv), expected);
    check_equal(SMP::measure_flattening(cut, uv_of_vertex), expected);
    int faces = 0;
    Mesh::Property_map<Vertex, Mesh::Point> far = copy.add_property_map<Vertex, Mesh::Point>("v:far").first;
    for(const Vertex v : copy.vertices())
      far[v] = Mesh::Point(3 * copy.point(v).x(), 3 * copy.point(v).y(), 3 * copy.point(v).z());
    const auto count = [&](Face, const SMP::Flattening_face_measures&) { ++faces; };
    check_equal(
        SMP::measure_flattening(atlas.mesh, atlas.uv, CGAL::parameters::vertex_point_map(far).visitor(count)),
        expected);
    BOOST_TEST(faces == static_cast<int>(atlas.mesh.number_of_faces()));
  }
}

BOOST_AUTO_TEST_CASE(wrong_input)
{
  Mesh empty;
  const auto uv = empty.add_property_map<Halfedge, Point_2>("h:uv").first;
  BOOST_TEST(SMP::measure_flattening(empty, uv).status == SMP::Diagnosis::EMPTY_MESH);
  Mesh mesh = seam_surfaces::sphere(1).mesh<Mesh>();
  const auto zero = mesh.add_property_map<Halfedge, Point_2>("h:uv", {0, 0}).first;
  BOOST_TEST(SMP::measure_flattening(mesh, zero).flipped_triangles == mesh.number_of_faces());
  mesh.point(Vertex(3)) = Mesh::Point(0, std::nan(""), 0);
  const auto report = SMP::measure_flattening(mesh, zero);
  BOOST_TEST(report.status == SMP::Diagnosis::NON_FINITE_POINT);
  BOOST_TEST((report.offending_vertices == std::vector<Vertex>{Vertex(3)}));
}

namespace {

// What an OBJ file says of each corner of each face: point and texture coordinates
typedef std::array<double, 5> File_corner;
constexpr double none = -7; // a corner without texture coordinates

std::vector<std::vector<File_corner>> read_obj(std::istream& in, std::size_t& coordinates)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 2>> uv;
  std::vector<std::vector<File_corner>> faces;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind, word;
    words >> kind;
    if(kind == "v") {
      points.emplace_back();
      words >> points.back()[0] >> points.back()[1] >> points.back()[2];
    } else if(kind == "vt") {
      uv.emplace_back();
      words >> uv.back()[0] >> uv.back()[1];
    } else {
      BOOST_REQUIRE(kind == "f");
      faces.emplace_back();
      while(words >> word) {
        const std::size_t slash = word.find('/');
        const auto& p = points.at(std::stoul(word) - 1);
        const std::array<double, 2> q = slash == std::string::npos
                                            ? std::array<double, 2>{none, none}
                                            : uv.at(std::stoul(word.substr(slash + 1)) - 1);
        faces.back().push_back({p[0], p[1], p[2], q[0], q[1]});
      }
    }
  }
  coordinates = uv.size();
  return faces;
}

template <typename UVMap, typename HasChart>
std::vector<std::vector<File_corner>> corners_of(const Mesh& mesh, const UVMap& uv, const HasChart& has_chart)
{
  std::vector<std::vector<File_corner>> faces;
  for(const Face f : mesh.faces()) {
    faces.emplace_back();
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Mesh::Point& p = mesh.point(mesh.target(h));
      const Point_2 q = has_chart(f) ? get(uv, h) : Point_2(none, none);
      faces.back().push_back({p.x(), p.y(), p.z(), q.x(), q.y()});
    }
  }
  return faces;
}

} // namespace

BOOST_AUTO_TEST_CASE(obj_files_are_read_back)
{
  int written = 0;
  for(unsigned seed = 0; seed < 10; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Atlas atlas(seed);
    const bool is_finite =
        std::all_of(atlas.mesh.points().begin(), atlas.mesh.points().end(), [](const Mesh::Point& p) {
          return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
        });
    std::stringstream stream;
    stream.precision(3);
    BOOST_TEST(bool(TA::IO::write_OBJ(stream, atlas.mesh, atlas.uv)) == is_finite);
    if(!is_finite)
      continue;
    ++written;
    BOOST_TEST(stream.precision() == 3);
    std::size_t coordinates = 0;
    BOOST_TEST(
        (read_obj(stream, coordinates) == corners_of(atlas.mesh, atlas.uv, [](Face) { return true; })));
    const std::size_t shared = coordinates;
    if(atlas.report.has_atlas() && atlas.report.skipped.empty())
      BOOST_TEST(shared == Opened(atlas).mesh.number_of_vertices());

    // Charts share nothing, and faces without chart have no coordinates.
    std::stringstream apart;
    for(const Face f : atlas.mesh.faces())
      atlas.chart[f] = static_cast<int>(f.idx() % 3) - 1;
    BOOST_TEST(
        bool(TA::IO::write_OBJ(apart, atlas.mesh, atlas.uv, CGAL::parameters::face_patch_map(atlas.chart))));
    BOOST_TEST((read_obj(apart, coordinates) ==
                corners_of(atlas.mesh, atlas.uv, [&](Face f) { return atlas.chart[f] >= 0; })));
  }
  BOOST_TEST(written >= 8);
}

BOOST_AUTO_TEST_CASE(obj_files_of_vertex_maps)
{
  Mesh mesh = seam_surfaces::slab(3).mesh<Mesh>();
  const auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  for(const Vertex v : mesh.vertices())
    uv[v] = Point_2(v.idx() / 3., -1. * v.idx());
  const std::string file = "test_halfedge_maps.obj";
  BOOST_TEST_REQUIRE(bool(TA::IO::write_OBJ(file, mesh, uv)));
  std::ifstream in(file);
  std::size_t coordinates = 0;
  const auto of_corner =
      boost::make_function_property_map<Halfedge>([&](Halfedge h) { return uv[mesh.target(h)]; });
  BOOST_TEST((read_obj(in, coordinates) == corners_of(mesh, of_corner, [](Face) { return true; })));
  BOOST_TEST(coordinates == mesh.number_of_vertices());
  Mesh again; // CGAL reads it, too
  BOOST_TEST(CGAL::IO::read_OBJ(file, again));
  BOOST_TEST(again.number_of_faces() == mesh.number_of_faces());
}

BOOST_AUTO_TEST_SUITE_END()
