// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Baking: what a viewer shows against what is known of the surfaces, gutters, rays that fail, errors.

#include "baked_surfaces.h"
#include "test_options.h"

#include <CGAL/Texture_atlas/bake_surface.h>
#include <CGAL/Texture_atlas/make_atlas.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <limits>
#include <string>

BOOST_AUTO_TEST_SUITE(test_baking)

using namespace baked_surfaces;
namespace np = CGAL::parameters;
using TA::Baking_options;
using SMP::Diagnosis;

namespace {

const auto flat = [](double, double) { return 0.; };
const auto as_it_is = [](double x, double y) { return Plane_point(x, y); };

// Moves all points of a surface.
void transform(Surface& surface, const Eigen::Matrix3d& matrix, const Vector& shift)
{
  for(const Vertex v : surface.vertices()) {
    const Vector p = matrix * vector_of(surface.point(v)) + shift;
    surface.point(v) = Kernel::Point_3(p.x(), p.y(), p.z());
  }
}

Eigen::Matrix3d random_rotation(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

Surface::Property_map<Surface::Edge_index, bool> no_seams(Surface& surface)
{
  return surface.add_property_map<Surface::Edge_index, bool>("e:seam", false).first;
}

// A coarse sphere with an atlas, and what is baked into it
struct Baked_sphere
{
  Surface simple = sphere(1), fine = sphere(5);
  Uv_map uv = uv_map(simple);
  Frame_map frames = frame_map(simple);
  Surface::Property_map<Face, int> chart = simple.add_property_map<Face, int>("f:chart", -1).first;
  TA::Baked_textures textures;

  // The simple surface is bumpy, so that its own normals are wrong.
  void bake(int resolution)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(0.9, 1.05);
    for(const Vertex v : simple.vertices()) {
      const Vector p = radius(random) * vector_of(simple.point(v));
      simple.point(v) = Kernel::Point_3(p.x(), p.y(), p.z());
    }
    BOOST_REQUIRE(TA::make_atlas(
        simple, no_seams(simple), uv, chart,
        few_charts(&TA::Atlas_options::resolution, resolution, &TA::Atlas_options::stretch_bound, 1.05)));
    textures = TA::bake_surface(simple, uv, fine, frames,
                                with<Baking_options>(&Baking_options::resolution, resolution),
                                np::face_patch_map(chart));
    BOOST_REQUIRE(textures);
  }

  // The distance from a point of the simple surface along its interpolated normal to the unit sphere
  double exact_displacement(const Place& place) const
  {
    const Vector p = point_at(simple, place), d = normal_at(simple, frames, place);
    const double along = p.dot(d);
    return -along + std::sqrt(along * along - p.squaredNorm() + 1);
  }

  Vector exact_normal(const Place& place) const
  {
    return point_at(simple, place) + exact_displacement(place) * normal_at(simple, frames, place);
  }

  template <typename Channel>
  double mean_error(bool interpolates) const
  {
    const std::vector<Channel> pixels = textures.normal_pixels<Channel>();
    std::mt19937 random(1);
    const int samples = 20000;
    double sum = 0;
    for(int i = 0; i < samples; ++i) {
      const Place place = random_place(simple, random);
      const Vector pixel = read_texture(pixels, textures.resolution, uv_at(simple, uv, place), interpolates);
      sum +=
          degrees_between(shown_normal(simple, frames, place, pixel, (std::numeric_limits<Channel>::max)()),
                          exact_normal(place));
    }
    return sum / samples;
  }
};

} // namespace

// As a viewer shows it. Texels of 8 bits alone make errors of 0.3 degrees: they have no number for 0.
BOOST_AUTO_TEST_CASE(shows_a_sphere)
{
  Baked_sphere sphere;
  sphere.bake(512);
  BOOST_TEST(sphere.mean_error<std::uint8_t>(true) < 0.5);
  BOOST_TEST(sphere.mean_error<std::uint8_t>(false) < 0.5);
  BOOST_TEST(sphere.mean_error<std::uint16_t>(true) < 0.1);

  std::mt19937 random(2);
  double without = 0, largest = 0;
  const std::vector<std::uint16_t> heights = sphere.textures.displacement_pixels<std::uint16_t>();
  const int n = sphere.textures.resolution;
  for(int i = 0; i < 5000; ++i) {
    const Place place = random_place(sphere.simple, random);
    without += degrees_between(normal_at(sphere.simple, sphere.frames, place), sphere.exact_normal(place));
    const Plane_point uv = uv_at(sphere.simple, sphere.uv, place) * n;
    const std::size_t texel =
        static_cast<std::size_t>(n - 1 - static_cast<int>(uv.y())) * n + static_cast<std::size_t>(uv.x());
    const double height = sphere.textures.least_displacement +
                          (sphere.textures.greatest_displacement - sphere.textures.least_displacement) *
                              heights[texel] / 65535.;
    largest = (std::max)(largest, std::abs(height - sphere.exact_displacement(place)));
  }
  BOOST_TEST(without / 5000 > 2); // an empty texture would be seen
  // The slope of the displacement is at most about 0.4, and a texel about 1/200 long.
  BOOST_TEST(largest < 0.003);
  BOOST_TEST(sphere.textures.number_of_missed_rays == 0u);
  BOOST_TEST(sphere.textures.number_of_back_faces == 0u);
}

// Both surfaces together may be anywhere, of any size.
BOOST_AUTO_TEST_CASE(does_not_depend_on_the_position)
{
  Baked_sphere sphere;
  sphere.bake(128);
  std::mt19937 random(3);
  for(const double scale : {1e-12, 1., 1e9}) {
    Surface simple = sphere.simple, fine = sphere.fine;
    const Vector shift = Vector(3, -2, 5) * scale;
    const Eigen::Matrix3d matrix = scale * random_rotation(random);
    transform(simple, matrix, shift);
    transform(fine, matrix, shift);
    const Uv_map uv = uv_map(simple);
    const auto moved =
        TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, 128));
    BOOST_REQUIRE(moved);
    BOOST_TEST((moved.texels == sphere.textures.texels));
    double normals = 0, displacements = 0;
    for(std::size_t i = 0; i < moved.normals.size(); ++i)
      normals = (std::max)(normals, std::abs(double(moved.normals[i]) - sphere.textures.normals[i]));
    for(std::size_t i = 0; i < moved.displacements.size(); ++i)
      displacements = (std::max)(displacements,
                                 std::abs(moved.displacements[i] / scale - sphere.textures.displacements[i]));
    BOOST_TEST(normals < 1e-5);
    BOOST_TEST(displacements < 1e-6);
    BOOST_TEST(std::abs(moved.mean_distance / scale - sphere.textures.mean_distance) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(plane_over_plane_is_exact)
{
  Surface simple = sheet(3, flat);
  Surface fine = sheet(7, [](double, double) { return 0.03125; });
  const Uv_map uv = project(simple, as_it_is);
  const auto textures =
      TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, 64));
  BOOST_REQUIRE(textures);
  BOOST_TEST(textures.number_of_chart_texels == 64u * 64u);
  BOOST_TEST(textures.number_of_front_faces() == 64u * 64u);
  for(std::size_t i = 0; i < 64 * 64; ++i) {
    BOOST_TEST(std::abs(textures.displacements[i] - 0.03125f) < 1e-7);
    BOOST_TEST(std::abs(textures.normals[3 * i + 2] - 1) < 1e-7);
  }
  const std::vector<std::uint8_t> pixels = textures.normal_pixels<std::uint8_t>();
  for(std::size_t i = 0; i < pixels.size(); ++i)
    BOOST_TEST(pixels[i] == (i % 3 == 2 ? 255 : 128));
  BOOST_TEST(std::abs(textures.largest_distance - 0.03125) < 1e-12);
  BOOST_TEST(std::abs(textures.mean_distance - 0.03125) < 1e-12);
}

// Whichever way the chart lies in the texture, also mirrored, a viewer shows the same normals.
BOOST_AUTO_TEST_CASE(shows_bumps_on_a_plane)
{
  const auto height = [](double x, double y) { return 0.02 * std::sin(9 * x) * std::cos(7 * y + 1); };
  const Surface fine = sheet(200, height);
  for(const bool is_mirrored : {false, true})
    for(const double angle : {0., 0.5, 2.}) {
      Surface simple = sheet(2, flat);
      const Uv_map uv = project(simple, [&](double x, double y) {
        const Plane_point p(is_mirrored ? 0.5 - x : x - 0.5, y - 0.5);
        return Plane_point(Eigen::Rotation2Dd(angle) * p * 0.7 + Plane_point(0.5, 0.5));
      });
      const Frame_map frames = frame_map(simple);
      const auto textures =
          TA::bake_surface(simple, uv, fine, frames, with<Baking_options>(&Baking_options::resolution, 256));
      BOOST_REQUIRE(textures);
      const std::vector<std::uint16_t> pixels = textures.normal_pixels<std::uint16_t>();
      std::mt19937 random(4);
      for(int i = 0; i < 1000; ++i) {
        const Place place = random_place(simple, random);
        const Vector p = point_at(simple, place);
        if((p.head<2>() - Plane_point(0.5, 0.5)).cwiseAbs().maxCoeff() > 0.48)
          continue; // a texel beyond the border has the values at the border
        const double dx = 0.18 * std::cos(9 * p.x()) * std::cos(7 * p.y() + 1),
                     dy = -0.14 * std::sin(9 * p.x()) * std::sin(7 * p.y() + 1);
        const Vector shown = shown_normal(simple, frames, place,
                                          read_texture(pixels, 256, uv_at(simple, uv, place), true), 65535);
        BOOST_TEST(degrees_between(shown, Vector(-dx, -dy, 1)) < 0.3);
      }
      // Viewers without the frames take these directions, too: those of growing u and v.
      const Eigen::Matrix2d to_surface = Eigen::DiagonalMatrix<double, 2>(is_mirrored ? -1 : 1, 1) *
                                         Eigen::Rotation2Dd(-angle).toRotationMatrix();
      for(const Halfedge h : simple.halfedges())
        if(!simple.is_border(h)) {
          const Vector tangent(frames[h].tangent.data()), normal(frames[h].normal.data());
          BOOST_TEST(frames[h].sign == (is_mirrored ? -1 : 1));
          BOOST_TEST((tangent.head<2>() - to_surface.col(0)).norm() < 1e-9);
          BOOST_TEST((frames[h].sign * normal.cross(tangent).head<2>() - to_surface.col(1)).norm() < 1e-9);
        }
    }
}

BOOST_AUTO_TEST_CASE(normals_in_object_space)
{
  Surface simple = sheet(2, flat);
  const Surface fine = sheet(2, [](double x, double) { return 0.1 * x - 0.05; });
  const Uv_map uv =
      project(simple, [](double x, double y) { return Plane_point(0.9 - 0.8 * y, 0.1 + 0.8 * x); });
  const auto textures = TA::bake_surface(
      simple, uv, fine,
      with<Baking_options>(&Baking_options::resolution, 32, &Baking_options::normals_in_object_space, true));
  BOOST_REQUIRE(textures);
  const Vector expected = Vector(-0.1, 0, 1).normalized();
  for(std::size_t i = 0; i < textures.texels.size(); ++i)
    if(textures.texels[i] != TA::Baked_textures::EMPTY)
      for(std::size_t k = 0; k < 3; ++k)
        BOOST_TEST(std::abs(textures.normals[3 * i + k] - expected[k]) < 1e-6);
}

// Colours and given normals of both surfaces, on other kinds of meshes
BOOST_AUTO_TEST_CASE(colors_and_given_normals)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Surface simple = sheet(1, flat), painted = sheet(10, [](double, double) { return 0.1; });
  const Uv_map uv = project(simple, as_it_is);
  const auto color = painted.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : painted.vertices())
    color[v] = CGAL::IO::Color(static_cast<unsigned char>(std::lround(250 * painted.point(v).x())),
                               static_cast<unsigned char>(std::lround(100 * painted.point(v).y())), 7);
  const auto textures =
      TA::bake_surface(simple, uv, painted, with<Baking_options>(&Baking_options::resolution, 50),
                       np::default_values(), np::vertex_color_map(color));
  BOOST_REQUIRE(textures);
  const std::vector<std::uint8_t> pixels = textures.color_pixels<std::uint8_t>();
  for(int row = 0; row < 50; ++row)
    for(int column = 0; column < 50; ++column) {
      const std::uint8_t* pixel = &pixels[3 * (static_cast<std::size_t>(row) * 50 + column)];
      BOOST_TEST(std::abs(pixel[0] - 250 * (column + 0.5) / 50) <= 0.51);
      BOOST_TEST(std::abs(pixel[1] - 100 * (1 - (row + 0.5) / 50)) <= 0.51);
      BOOST_TEST(pixel[2] == 7);
    }

  // Oblique normals of the simple surface move what is met, and so the colours.
  const auto normal = simple.add_property_map<Vertex, Kernel::Vector_3>("v:normal", {1, 0, 2}).first;
  const auto oblique =
      TA::bake_surface(simple, uv, painted,
                       with<Baking_options>(&Baking_options::resolution, 50, &Baking_options::ray_length, 1),
                       np::vertex_normal_map(normal), np::vertex_color_map(color));
  const std::size_t middle = 25 * 50 + 25;
  BOOST_TEST(std::abs(oblique.colors[3 * middle] - 250. / 255 * (0.51 + 0.05)) < 1e-3);
  BOOST_TEST(std::abs(oblique.displacements[middle] - 0.1 * std::sqrt(1.25)) < 1e-6);

  Polyhedron fine;
  CGAL::copy_face_graph(painted, fine);
  const auto same = TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, 50));
  BOOST_TEST((same.normals == textures.normals));
  BOOST_TEST(same.colors.empty());
}

BOOST_AUTO_TEST_CASE(an_inverted_fine_surface_is_all_back_faces)
{
  const auto bowl = [](double x, double y) { return 0.05 * x * x - 0.03 * x * y; };
  Surface simple = sheet(2, flat), fine = sheet(30, bowl);
  const Uv_map uv = project(simple, as_it_is);
  const auto right =
      TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, 64));
  CGAL::Polygon_mesh_processing::reverse_face_orientations(fine);
  const auto turned =
      TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, 64));
  BOOST_TEST(right.number_of_back_faces == 0u);
  BOOST_TEST(turned.number_of_back_faces == 64u * 64u);
  BOOST_TEST(std::count(turned.texels.begin(), turned.texels.end(), TA::Baked_textures::BACK_FACE) ==
             64 * 64);
  for(std::size_t i = 0; i < right.normals.size(); ++i)
    BOOST_TEST(std::abs(right.normals[i] - turned.normals[i]) < 1e-6);
  BOOST_TEST((right.displacements == turned.displacements));
}

// The underside of a nearer sheet is no match for the upper side of a farther one.
BOOST_AUTO_TEST_CASE(front_faces_come_first)
{
  Surface simple = sheet(1, flat), fine = sheet(4, [](double, double) { return 0.01; });
  CGAL::Polygon_mesh_processing::reverse_face_orientations(fine);
  fine += sheet(4, [](double, double) { return -0.05; });
  const Uv_map uv = project(simple, as_it_is);
  const auto baked = [&](double distance) {
    return TA::bake_surface(
        simple, uv, fine,
        with<Baking_options>(&Baking_options::resolution, 16, &Baking_options::ray_length, distance));
  };
  BOOST_TEST(baked(0.06).number_of_front_faces() == 256u);
  BOOST_TEST(std::abs(baked(0.06).displacements[100] + 0.05) < 1e-6);
  BOOST_TEST(baked(0.04).number_of_back_faces == 256u);
  BOOST_TEST(std::abs(baked(0.04).displacements[100] - 0.01) < 1e-6);
  BOOST_TEST(baked(0.005).number_of_missed_rays == 256u);
  BOOST_TEST(std::abs(baked(0.005).displacements[100] - 0.01) < 1e-6);
}

// Over a hole in the fine surface, rays meet nothing, and the closest point is on the hole's border.
BOOST_AUTO_TEST_CASE(rays_through_a_hole_are_counted)
{
  Surface simple = sheet(2, flat), fine = sheet(10, [](double, double) { return 0.02; });
  for(const Face f : fine.faces()) {
    const Vector p = point_at(fine, {f, {1. / 3, 1. / 3, 1. / 3}});
    if(std::abs(p.x() - 0.5) < 0.2 && std::abs(p.y() - 0.5) < 0.1)
      CGAL::Euler::remove_face(fine.halfedge(f), fine);
  }
  const Uv_map uv = project(simple, as_it_is);
  const auto textures =
      TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, 100));
  BOOST_REQUIRE(textures);
  BOOST_TEST(textures.number_of_missed_rays == 40u * 20u);
  for(std::size_t i = 0; i < textures.texels.size(); ++i) {
    const double x = (i % 100 + 0.5) / 100, y = 1 - (i / 100 + 0.5) / 100;
    const bool is_over_hole = std::abs(x - 0.5) < 0.2 && std::abs(y - 0.5) < 0.1;
    BOOST_TEST((textures.texels[i] == TA::Baked_textures::CLOSEST_POINT) == is_over_hole);
    BOOST_TEST(std::abs(textures.displacements[i] - 0.02) < 1e-6);
  }
  const double to_border = 0.1 - 0.005; // from the middle of the texels that are farthest from it
  BOOST_TEST(std::abs(textures.largest_distance - std::hypot(to_border, 0.02)) < 1e-9);
}

// All texels that charts touch have values of their own, and those around them the values of the nearest one.
BOOST_AUTO_TEST_CASE(charts_and_gutters_are_filled)
{
  const int n = 150, gutter = 3;
  std::mt19937 random(5);
  Baked_sphere sphere;
  BOOST_REQUIRE(TA::make_atlas(sphere.simple, no_seams(sphere.simple), sphere.uv, sphere.chart,
                               few_charts(&TA::Atlas_options::resolution, n, &TA::Atlas_options::gutter,
                                          gutter, &TA::Atlas_options::separate_overlaps, true)));
  const auto color = sphere.fine.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : sphere.fine.vertices())
    color[v] = CGAL::IO::Color(static_cast<unsigned char>(random() % 256), 0, 0);
  const auto textures =
      TA::bake_surface(sphere.simple, sphere.uv, sphere.fine,
                       with<Baking_options>(&Baking_options::resolution, n, &Baking_options::gutter, gutter),
                       np::default_values(), np::vertex_color_map(color));
  BOOST_REQUIRE(textures);
  const auto is_in_chart = [&](int row, int column) {
    return textures.texels[static_cast<std::size_t>(row) * n + column] > TA::Baked_textures::GUTTER;
  };
  for(int i = 0; i < 100000; ++i) {
    const Plane_point uv = uv_at(sphere.simple, sphere.uv, random_place(sphere.simple, random));
    BOOST_TEST(is_in_chart(n - 1 - static_cast<int>(uv.y() * n), static_cast<int>(uv.x() * n)));
  }
  std::size_t charts = 0, gutters = 0;
  for(int row = 0; row < n; ++row)
    for(int column = 0; column < n; ++column) {
      if(is_in_chart(row, column)) {
        ++charts;
        continue;
      }
      int nearest = std::numeric_limits<int>::max();
      std::vector<std::size_t> candidates;
      for(int y = (std::max)(row - gutter, 0); y <= (std::min)(row + gutter, n - 1); ++y)
        for(int x = (std::max)(column - gutter, 0); x <= (std::min)(column + gutter, n - 1); ++x)
          if(const int distance = (x - column) * (x - column) + (y - row) * (y - row);
             is_in_chart(y, x) && distance <= nearest) {
            if(distance < nearest)
              candidates.clear();
            nearest = distance;
            candidates.push_back(static_cast<std::size_t>(y) * n + x);
          }
      const std::size_t texel = static_cast<std::size_t>(row) * n + column;
      gutters += !candidates.empty();
      BOOST_TEST(textures.texels[texel] ==
                 (candidates.empty() ? TA::Baked_textures::EMPTY : TA::Baked_textures::GUTTER));
      BOOST_TEST(
          (candidates.empty() || std::any_of(candidates.begin(), candidates.end(), [&](std::size_t from) {
             return textures.colors[3 * texel] == textures.colors[3 * from] &&
                    textures.displacements[texel] == textures.displacements[from] &&
                    textures.normals[3 * texel] == textures.normals[3 * from] &&
                    textures.normals[3 * texel + 1] == textures.normals[3 * from + 1] &&
                    textures.normals[3 * texel + 2] == textures.normals[3 * from + 2];
           })));
    }
  BOOST_TEST(textures.number_of_chart_texels == charts);
  BOOST_TEST(textures.number_of_gutter_texels == gutters);
  BOOST_TEST(gutters > 500u);
}

// Interpolation between texels at any place of a chart finds values of this chart only.
BOOST_AUTO_TEST_CASE(charts_do_not_bleed_into_one_another)
{
  const int n = 64;
  Surface simple = sheet(1, flat), fine = sheet(2, flat);
  Surface other = sheet(1, flat), fine_other = sheet(2, flat);
  transform(other, Eigen::Matrix3d::Identity(), Vector(0, 0, 1));
  transform(fine_other, Eigen::Matrix3d::Identity(), Vector(0, 0, 1));
  simple += other;
  fine += fine_other;
  const auto color = fine.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : fine.vertices())
    color[v] = fine.point(v).z() > 0.5 ? CGAL::IO::Color(255, 0, 0) : CGAL::IO::Color(0, 255, 0);
  const Uv_map uv = uv_map(simple);
  for(const Halfedge h : simple.halfedges()) {
    const Kernel::Point_3& p = simple.point(simple.target(h)); // two texels between the charts
    uv[h] = Kernel::Point_2((p.z() > 0.5 ? 33. : 1.) / n + 30. / n * p.x(), 0.1 + 0.8 * p.y());
  }
  const auto textures =
      TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, n),
                       np::default_values(), np::vertex_color_map(color));
  BOOST_REQUIRE(textures);
  const std::vector<std::uint8_t> pixels = textures.color_pixels<std::uint8_t>();
  std::mt19937 random(6);
  for(int i = 0; i < 20000; ++i) {
    const Place place = random_place(simple, random);
    const Vector shown = read_texture(pixels, n, uv_at(simple, uv, place), true);
    const bool is_other = point_at(simple, place).z() > 0.5;
    BOOST_TEST(std::abs(shown.x() - (is_other ? 255 : 0)) < 1e-9);
    BOOST_TEST(std::abs(shown.y() - (is_other ? 0 : 255)) < 1e-9);
  }
}

// A texture of half the height is the lower half of a square one, if the map is.
BOOST_AUTO_TEST_CASE(rectangles_are_parts_of_squares)
{
  Baked_sphere sphere;
  sphere.bake(128);
  const auto bake = [&](int height) {
    return TA::bake_surface(
        sphere.simple, sphere.uv, sphere.fine, sphere.frames,
        with<Baking_options>(&Baking_options::resolution, 128, &Baking_options::height, height),
        np::face_patch_map(sphere.chart));
  };
  const auto half = bake(64);
  BOOST_REQUIRE(half);
  BOOST_TEST(half.resolution == 128);
  BOOST_TEST(half.height == 64);
  for(const Halfedge h : sphere.simple.halfedges())
    sphere.uv[h] = Kernel::Point_2(sphere.uv[h].x(), sphere.uv[h].y() / 2);
  const auto whole = bake(128);
  const auto lower_half = [](const auto& values) {
    return std::decay_t<decltype(values)>(values.begin() + values.size() / 2, values.end());
  };
  BOOST_TEST((half.texels == lower_half(whole.texels)));
  BOOST_TEST((half.normals == lower_half(whole.normals)));
  BOOST_TEST((half.displacements == lower_half(whole.displacements)));
  BOOST_TEST(!bake(0));
}

BOOST_AUTO_TEST_CASE(threads_do_not_matter)
{
  Baked_sphere sphere;
  sphere.bake(100);
  for(const int threads : {1, 2, 3}) {
    const auto again = TA::bake_surface(
        sphere.simple, sphere.uv, sphere.fine,
        with<Baking_options>(&Baking_options::resolution, 100, &Baking_options::threads, threads),
        np::face_patch_map(sphere.chart));
    BOOST_TEST((again.normals == sphere.textures.normals));
    BOOST_TEST((again.displacements == sphere.textures.displacements));
    BOOST_TEST((again.texels == sphere.textures.texels));
    BOOST_TEST(again.mean_distance == sphere.textures.mean_distance);
  }
}

// Faces without a chart are left out, whatever their coordinates are.
BOOST_AUTO_TEST_CASE(faces_without_chart_are_ignored)
{
  Surface simple = sheet(2, flat);
  const Uv_map uv = project(simple, as_it_is);
  const auto chart = simple.add_property_map<Face, int>("f:chart", 0).first;
  for(const Face f : simple.faces())
    if(point_at(simple, {f, {1. / 3, 1. / 3, 1. / 3}}).x() > 0.5) {
      chart[f] = -1;
      uv[simple.halfedge(f)] = Kernel::Point_2(7, std::numeric_limits<double>::quiet_NaN());
    }
  const auto textures =
      TA::bake_surface(simple, uv, sheet(2, flat), with<Baking_options>(&Baking_options::resolution, 20),
                       np::face_patch_map(chart));
  BOOST_REQUIRE(textures);
  BOOST_TEST(textures.texels[5] == TA::Baked_textures::FRONT_FACE);
  BOOST_TEST(textures.texels[15] == TA::Baked_textures::EMPTY);
}

// Degenerate triangles of both surfaces are no error: they have no values of their own, or those of their sides.
BOOST_AUTO_TEST_CASE(degenerate_triangles)
{
  Surface simple = sheet(2, flat), fine = sheet(6, flat);
  for(Surface* surface : {&simple, &fine}) {
    const Vertex v = surface->add_vertex({0.25, 0, 0}), w = surface->add_vertex({0.5, 0, 0}),
                 x = surface->add_vertex({0.75, 0, 0});
    surface->add_face(v, w, x);
  }
  const Uv_map uv = project(simple, as_it_is);
  const Frame_map frames = frame_map(simple);
  const auto textures =
      TA::bake_surface(simple, uv, fine, frames, with<Baking_options>(&Baking_options::resolution, 30));
  BOOST_REQUIRE(textures);
  for(const float x : textures.normals)
    BOOST_TEST(std::isfinite(x));
  BOOST_TEST(textures.largest_distance < 1e-12);
  for(const Halfedge h : simple.halfedges())
    if(!simple.is_border(h)) {
      const Vector normal(frames[h].normal.data()), tangent(frames[h].tangent.data());
      BOOST_TEST(std::abs(normal.norm() - 1) < 1e-12);
      BOOST_TEST(std::abs(tangent.norm() - 1) < 1e-12);
      BOOST_TEST(std::abs(normal.dot(tangent)) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(errors_name_what_is_wrong)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const auto check = [](const TA::Baked_textures& textures, Diagnosis diagnosis, const std::string& word) {
    BOOST_TEST(to_string(textures.status) == to_string(diagnosis));
    BOOST_TEST((textures.message.find(word) != std::string::npos), textures.message << " lacks " << word);
    BOOST_TEST(!textures);
    BOOST_TEST(textures.normals.empty());
  };
  Surface simple = sheet(2, flat), fine = sheet(2, flat);
  const Uv_map uv = project(simple, as_it_is);
  const Halfedge corner = simple.halfedge(Face(3));
  const Vertex last(8);

  uv[corner] = Kernel::Point_2(nan, 0);
  check(TA::bake_surface(simple, uv, fine), Diagnosis::NO_TEXTURE_COORDINATES, "the face of vertex ");
  uv[corner] = Kernel::Point_2(0.5, 1.25);
  check(TA::bake_surface(simple, uv, fine), Diagnosis::OUTSIDE_SQUARE, "the face of vertex ");
  uv[corner] = Kernel::Point_2(-1e-12, 0.5);
  check(TA::bake_surface(simple, uv, fine), Diagnosis::OUTSIDE_SQUARE, "the face of vertex ");
  check(TA::bake_surface(simple, project(simple, [](double, double) { return Plane_point(0.5, 0.5); }), fine),
        Diagnosis::NO_TEXTURE_COORDINATES, "no area");
  project(simple, as_it_is);

  for(const double x : {nan, infinity, 1e38}) {
    Surface wrong = simple;
    wrong.point(last) = Kernel::Point_3(1, x, 0);
    check(TA::bake_surface(wrong, uv_map(wrong), fine), Diagnosis::NON_FINITE_POINT,
          "vertex " + std::to_string(last.idx()) + " (1, ");
    Surface wrong_fine = fine;
    wrong_fine.point(last) = Kernel::Point_3(1, x, 0);
    check(TA::bake_surface(simple, uv, wrong_fine), Diagnosis::WRONG_FINE_POINT,
          "vertex " + std::to_string(last.idx()) + " (1, ");
  }
  check(TA::bake_surface(simple, uv, Surface()), Diagnosis::EMPTY_FINE_MESH, "fine");
  Surface line;
  line.add_face(line.add_vertex({0, 0, 0}), line.add_vertex({1, 0, 0}), line.add_vertex({2, 0, 0}));
  check(TA::bake_surface(simple, uv, line), Diagnosis::EMPTY_FINE_MESH, "fine");
  const auto charts = simple.add_property_map<Face, int>("f:chart", -1).first;
  check(TA::bake_surface(simple, uv, fine, Baking_options(), np::face_patch_map(charts)),
        Diagnosis::EMPTY_MESH, "chart");

  Surface quadrangle;
  CGAL::make_quad(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                  Kernel::Point_3(0, 1, 0), quadrangle);
  check(TA::bake_surface(simple, uv, quadrangle), Diagnosis::FINE_MESH_NOT_TRIANGULATED, "is not a triangle");
  check(TA::bake_surface(quadrangle, project(quadrangle, as_it_is), fine), Diagnosis::NOT_TRIANGULATED,
        "is not a triangle");

  const auto normals = fine.add_property_map<Vertex, Kernel::Vector_3>("v:normal", {0, 0, 1}).first;
  normals[last] = Kernel::Vector_3(0, 0, 0);
  check(TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, 4),
                         np::default_values(), np::vertex_normal_map(normals)),
        Diagnosis::WRONG_NORMAL, "(1, 1, 0)");
  for(const int resolution : {-1, 0, 16385})
    check(TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::resolution, resolution)),
          Diagnosis::WRONG_OPTION, std::to_string(resolution));
  for(const int gutter : {-1, 1025})
    check(TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::gutter, gutter)),
          Diagnosis::WRONG_OPTION, std::to_string(gutter));
  for(const double distance : {0., -1., nan, infinity})
    check(TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::ray_length, distance)),
          Diagnosis::WRONG_OPTION, "ray_length");
  check(TA::bake_surface(simple, uv, fine, with<Baking_options>(&Baking_options::threads, -1)),
        Diagnosis::WRONG_OPTION, "threads");
}

BOOST_AUTO_TEST_SUITE_END()
