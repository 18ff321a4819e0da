// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes the pictures of the manual from the meshes of the examples and of CGAL's demo, and prints the manual's tables
// of measures: `pictures DATA_FOLDER DEMO_FOLDER PICTURE_FOLDER`.

#include "draw_mesh.h"

#include "pictures/Canvas.h"
#include "pictures/Distortion_scale.h"
#include "format_number.h"

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_utils.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/overlapping_faces.h>
#include <CGAL/Texture_atlas/pack_charts.h>
#include <CGAL/Texture_atlas/seam_selection.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/split_overlaps.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pictures {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;

using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

const Kernel::Vector_3 dinosaur_from(0.45, -1, 0.35), egg_from(0.5, -1, 0.35), mask_from(0.3, -1, 0.1),
    forwards(1, 0, 0), upwards(0, 0, 1);
const Kernel::Vector_3 camel_from(1, 0.25, 0.5), camel_upwards(0, 1, 0);
const Kernel::Vector_3 elephant_from(0.6, 0.3, 1), elephant_upwards(0, 1, 0);
const Kernel::Vector_3 bones_from(0, -1, 0.3), bones_upwards(0, 0, 1);

void write_file(const std::string& name, const std::string& content)
{
  std::ofstream file(name, std::ios::binary);
  if(!(file << content))
    throw std::runtime_error("cannot write " + name);
  std::cerr << name << ": " << content.size() / 1000 << " kB\n";
}

std::vector<Face> all_faces(const Mesh& mesh)
{
  return {mesh.faces_begin(), mesh.faces_end()};
}

Color color_of(const std::string& name)
{
  const long rgb = std::strtol(name.c_str() + 1, nullptr, 16);
  return {(rgb >> 16) / 255., (rgb >> 8 & 255) / 255., (rgb & 255) / 255.};
}

double in_degrees(const double radians)
{
  return radians * 180. / CGAL_PI;
}

// A mesh, its map by one of the parameterizers, and what that did to each triangle.
struct Flat_mesh
{
  Flat_mesh() = default;
  Flat_mesh(const Flat_mesh&) = delete; // the map would still be that of the other mesh
  Flat_mesh& operator=(const Flat_mesh&) = delete;

  std::string name;
  Mesh mesh;
  UV_map uv;
  std::vector<double> angle_change;      // of each face, root mean square, in degrees
  std::vector<double> mean_angle_change; // of each face, in degrees
  std::vector<double> areas;             // on the surface
  std::vector<bool> flipped;
  SMP::Flattening_measures measures;
};

using Flat_mesh_ptr = std::unique_ptr<Flat_mesh>;

template <class Parameterizer>
Flat_mesh_ptr flatten(const std::string& name, const Mesh& mesh, Parameterizer parameterizer)
{
  Flat_mesh_ptr flat = std::make_unique<Flat_mesh>();
  flat->name = name;
  flat->mesh = mesh;
  flat->uv = flat->mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  const Halfedge border = CGAL::Polygon_mesh_processing::longest_border(flat->mesh).first;
  if(SMP::parameterize(flat->mesh, parameterizer, border, flat->uv) != SMP::OK)
    throw std::runtime_error(name + " failed");
  flat->angle_change.resize(mesh.number_of_faces());
  flat->mean_angle_change.resize(mesh.number_of_faces());
  flat->areas.resize(mesh.number_of_faces());
  flat->flipped.resize(mesh.number_of_faces());
  const auto note = [&](const Face f, const SMP::Flattening_face_measures& face) {
    flat->angle_change[f.idx()] = in_degrees(face.rms_angle_change);
    flat->mean_angle_change[f.idx()] = in_degrees(face.mean_angle_change);
    flat->areas[f.idx()] = face.area;
    flat->flipped[f.idx()] = face.flipped;
  };
  flat->measures = SMP::measure_flattening(flat->mesh, border, flat->uv, CGAL::parameters::visitor(note));
  return flat;
}

// The plane as a surface in space, to be drawn like one. It is turned so that `upper`, seen from `lower`, is upwards.
Mesh plane_of(const Mesh& mesh, const UV_map& uv, const Vertex lower, const Vertex upper)
{
  const Kernel::Vector_2 up = uv[upper] - uv[lower];
  Mesh plane = mesh;
  for(const Vertex v : mesh.vertices()) {
    const Kernel::Vector_2 p = uv[v] - uv[lower];
    plane.point(v) = Kernel::Point_3(p.x() * up.y() - p.y() * up.x(), p * up, 0);
  }
  return plane;
}

const Surface_view& from_above()
{
  static const Surface_view view(Kernel::Vector_3(0, 0, 1), Kernel::Vector_3(0, 1, 0));
  return view;
}

void draw_edges(Canvas& canvas, const Mesh& mesh, const Projected_surface& corners, const double width,
                const Color& color, const bool border_only)
{
  for(const auto e : mesh.edges()) {
    if(border_only && !mesh.is_border(e))
      continue;
    Canvas::Corner p = corners[mesh.vertex(e, 0)], q = corners[mesh.vertex(e, 1)];
    p.depth += 1.5;
    q.depth += 1.5;
    canvas.draw_line(p, q, width, color);
  }
}

// By the change of the angles; red where the triangle is flipped.
Color color_of_face(const Flat_mesh& flat, const Face f, const Distortion_scale& scale)
{
  if(flat.flipped[f.idx()])
    return {0.9, 0.1, 0.1};
  return Distortion_scale::color(scale.color_index(flat.angle_change[f.idx()]));
}

void draw_plane(Canvas& canvas, const Flat_mesh& flat, const Mesh& plane, const Distortion_scale& scale,
                const Frame& frame)
{
  const Projected_surface corners(plane, all_faces(plane), from_above(), frame);
  for(const Face f : plane.faces()) {
    const Color color = color_of_face(flat, f, scale);
    draw_face(canvas, plane, f, corners, [&](const auto&) { return color; });
  }
  draw_edges(canvas, plane, corners, 1.2, {0.15, 0.15, 0.15}, true);
}

double brightness(const Kernel::Vector_3& normal)
{
  return 0.45 + 0.55 * std::abs(normal * Surface_view::normalized(Kernel::Vector_3(-0.35, 0.5, 0.8)));
}

void draw_angle_change(Canvas& canvas, const Flat_mesh& flat, const Surface_view& view,
                       const Distortion_scale& scale, const Frame& frame)
{
  const Projected_surface corners(flat.mesh, all_faces(flat.mesh), view, frame);
  for(const Face f : flat.mesh.faces()) {
    const auto normal = Surface_view::normalized(view(doubled_area_vector(flat.mesh, f)));
    const Color color = mix({0, 0, 0}, color_of_face(flat, f, scale), brightness(normal));
    draw_face(canvas, flat.mesh, f, corners, [&](const auto&) { return color; });
  }
}

// A plain surface with its edges.
void draw_net(Canvas& canvas, const Mesh& mesh, const Surface_view& view, const double width,
              const Frame& frame)
{
  const Projected_surface corners(mesh, all_faces(mesh), view, frame);
  for(const Face f : mesh.faces()) {
    const auto normal = Surface_view::normalized(view(doubled_area_vector(mesh, f)));
    const Color paint = normal.z() < 0 ? Color{0.66, 0.68, 0.7} : Color{0.86, 0.91, 0.97};
    draw_face(canvas, mesh, f, corners, [&](const auto&) {
      return mix({0, 0, 0}, paint, brightness(normal));
    });
  }
  draw_edges(canvas, mesh, corners, width, {0.08, 0.22, 0.4}, false);
}

Distortion_scale common_scale(const std::vector<const Flat_mesh*>& flats)
{
  std::vector<double> all;
  for(const Flat_mesh* flat : flats)
    all.insert(all.end(), flat->angle_change.begin(), flat->angle_change.end());
  return Distortion_scale(all);
}

// Parameterizers differ in the size of their results: the same number of squares for each.
double square_side(const Flat_mesh& flat)
{
  double area = 0;
  for(const Face f : flat.mesh.faces()) {
    const Halfedge h = flat.mesh.halfedge(f);
    area += std::abs(CGAL::to_double(CGAL::area(flat.uv[flat.mesh.source(h)], flat.uv[flat.mesh.target(h)],
                                                flat.uv[flat.mesh.target(flat.mesh.next(h))])));
  }
  return std::sqrt(area) / 26;
}

// The first and the last vertex in that direction.
std::pair<Vertex, Vertex> ends(const Mesh& mesh, const Kernel::Vector_3& direction)
{
  const auto before = [&](const Vertex v, const Vertex w) {
    return (mesh.point(w) - mesh.point(v)) * direction > 0;
  };
  const auto found = std::minmax_element(mesh.vertices_begin(), mesh.vertices_end(), before);
  return {*found.first, *found.second};
}

void draw_pair(const Flat_mesh& flat, const Kernel::Vector_3& from, const Kernel::Vector_3& axis,
               const std::string& file)
{
  Canvas canvas(1000, 520);
  const auto [lower, upper] = ends(flat.mesh, axis);
  draw_checkerboard(canvas, flat.mesh, all_faces(flat.mesh), flat.uv, square_side(flat),
                    Surface_view(from, upwards), Frame{10, 10, 590, 500});
  draw_plane(canvas, flat, plane_of(flat.mesh, flat.uv, lower, upper), common_scale({&flat}),
             Frame{620, 10, 370, 500});
  write_file(file, canvas.png());
}

void draw_package(const Flat_mesh& flat, const std::string& file)
{
  Canvas canvas(300, 300);
  draw_checkerboard(canvas, flat.mesh, all_faces(flat.mesh), flat.uv, square_side(flat),
                    Surface_view(dinosaur_from, upwards), Frame{5, 5, 290, 290});
  write_file(file, canvas.png());
}

void draw_comparison(const std::vector<Flat_mesh_ptr>& flats, const std::string& file)
{
  std::vector<const Flat_mesh*> all;
  for(const Flat_mesh_ptr& flat : flats)
    all.push_back(flat.get());
  const Distortion_scale scale = common_scale(all);
  const double column = 300;
  Canvas canvas(static_cast<int>(column * static_cast<double>(flats.size())), 690);
  for(std::size_t i = 0; i < flats.size(); ++i) {
    const double left = column * static_cast<double>(i) + 8;
    const Mesh& mesh = flats[i]->mesh;
    const auto [lower, upper] = ends(mesh, forwards);
    const Surface_view view(dinosaur_from, upwards);
    draw_checkerboard(canvas, mesh, all_faces(mesh), flats[i]->uv, square_side(*flats[i]), view,
                      Frame{left, 8, column - 16, 170});
    draw_angle_change(canvas, *flats[i], view, scale, Frame{left, 188, column - 16, 170});
    draw_plane(canvas, *flats[i], plane_of(mesh, flats[i]->uv, lower, upper), scale,
               Frame{left, 370, column - 16, 312});
  }
  write_file(file, canvas.png(51));
}

// Turns the plane so that the axis is upwards in it.
void turn_plane(Flat_mesh& flat, const Kernel::Vector_3& axis)
{
  const auto [lower, upper] = ends(flat.mesh, axis);
  const Kernel::Vector_2 up = flat.uv[upper] - flat.uv[lower];
  const double length = std::sqrt(up.squared_length());
  for(const Vertex v : flat.mesh.vertices()) {
    const Kernel::Vector_2 p = flat.uv[v] - CGAL::ORIGIN;
    flat.uv[v] = Kernel::Point_2((p.x() * up.y() - p.y() * up.x()) / length, p * up / length);
  }
}

void draw_holes(const std::vector<Flat_mesh_ptr>& flats, const std::string& file)
{
  std::vector<const Flat_mesh*> all;
  for(const Flat_mesh_ptr& flat : flats)
    all.push_back(flat.get());
  const Distortion_scale scale = common_scale(all);
  const double column = 480;
  Canvas canvas(static_cast<int>(column * static_cast<double>(flats.size())), 980);
  for(std::size_t i = 0; i < flats.size(); ++i) {
    const double left = column * static_cast<double>(i) + 8;
    Flat_mesh& flat = *flats[i];
    turn_plane(flat, upwards);
    const auto [lower, upper] = ends(flat.mesh, upwards);
    draw_checkerboard(canvas, flat.mesh, all_faces(flat.mesh), flat.uv, square_side(flat),
                      Surface_view(mask_from, upwards), Frame{left, 8, column - 16, 470});
    draw_plane(canvas, flat, plane_of(flat.mesh, flat.uv, lower, upper), scale,
               Frame{left, 500, column - 16, 470});
  }
  write_file(file, canvas.png(51));
}

// Keeps the coarse chart that the hierarchical method hands to its coarse parameterizer.
struct Coarse_chart_keeper : SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh>
{
  using Coarse_mesh = SMP::Hierarchical_coarse_mesh;
  using Base = SMP::ABF_plus_plus_parameterizer_3<Coarse_mesh>;

  std::shared_ptr<Mesh> surface = std::make_shared<Mesh>(), plane = std::make_shared<Mesh>();

  template <class UV, class Index, class Parameterized>
  SMP::Error_code parameterize(Coarse_mesh& mesh, Base::halfedge_descriptor border, UV uv, Index index,
                               Parameterized parameterized)
  {
    const SMP::Error_code result = Base::parameterize(mesh, border, uv, index, parameterized);
    surface->clear();
    plane->clear();
    for(const auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      const auto& q = get(uv, v);
      surface->add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
      plane->add_vertex(Kernel::Point_3(q.x(), q.y(), 0));
    }
    for(const auto f : mesh.faces()) {
      const auto vertices = mesh.vertices_around_face(mesh.halfedge(f));
      surface->add_face(vertices);
      plane->add_face(vertices);
    }
    return result;
  }
};

void draw_hierarchy(const Mesh& mesh, const std::string& file)
{
  SMP::Hierarchical_options options;
  options.coarse_triangles = 600;
  const Coarse_chart_keeper keeper;
  const Flat_mesh_ptr flat = flatten(
      "hierarchical", mesh, SMP::Hierarchical_parameterizer_3<Mesh, Coarse_chart_keeper>(options, keeper));
  Mesh plane = mesh;
  for(const Vertex v : mesh.vertices())
    plane.point(v) = Kernel::Point_3(flat->uv[v].x(), flat->uv[v].y(), 0);

  const Surface_view view(dinosaur_from, upwards);
  Canvas canvas(1080, 300);
  draw_net(canvas, mesh, view, 0.3, Frame{8, 8, 254, 284});
  draw_net(canvas, *keeper.surface, view, 0.9, Frame{278, 8, 254, 284});
  draw_net(canvas, *keeper.plane, from_above(), 0.9, Frame{548, 8, 254, 284});
  draw_net(canvas, plane, from_above(), 0.3, Frame{818, 8, 254, 284});
  write_file(file, canvas.png());
}

std::string svg_text(const double x, const double y, const std::string& anchor, const std::string& text)
{
  return "<text x=\"" + format_number("%g", x) + "\" y=\"" + format_number("%g", y) + "\" text-anchor=\"" +
         anchor + "\">" + text + "</text>\n";
}

// Of the logarithm of the change of the angles, by area.
class Histogram
{
public:
  static constexpr int first_decade = -2, last_decade = 2, bins = 48;

  explicit Histogram(const Flat_mesh& flat) : m_parts(bins, 0.)
  {
    double sum = 0;
    for(const double area : flat.areas)
      sum += area;
    for(std::size_t i = 0; i < flat.areas.size(); ++i) {
      const double decade = std::log10((std::max)(flat.angle_change[i], 1e-30)) - first_decade;
      const int bin = static_cast<int>(std::floor(decade * bins / (last_decade - first_decade)));
      m_parts[static_cast<std::size_t>((std::min)((std::max)(bin, 0), bins - 1))] += flat.areas[i] / sum;
    }
  }

  double operator[](const int bin) const { return m_parts[static_cast<std::size_t>(bin)]; }

private:
  std::vector<double> m_parts;
};

void draw_histogram(const std::vector<Flat_mesh_ptr>& flats, const std::string& file)
{
  const double width = 640, height = 260, left = 50, top = 20, highest = 0.16;
  const char* const colors[] = {"#b5542b", "#8a6fb0", "#14588a", "#2b9a74"};
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 720 340\" font-family=\"sans-serif\" "
      "font-size=\"13\" fill=\"#5b6775\">\n<title>Change of the angles by area</title>\n";
  const int decades = Histogram::last_decade - Histogram::first_decade;
  for(int i = 0; i <= decades; ++i) {
    const double x = left + width * i / decades;
    svg += "<path stroke=\"#d9e0e7\" d=\"M" + format_number("%g", x) + " 20v260\"/>\n";
    svg += svg_text(x, top + height + 18, "middle",
                    format_number("%g", std::pow(10., Histogram::first_decade + i)));
  }
  svg += svg_text(left + width / 2, top + height + 42, "middle",
                  "change of the angles of a triangle, in degrees");
  for(int percent = 0; percent <= 15; percent += 5)
    svg += svg_text(left - 8, top + height * (1 - percent / (100 * highest)) + 4, "end",
                    std::to_string(percent) + " %");
  for(std::size_t i = 0; i < flats.size(); ++i) {
    const Histogram histogram(*flats[i]);
    const std::string color = colors[i % 4];
    std::string path;
    for(int bin = 0; bin < Histogram::bins; ++bin) {
      const double y = top + height * (1 - (std::min)(histogram[bin] / highest, 1.));
      path += (bin == 0 ? "M" : "L") + format_number("%.1f", left + width * (bin + 0.5) / Histogram::bins) +
              " " + format_number("%.1f", y);
    }
    svg += "<path fill=\"none\" stroke-width=\"2\" stroke=\"" + color + "\" d=\"" + path + "\"/>\n";
    const double y = top + 22 + 20 * static_cast<double>(i);
    svg += "<path stroke-width=\"3\" stroke=\"" + color + "\" d=\"M" + format_number("%g", left + 15) + " " +
           format_number("%g", y - 4) + "h24\"/>\n" + svg_text(left + 46, y, "start", flats[i]->name);
  }
  write_file(file, svg + "</svg>\n");
}

void print_measures(const std::vector<Flat_mesh_ptr>& flats)
{
  for(const Flat_mesh_ptr& flat : flats) {
    const SMP::Flattening_measures& m = flat->measures;
    std::cout << "<tr><td>" << flat->name << "</td>";
    for(const double radians : {m.mean_angle_change, m.rms_angle_change, m.mean_corner_angle_change})
      std::cout << "<td>" << format_number("%.2f", in_degrees(radians)) << "</td>";
    for(const double value : {m.mean_quasi_conformal_ratio, m.quasi_conformal_ratio_95,
                              m.max_quasi_conformal_ratio, m.min_scale, m.max_scale, m.angular_distortion})
      std::cout << "<td>" << format_number("%.4g", value) << "</td>";
    std::cout << "<td>" << m.flipped_triangles << "</td></tr>\n";
  }
}

// Of the triangles that touch a hole, weighted by area, in degrees.
double mean_angle_change_at_holes(const Flat_mesh& flat)
{
  const Mesh& mesh = flat.mesh;
  std::vector<bool> is_at_hole(mesh.number_of_vertices(), false);
  for(const Vertex v : mesh.vertices())
    is_at_hole[v.idx()] = mesh.is_border(v);
  const Halfedge border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  for(const Vertex v : mesh.vertices_around_face(border))
    is_at_hole[v.idx()] = false;
  double sum = 0, area = 0;
  for(const Face f : mesh.faces()) {
    const auto vertices = mesh.vertices_around_face(mesh.halfedge(f));
    if(std::any_of(vertices.begin(), vertices.end(), [&](const Vertex v) { return is_at_hole[v.idx()]; })) {
      sum += flat.areas[f.idx()] * flat.mean_angle_change[f.idx()];
      area += flat.areas[f.idx()];
    }
  }
  return sum / area;
}

void print_measures_of_holes(const std::vector<Flat_mesh_ptr>& flats)
{
  for(const Flat_mesh_ptr& flat : flats) {
    const SMP::Flattening_measures& m = flat->measures;
    std::cout << "<tr><td>" << flat->name << "</td>";
    for(const double degrees :
        {in_degrees(m.mean_angle_change), in_degrees(m.rms_angle_change), mean_angle_change_at_holes(*flat)})
      std::cout << "<td>" << format_number("%.3f", degrees) << "</td>";
    for(const double value : {m.mean_quasi_conformal_ratio, m.quasi_conformal_ratio_95,
                              m.max_quasi_conformal_ratio, m.min_scale, m.max_scale, m.angular_distortion})
      std::cout << "<td>" << format_number("%.4g", value) << "</td>";
    std::cout << "<td>" << m.flipped_triangles << "</td><td>" << (m.border_is_simple ? "yes" : "no")
              << "</td></tr>\n";
  }
}

SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer_for(const SMP::Flattening_options::Holes holes)
{
  SMP::ABF_plus_plus_options options;
  options.holes = holes;
  return SMP::ABF_plus_plus_parameterizer_3<Mesh>(options);
}

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  return mesh;
}

using Seam_map = Mesh::Property_map<Mesh::Edge_index, bool>;

Mesh cut_open(const Mesh& mesh, const Seam_map& seams)
{
  Mesh open;
  CGAL::copy_face_graph(TA::make_seam_mesh(mesh, seams).mesh, open);
  return open;
}

// The egg, cut open along its seam.
Mesh read_egg(const std::string& folder)
{
  Mesh egg = read_mesh(folder + "/egg.off");
  const Seam_map seams = egg.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  if(const auto read = TA::read_seam_selection(folder + "/egg.selection.txt", egg, seams); !read)
    throw std::runtime_error(read.message);
  return cut_open(egg, seams);
}

// A camel, cut open along the seams that are selected for it.
Mesh read_camel(const std::string& folder)
{
  Mesh camel = read_mesh(folder + "/camel.off");
  const Seam_map seams = camel.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const auto report = TA::select_seams(camel, seams);
  if(!report)
    throw std::runtime_error(report.message);
  std::cout << "camel: " << report.number_of_terminals << " terminals, relative seam length "
            << format_number("%.2f", report.relative_seam_length) << ", predicted stretch "
            << format_number("%.3f", report.predicted_stretch) << "\n";
  return cut_open(camel, seams);
}

void draw_seams(Flat_mesh& flat, const std::string& file)
{
  std::cout << "camel: stretch " << format_number("%.3f", flat.measures.l2_stretch)
            << (flat.measures.border_is_simple ? ", injective\n" : ", overlaps\n");
  const Surface_view view(camel_from, camel_upwards);
  const Frame frame{10, 10, 580, 560};
  Canvas canvas(1200, 580);
  draw_checkerboard(canvas, flat.mesh, all_faces(flat.mesh), flat.uv, square_side(flat), view, frame);
  const Projected_surface corners(flat.mesh, all_faces(flat.mesh), view, frame);
  draw_edges(canvas, flat.mesh, corners, 3, {0.85, 0.2, 0.1}, true);
  turn_plane(flat, camel_upwards);
  const auto [lower, upper] = ends(flat.mesh, camel_upwards);
  draw_plane(canvas, flat, plane_of(flat.mesh, flat.uv, lower, upper), common_scale({&flat}),
             Frame{610, 10, 580, 560});
  write_file(file, canvas.png(51));
}

// The dinosaur, cut so that its map overlaps itself.
Mesh read_cut_dinosaur(const std::string& folder)
{
  Mesh dinosaur = read_mesh(folder + "/dinosaur.off");
  const Seam_map seams = dinosaur.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  TA::Seam_options options;
  options.stretch_bound = 1.05;
  const auto report = TA::select_seams(dinosaur, seams, options);
  if(!report)
    throw std::runtime_error(report.message);
  return cut_open(dinosaur, seams);
}

const Color chart_color{0.86, 0.91, 0.97}, overlap_color{0.85, 0.3, 0.25}, square_color{0.96, 0.96, 0.96};

Color piece_color(const int piece)
{
  const char* const colors[] = {"#9fc3e6", "#f2b26b", "#8fc99b", "#d68fb0", "#c9b458", "#a897d1", "#7fc4c4"};
  return color_of(colors[piece % 7]);
}

template <class Color_of_face>
void draw_coloured(Canvas& canvas, const Mesh& mesh, const Surface_view& view, const Frame& frame,
                   const bool is_shaded, const Color_of_face& color_of_face)
{
  const Projected_surface corners(mesh, all_faces(mesh), view, frame);
  for(const Face f : mesh.faces()) {
    const auto normal = Surface_view::normalized(view(doubled_area_vector(mesh, f)));
    const Color color = mix({0, 0, 0}, color_of_face(f), is_shaded ? brightness(normal) : 1);
    draw_face(canvas, mesh, f, corners, [&](const auto&) { return color; });
  }
  draw_edges(canvas, mesh, corners, is_shaded ? 1.5 : 1.2, {0.15, 0.15, 0.15}, true);
}

// Puts the pieces of a planar mesh into rows, the highest first.
template <class Pieces>
void move_apart(Mesh& plane, const Pieces& pieces, const int count)
{
  std::vector<CGAL::Bbox_3> boxes(static_cast<std::size_t>(count));
  std::vector<int> piece_of(plane.number_of_vertices(), 0);
  double width = 0;
  for(const Face f : plane.faces())
    for(const Vertex v : plane.vertices_around_face(plane.halfedge(f))) {
      piece_of[v.idx()] = pieces[f];
      boxes[static_cast<std::size_t>(pieces[f])] += plane.point(v).bbox();
    }
  std::vector<std::size_t> order;
  for(std::size_t i = 0; i < boxes.size(); ++i) {
    order.push_back(i);
    width = (std::max)(width, boxes[i].x_span());
  }
  std::sort(order.begin(), order.end(),
            [&](const std::size_t i, const std::size_t j) { return boxes[i].y_span() > boxes[j].y_span(); });
  const double gap = 0.04 * width;
  std::vector<Kernel::Vector_3> shifts(boxes.size());
  double x = 0, y = 0, height = 0;
  for(const std::size_t i : order) {
    if(x > 0 && x + boxes[i].x_span() > 1.2 * width) {
      x = 0;
      y -= height + gap;
      height = 0;
    }
    shifts[i] = Kernel::Vector_3(x - boxes[i].xmin(), y - boxes[i].ymax(), 0);
    x += boxes[i].x_span() + gap;
    height = (std::max)(height, boxes[i].y_span());
  }
  for(const Vertex v : plane.vertices())
    plane.point(v) = plane.point(v) + shifts[static_cast<std::size_t>(piece_of[v.idx()])];
}

// A chart whose map overlaps itself, and how it is split
class Split_chart
{
public:
  explicit Split_chart(Flat_mesh& flat)
      : m_mesh(flat.mesh), m_overlaps(m_mesh.number_of_faces(), false),
        m_piece(m_mesh.add_property_map<Face, int>("f:piece").first),
        m_seams(m_mesh.add_property_map<Mesh::Edge_index, bool>("e:new_seam", false).first)
  {
    std::vector<Face> overlapping;
    TA::overlapping_faces(m_mesh, flat.uv, std::back_inserter(overlapping));
    for(const Face f : overlapping)
      m_overlaps[f.idx()] = true;
    const auto report = TA::split_overlaps(m_mesh, flat.uv, m_seams, m_piece);
    if(!report)
      throw std::runtime_error(report.message);
    m_number_of_pieces = static_cast<int>(report.number_of_pieces);
    const auto [lower, upper] = ends(m_mesh, forwards);
    m_plane = plane_of(m_mesh, flat.uv, lower, upper);
    std::cout << "dinosaur: " << overlapping.size() << " faces overlap, " << m_number_of_pieces
              << " pieces, borders " << format_number("%.1f", 100 * report.extra_seam) << " % longer\n";
  }

  // The map with its overlaps
  void draw_map(Canvas& canvas, const Frame& frame) const
  {
    draw_coloured(canvas, m_plane, from_above(), frame, false,
                  [&](const Face f) { return m_overlaps[f.idx()] ? overlap_color : chart_color; });
  }

  // The pieces of the map, moved apart
  void draw_pieces(Canvas& canvas, const Frame& frame) const
  {
    Mesh pieces = cut_open(m_plane, m_seams);
    move_apart(pieces, m_piece, m_number_of_pieces);
    draw_coloured(canvas, pieces, from_above(), frame, false,
                  [&](const Face f) { return piece_color(m_piece[f]); });
  }

  // The pieces in the unit square
  void draw_atlas(Canvas& canvas, const Frame& frame) const
  {
    Mesh surface = cut_open(m_mesh, m_seams), atlas = cut_open(m_plane, m_seams);
    const auto uv = surface.add_property_map<Halfedge, Kernel::Point_2>("h:uv", {0, 0}).first;
    for(const Halfedge h : surface.halfedges())
      uv[h] = Kernel::Point_2(atlas.point(atlas.target(h)).x(), atlas.point(atlas.target(h)).y());
    TA::Packing_options options;
    options.gutter = 4;
    const auto report = TA::pack_charts(surface, m_piece, uv, options);
    if(!report)
      throw std::runtime_error(report.message);
    std::cout << "dinosaur: " << report.number_of_charts << " charts cover "
              << format_number("%.1f", 100 * report.covered_share) << " %\n";
    for(const Halfedge h : surface.halfedges())
      if(!surface.is_border(h))
        atlas.point(atlas.target(h)) = Kernel::Point_3(uv[h].x(), uv[h].y(), 0);
    const auto corner = [&](const double x, const double y) { return atlas.add_vertex({x, y, -1}); };
    const Vertex a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
    const auto is_square = [&](const Face f) { return f.idx() >= m_mesh.number_of_faces(); };
    atlas.add_face(a, b, c);
    atlas.add_face(a, c, d);
    draw_coloured(canvas, atlas, from_above(), frame, false,
                  [&](const Face f) { return is_square(f) ? square_color : piece_color(m_piece[f]); });
  }

  void draw_surface(Canvas& canvas, const Frame& frame) const
  {
    draw_coloured(canvas, cut_open(m_mesh, m_seams), Surface_view(dinosaur_from, upwards), frame, true,
                  [&](const Face f) { return piece_color(m_piece[f]); });
  }

private:
  Mesh& m_mesh;
  Mesh m_plane;
  std::vector<bool> m_overlaps; // of each face
  Mesh::Property_map<Face, int> m_piece;
  Seam_map m_seams;
  int m_number_of_pieces = 0;
};

void draw_split(const Split_chart& chart, const std::string& file)
{
  Canvas canvas(1200, 420);
  chart.draw_map(canvas, Frame{10, 10, 380, 400});
  chart.draw_pieces(canvas, Frame{410, 10, 380, 400});
  chart.draw_surface(canvas, Frame{810, 10, 380, 400});
  write_file(file, canvas.png(51));
}

void draw_packing(const Split_chart& chart, const std::string& file)
{
  Canvas canvas(860, 430);
  chart.draw_surface(canvas, Frame{10, 10, 410, 410});
  chart.draw_atlas(canvas, Frame{440, 10, 410, 410});
  write_file(file, canvas.png(51));
}

Flat_mesh_ptr flatten_injectively(const std::string& name, const Mesh& mesh, const double area_weight)
{
  SMP::Hierarchical_options options;
  options.injective = true;
  options.area_weight = area_weight;
  return flatten(name, mesh, SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>(options));
}

void print_measures_of_overlap(const std::vector<const Flat_mesh*>& flats)
{
  for(const Flat_mesh* flat : flats) {
    const SMP::Flattening_measures& m = flat->measures;
    std::cout << "<tr><td>" << flat->name << "</td><td>"
              << format_number("%.2f", in_degrees(m.mean_angle_change)) << "</td>";
    for(const double value :
        {m.angular_distortion, m.mean_quasi_conformal_ratio, m.l2_stretch, m.symmetric_dirichlet_energy})
      std::cout << "<td>" << format_number("%.4g", value) << "</td>";
    std::cout << "<td>" << (m.border_is_simple ? "yes" : "no") << "</td></tr>\n";
  }
}

// The chart with its overlaps, the injective map, the isometric one, and the pieces
void draw_injective(const Flat_mesh& overlapping, const Split_chart& split, const std::string& file)
{
  const SMP::Flattening_options defaults;
  const Flat_mesh_ptr injective = flatten_injectively("injective", overlapping.mesh, defaults.area_weight);
  const Flat_mesh_ptr isometric = flatten_injectively("isometric", overlapping.mesh, 1);
  print_measures_of_overlap({&overlapping, injective.get(), isometric.get()});
  Canvas canvas(1200, 420);
  split.draw_map(canvas, Frame{8, 10, 284, 400});
  double left = 308;
  for(const Flat_mesh* flat : {injective.get(), isometric.get()}) {
    const auto [lower, upper] = ends(flat->mesh, forwards);
    draw_coloured(canvas, plane_of(flat->mesh, flat->uv, lower, upper), from_above(),
                  Frame{left, 10, 284, 400}, false, [](const Face) { return chart_color; });
    left += 300;
  }
  split.draw_pieces(canvas, Frame{left, 10, 284, 400});
  write_file(file, canvas.png(51));
}

// An atlas, and its surface, cut open along the seams. If it is to be packed densely, it has several charts.
class Atlas
{
public:
  Atlas(const std::string& name, const Mesh& mesh, const bool is_dense)
  {
    Mesh copy = mesh;
    const auto uv = copy.add_property_map<Halfedge, Kernel::Point_2>("h:uv", {0, 0}).first;
    const auto chart = copy.add_property_map<Face, int>("f:chart").first;
    const Seam_map seams = copy.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    const TA::Atlas_options options(is_dense ? TA::Atlas_options::CONFORMAL : TA::Atlas_options::FEW_CHARTS);
    const auto report = TA::make_atlas(copy, seams, uv, chart, options);
    if(!report)
      throw std::runtime_error(name + ": " + report.message);
    std::cout << name << ": " << report.number_of_parts << " part(s), " << report.charts.size()
              << " chart(s), relative seam length " << format_number("%.2f", report.relative_seam_length)
              << ", stretch " << format_number("%.3f", report.measures.l2_stretch) << ", covered "
              << format_number("%.3f", report.covered_share) << "\n";

    using Cut_mesh = TA::Cut_mesh<Mesh>;
    using Cut_vertex = boost::graph_traits<Cut_mesh>::vertex_descriptor;
    std::vector<std::pair<Cut_vertex, Vertex>> copies;
    CGAL::copy_face_graph(TA::make_seam_mesh(copy, seams).mesh, m_surface,
                          CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(copies)));
    m_plane = m_surface;
    m_uv = m_surface.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
    for(const auto& [cut_vertex, v] : copies) {
      m_uv[v] = uv[Halfedge(cut_vertex)];
      m_plane.point(v) = Kernel::Point_3(m_uv[v].x(), m_uv[v].y(), 0);
    }
    for(const Face f : copy.faces())
      m_chart.push_back(chart[f]);
    m_side = std::sqrt(report.covered_share) / 26;
  }
  Atlas(const Atlas&) = delete; // the map would still be that of the other mesh
  Atlas& operator=(const Atlas&) = delete;

  void draw_surface(Canvas& canvas, const Surface_view& view, const Frame& frame) const
  {
    draw_checkerboard(canvas, m_surface, all_faces(m_surface), m_uv, m_side, view, frame);
    draw_edges(canvas, m_surface, Projected_surface(m_surface, all_faces(m_surface), view, frame), 2.4,
               {0.85, 0.2, 0.1}, true);
  }

  // The unit square, of that size in pixels
  void draw_square(Canvas& canvas, const double left, const double top, const double size) const
  {
    const auto corner = [&](const double x, const double y) {
      return Canvas::Corner{left + size * x, top + size * (1 - y), -1, {}};
    };
    for(const auto& [a, b] : {std::pair(corner(0, 0), corner(1, 0)),
                              {corner(1, 0), corner(1, 1)},
                              {corner(1, 1), corner(0, 1)},
                              {corner(0, 1), corner(0, 0)}})
      canvas.draw_line(a, b, 1, {0.6, 0.6, 0.6});
    const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(m_plane);
    const Frame frame{left + size * box.xmin(), top + size * (1 - box.ymax()), size * box.x_span(),
                      size * box.y_span()};
    draw_coloured(canvas, m_plane, from_above(), frame, false,
                  [&](const Face f) { return piece_color(m_chart[f.idx()]); });
  }

private:
  Mesh m_surface, m_plane;
  UV_map m_uv;
  std::vector<int> m_chart; // of each face
  double m_side = 0;        // of the squares of the checkerboard
};

void draw_atlases(const std::string& demo, const std::string& file)
{
  const double column = 400;
  const Atlas elephant("elephant", read_mesh(demo + "/elephant.off"), false),
      dense("elephant, dense", read_mesh(demo + "/elephant.off"), true),
      bones("bones", read_mesh(demo + "/bones.off"), false);
  const Surface_view elephant_view(elephant_from, elephant_upwards), bones_view(bones_from, bones_upwards);
  Canvas canvas(static_cast<int>(3 * column), 790);
  double left = 8;
  for(const auto& [atlas, view] :
      {std::pair(&elephant, elephant_view), {&dense, elephant_view}, {&bones, bones_view}}) {
    atlas->draw_surface(canvas, view, Frame{left, 8, column - 16, column - 30});
    atlas->draw_square(canvas, left, column - 2, column - 16);
    left += column;
  }
  write_file(file, canvas.png(51));
}

void run(const std::string& data, const std::string& demo, const std::string& pictures)
{
  const Mesh dinosaur = read_mesh(data + "/dinosaur.off");
  std::vector<Flat_mesh_ptr> flats;
  flats.push_back(flatten("LSCM", dinosaur, SMP::LSCM_parameterizer_3<Mesh>()));
  flats.push_back(flatten("ARAP", dinosaur, SMP::ARAP_parameterizer_3<Mesh>()));
  flats.push_back(flatten("ABF++", dinosaur, SMP::ABF_plus_plus_parameterizer_3<Mesh>()));
  flats.push_back(flatten("hierarchical ABF++", dinosaur, SMP::Hierarchical_parameterizer_3<Mesh>()));
  print_measures(flats);
  draw_pair(*flats[2], dinosaur_from, forwards, pictures + "/dinosaur.png");
  draw_package(*flats[2], pictures + "/package.png");
  draw_comparison(flats, pictures + "/comparison.png");
  draw_histogram(flats, pictures + "/histogram.svg");
  draw_hierarchy(dinosaur, pictures + "/hierarchy.png");
  draw_pair(*flatten("egg", read_egg(data), SMP::ABF_plus_plus_parameterizer_3<Mesh>()), egg_from, upwards,
            pictures + "/egg.png");

  const Mesh mask = read_mesh(data + "/mask.off");
  std::vector<Flat_mesh_ptr> masks;
  masks.push_back(flatten("solved", mask, parameterizer_for(SMP::Flattening_options::SOLVE)));
  masks.push_back(flatten("filled", mask, parameterizer_for(SMP::Flattening_options::FILL)));
  print_measures_of_holes(masks);
  draw_holes(masks, pictures + "/holes.png");

  const Flat_mesh_ptr overlapping =
      flatten("overlapping", read_cut_dinosaur(data), SMP::ABF_plus_plus_parameterizer_3<Mesh>());
  const Split_chart split(*overlapping);
  draw_split(split, pictures + "/split.png");
  draw_packing(split, pictures + "/packing.png");
  draw_injective(*overlapping, split, pictures + "/injective.png");

  if(std::ifstream(demo + "/camel.off")) {
    draw_seams(*flatten("camel", read_camel(demo), SMP::ABF_plus_plus_parameterizer_3<Mesh>()),
               pictures + "/seams.png");
    draw_atlases(demo, pictures + "/atlas.png");
  } else
    std::cerr << "no camel.off in '" << demo << "': seams.png and atlas.png are left as they are\n";
}

} // namespace pictures

int main(int argc, char* argv[])
{
  if(argc != 4) {
    std::cerr << "usage: pictures DATA_FOLDER DEMO_FOLDER PICTURE_FOLDER\n";
    return 2;
  }
  try {
    pictures::run(argv[1], argv[2], argv[3]);
  } catch(const std::exception& error) {
    std::cerr << "pictures: " << error.what() << '\n';
    return 1;
  }
}
