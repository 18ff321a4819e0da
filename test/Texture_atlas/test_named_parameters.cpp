// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Options may be left out before named parameters, and visitors are named parameters: each call compiles, and gives the
// same as with options.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/bake_surface.h>
#include <CGAL/Texture_atlas/flatten_with_cones.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_atlas_of_soup.h>
#include <CGAL/Texture_atlas/pack_charts.h>
#include <CGAL/Texture_atlas/seam_weights.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Texture_atlas/select_crease_seams.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/symmetrize_seams.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_named_parameters)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

namespace {

// A mesh with property maps, and with points that are stretched in the direction of x
struct Mapped_mesh
{
  explicit Mapped_mesh(const Mesh& given)
      : mesh(given), uv(mesh.add_property_map<Mesh::Halfedge_index, Point_2>("uv", Point_2(0, 0)).first),
        vertex_uv(mesh.add_property_map<Mesh::Vertex_index, Point_2>("vertex_uv", Point_2(0, 0)).first),
        seams(mesh.add_property_map<Mesh::Edge_index, bool>("seams", false).first),
        chart(mesh.add_property_map<Mesh::Face_index, int>("chart", -1).first),
        points(mesh.add_property_map<Mesh::Vertex_index, Point_3>("stretched", Point_3(0, 0, 0)).first)
  {
    for(const Mesh::Vertex_index v : mesh.vertices())
      points[v] = Point_3(3 * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  }
  Mapped_mesh(const Mapped_mesh& other) : Mapped_mesh(other.mesh) {}

  auto np() const { return parameters::vertex_point_map(points); }

  std::vector<Point_2> coordinates() const
  {
    std::vector<Point_2> all;
    for(const Mesh::Halfedge_index h : mesh.halfedges())
      all.push_back(uv[h]);
    for(const Mesh::Vertex_index v : mesh.vertices())
      all.push_back(vertex_uv[v]);
    return all;
  }

  std::size_t number_of_seams() const
  {
    return static_cast<std::size_t>(
        std::count_if(mesh.edges().begin(), mesh.edges().end(), [&](const auto e) { return seams[e]; }));
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv;
  Mesh::Property_map<Mesh::Vertex_index, Point_2> vertex_uv;
  Mesh::Property_map<Mesh::Edge_index, bool> seams;
  Mesh::Property_map<Mesh::Face_index, int> chart;
  Mesh::Property_map<Mesh::Vertex_index, Point_3> points;
};

Mapped_mesh closed()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  return Mapped_mesh(mesh);
}

Mapped_mesh open()
{
  return Mapped_mesh(test_meshes::bump<Mesh>(6));
}

// Both calls succeed, and leave the same coordinates and seams.
template <class Call, class Other>
void check_same(Mapped_mesh a, const Call& call, const Other& other)
{
  Mapped_mesh b = a;
  BOOST_TEST(bool(call(a)));
  BOOST_TEST(bool(other(b)));
  BOOST_TEST((a.coordinates() == b.coordinates()));
  BOOST_TEST(a.number_of_seams() == b.number_of_seams());
}

struct Stages : SMP::Flattening_visitor, TA::Atlas_visitor
{
  bool start(SMP::Flattening_visitor::Stage) override { return ++count < end; }
  bool start(TA::Atlas_visitor::Stage) override { return ++count < end; }

  int count = 0, end = 1000;
};

} // namespace

BOOST_AUTO_TEST_CASE(options_may_be_left_out)
{
  check_same(
      closed(), [](auto& m) { return TA::make_atlas(m.mesh, m.uv, m.np()); },
      [](auto& m) { return TA::make_atlas(m.mesh, m.uv, TA::Atlas_options::TEXTURE, m.np()); });
  check_same(
      closed(), [](auto& m) { return TA::make_atlas(m.mesh, m.seams, m.uv, m.chart, m.np()); },
      [](auto& m) { return TA::make_atlas(m.mesh, m.seams, m.uv, m.chart, TA::Atlas_options(), m.np()); });
  check_same(
      closed(), [](auto& m) { return TA::select_seams(m.mesh, m.seams, m.np()); },
      [](auto& m) { return TA::select_seams(m.mesh, m.seams, TA::Seam_options(), m.np()); });
  check_same(
      closed(), [](auto& m) { return TA::select_crease_seams(m.mesh, m.seams, m.np()); },
      [](auto& m) { return TA::select_crease_seams(m.mesh, m.seams, TA::Crease_options(), m.np()); });
  check_same(
      closed(), [](auto& m) { return TA::select_cones(m.mesh, 4, m.np()); },
      [](auto& m) { return TA::select_cones(m.mesh, 4, TA::Cone_options(), m.np()); });
  check_same(
      closed(), [](auto& m) { return TA::flatten_with_cones(m.mesh, 4, m.seams, m.uv, m.np()); },
      [](auto& m) { return TA::flatten_with_cones(m.mesh, 4, m.seams, m.uv, TA::Cone_options(), m.np()); });
  const auto plane = TA::find_mirror_plane(closed().mesh);
  check_same(
      closed(), [&](auto& m) { return TA::symmetrize_seams(m.mesh, m.seams, plane, m.np()); },
      [&](auto& m) { return TA::symmetrize_seams(m.mesh, m.seams, plane, true, m.np()); });
  check_same(
      open(), [](auto& m) { return SMP::flatten_surface(m.mesh, m.vertex_uv, m.np()); },
      [](auto& m) {
        return SMP::flatten_surface(m.mesh, m.vertex_uv, SMP::ABF_plus_plus_options(), m.np());
      });
}

BOOST_AUTO_TEST_CASE(several_meshes_have_a_solver_and_a_visitor)
{
  const std::vector<Mesh> meshes = {closed().mesh, open().mesh};
  std::vector<Mesh::Property_map<Mesh::Halfedge_index, Point_2>> uv;
  for(const Mesh& mesh : meshes)
    uv.push_back(const_cast<Mesh&>(mesh).add_property_map<Mesh::Halfedge_index, Point_2>("uv").first);
  Stages stages;
  BOOST_TEST(bool(TA::make_common_atlas(meshes, uv, parameters::visitor(std::ref(stages)))));
  BOOST_TEST(stages.count == 6);
}

BOOST_AUTO_TEST_CASE(soups_have_named_parameters)
{
  TA::Surface_soup soup;
  for(const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)})
    soup.points.emplace_back(p.x(), p.y(), p.z());
  for(const std::array<TA::Surface_soup::Index, 3>& t :
      {std::array<TA::Surface_soup::Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    soup.add_polygon({t[0], t[1], t[2]});
  TA::Soup_atlas atlas;
  Stages stages;
  BOOST_TEST(bool(TA::make_atlas(soup, atlas, parameters::visitor(std::ref(stages)))));
  BOOST_TEST(stages.count > 0);
  std::vector<TA::Soup_atlas> atlases;
  BOOST_TEST(bool(TA::make_common_atlas({soup, soup}, atlases, parameters::visitor(std::ref(stages)))));
  BOOST_TEST(atlases.size() == 2u);
}

BOOST_AUTO_TEST_CASE(charts_are_packed_and_baked_with_named_parameters)
{
  Mapped_mesh m = closed(), fine = closed();
  BOOST_TEST(bool(TA::make_atlas(m.mesh, m.seams, m.uv, m.chart)));
  check_same(
      m,
      [&](auto& copy) {
        BOOST_TEST(bool(TA::make_atlas(copy.mesh, copy.seams, copy.uv, copy.chart)));
        return TA::pack_charts(copy.mesh, copy.chart, copy.uv, copy.np());
      },
      [&](auto& copy) {
        BOOST_TEST(bool(TA::make_atlas(copy.mesh, copy.seams, copy.uv, copy.chart)));
        return TA::pack_charts(copy.mesh, copy.chart, copy.uv, TA::Packing_options(), copy.np());
      });
  TA::Baking_options options;
  const auto baked = TA::bake_surface(m.mesh, m.uv, fine.mesh, options, m.np(), fine.np());
  BOOST_TEST(bool(baked));
  BOOST_TEST((TA::bake_surface(m.mesh, m.uv, fine.mesh, m.np(), fine.np()).normals == baked.normals));
}

BOOST_AUTO_TEST_CASE(weights_of_creases_have_named_parameters)
{
  Mapped_mesh m = closed();
  auto weights = m.mesh.add_property_map<Mesh::Edge_index, double>("weights").first,
       others = m.mesh.add_property_map<Mesh::Edge_index, double>("others").first;
  BOOST_TEST(bool(TA::compute_crease_weights(m.mesh, weights, m.np())));
  BOOST_TEST(bool(TA::compute_crease_weights(m.mesh, others, 0.3, m.np())));
  for(const Mesh::Edge_index e : m.mesh.edges())
    BOOST_TEST(weights[e] == others[e]);
}

BOOST_AUTO_TEST_CASE(measures_of_a_map_have_named_parameters)
{
  Mapped_mesh m = open();
  const Mesh::Halfedge_index border = test_meshes::border(m.mesh);
  BOOST_TEST(bool(SMP::flatten_surface(m.mesh, m.vertex_uv)));
  const auto measures = SMP::measure_flattening(m.mesh, m.vertex_uv);
  BOOST_TEST(SMP::measure_flattening(m.mesh, m.vertex_uv, m.np()).angular_distortion >
             2 * measures.angular_distortion);
  std::set<Mesh::Face_index> visited;
  const auto visit = [&](const Mesh::Face_index f, const SMP::Flattening_face_measures&) {
    visited.insert(f);
  };
  BOOST_TEST(bool(SMP::measure_flattening(m.mesh, m.vertex_uv, parameters::visitor(visit))));
  BOOST_TEST(visited.size() == m.mesh.number_of_faces());
  visited.clear();
  BOOST_TEST(bool(SMP::measure_flattening(m.mesh, border, m.vertex_uv, m.np().visitor(visit))));
  BOOST_TEST(visited.size() == m.mesh.number_of_faces());
}

BOOST_AUTO_TEST_CASE(options_of_either_method_choose_the_parameterizer)
{
  check_same(
      open(), [](auto& m) { return SMP::flatten_surface(m.mesh, m.vertex_uv, SMP::Hierarchical_options()); },
      [](auto& m) {
        return SMP::flatten_surface(m.mesh, m.vertex_uv, SMP::Hierarchical_parameterizer_3<Mesh>());
      });
}

BOOST_AUTO_TEST_CASE(importance_of_faces_is_a_named_parameter)
{
  const auto importance = [](auto& m) {
    auto map = m.mesh.template add_property_map<Mesh::Face_index, double>("importance", 1.).first;
    for(const Mesh::Face_index f : m.mesh.faces())
      map[f] = f.idx() % 3 == 0 ? 10. : 1.;
    return map;
  };
  check_same(
      open(),
      [&](auto& m) {
        return SMP::flatten_surface(
            m.mesh, m.vertex_uv, parameters::face_importance_map(importance(m)).vertex_point_map(m.points));
      },
      [&](auto& m) {
        SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
        parameterizer.set_importance(importance(m));
        return SMP::flatten_surface(m.mesh, m.vertex_uv, parameterizer, m.np());
      });
  Mapped_mesh a = open(), b = open();
  BOOST_TEST(bool(SMP::flatten_surface(a.mesh, a.vertex_uv)));
  BOOST_TEST(bool(SMP::flatten_surface(b.mesh, b.vertex_uv, parameters::face_importance_map(importance(b)))));
  BOOST_TEST((a.coordinates() != b.coordinates()));
}

BOOST_AUTO_TEST_CASE(a_visitor_follows_and_cancels)
{
  Mapped_mesh m = open();
  Stages stages;
  BOOST_TEST(bool(SMP::flatten_surface(m.mesh, m.vertex_uv, parameters::visitor(std::ref(stages)))));
  const int count = stages.count;
  BOOST_TEST(count >= 5);
  stages.count = 0;
  stages.end = 2;
  BOOST_TEST((SMP::flatten_surface(m.mesh, m.vertex_uv, SMP::Hierarchical_options(),
                                   parameters::visitor(std::ref(stages)))
                  .status == SMP::Diagnosis::CANCELLED));
  BOOST_TEST(stages.count == 2);
  stages.count = 0;
  BOOST_TEST((TA::make_atlas(m.mesh, m.uv, m.np().visitor(stages)).status == SMP::Diagnosis::CANCELLED));
  BOOST_TEST(stages.count == 0, "the named parameter is a copy without std::ref");
}

// Each enumerator has a name of its own, and `<<` writes it.
BOOST_AUTO_TEST_CASE(enumerators_and_reports_are_written)
{
  const auto check = [](const auto last) {
    std::set<std::string> names;
    for(int i = 0; i <= static_cast<int>(last); ++i) {
      std::ostringstream text;
      text << static_cast<std::decay_t<decltype(last)>>(i);
      names.insert(text.str());
      BOOST_TEST(text.str().find_first_of("0123456789") == std::string::npos);
    }
    BOOST_TEST(names.size() == static_cast<std::size_t>(last) + 1);
  };
  check(SMP::Diagnosis::NO_SUCH_EDGE);
  check(SMP::ABF_plus_plus_report::INJECTIVE_DESCENT);
  check(SMP::ABF_plus_plus_report::LEAST_SQUARES);
  check(SMP::Hierarchical_report::TUTTE_MAP);
  check(SMP::Flattening_visitor::WRITE);
  check(TA::Atlas_report::GIVEN);
  check(TA::Atlas_report::MORE_CHARTS);
  check(TA::Atlas_report::TOO_MUCH_DISTORTION);
  check(TA::Atlas_visitor::WRITE);
  Mapped_mesh m = closed();
  std::ostringstream text;
  text << SMP::flatten_surface(m.mesh, m.vertex_uv);
  BOOST_TEST(text.str().find("NO_BORDER: the surface is closed") == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
