// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes the meshes in `data/`: a dinosaur cut open along its underside, an egg with the seam of an orange peel, and a
// mask with three holes: `generate_meshes [FOLDER]`, by default `data`. Nothing is random, but the meshes can depend on
// the version of CGAL; those in `data/` are of 5.5.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/facets_in_complex_3_to_triangle_mesh.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// A point on the axis of a limb, and how thick the limb is there.
struct Knot
{
  Point_3 center;
  double radius;
};

using Limb = std::vector<Knot>;

// Cuts the corners of the axis (Chaikin).
Limb smooth(Limb limb)
{
  for(int round = 0; round < 3; ++round) {
    Limb finer{limb.front()};
    for(std::size_t i = 1; i < limb.size(); ++i) {
      const Knot &p = limb[i - 1], &q = limb[i];
      for(const double t : {0.25, 0.75}) {
        finer.push_back({p.center + t * (q.center - p.center), p.radius + t * (q.radius - p.radius)});
      }
    }
    finer.push_back(limb.back());
    limb = finer;
  }
  return limb;
}

// The x axis points forwards, the z axis upwards; y = 0 is the plane of symmetry.
std::vector<Limb> dinosaur_limbs()
{
  std::vector<Limb> limbs;
  const auto add = [&limbs](const Limb& limb) { limbs.push_back(smooth(limb)); };
  add({{{-3.3, 0, -0.1}, 0.05}, // tail
       {{-2.8, 0, -0.4}, 0.08},
       {{-2.1, 0, -0.35}, 0.13},
       {{-1.4, 0, -0.1}, 0.22},
       {{-0.8, 0, 0.04}, 0.36}, // trunk
       {{-0.3, 0, 0.12}, 0.5},
       {{0.2, 0, 0.1}, 0.5},
       {{0.7, 0, 0.1}, 0.33},
       {{1.15, 0, 0.4}, 0.22}, // neck
       {{1.45, 0, 0.9}, 0.18},
       {{1.6, 0, 1.4}, 0.16},
       {{1.7, 0, 1.78}, 0.16},
       {{1.95, 0, 1.98}, 0.23}, // head
       {{2.2, 0, 1.9}, 0.2},
       {{2.5, 0, 1.74}, 0.13}});
  for(const int side : {-1, 1}) { // legs
    add({{{0.5, side * 0.26, -0.05}, 0.25},
         {{0.56, side * 0.34, -0.45}, 0.19},
         {{0.6, side * 0.35, -0.85}, 0.17}});
    add({{{-0.55, side * 0.28, -0.05}, 0.32},
         {{-0.5, side * 0.38, -0.45}, 0.22},
         {{-0.56, side * 0.38, -0.85}, 0.19}});
  }
  return limbs;
}

// Signed, negative inside.
double distance_to_limb(const Limb& limb, const Point_3& p)
{
  double nearest = (std::numeric_limits<double>::max)();
  for(std::size_t i = 1; i < limb.size(); ++i) {
    const Vector_3 axis = limb[i].center - limb[i - 1].center;
    const double t = (std::min)((std::max)((p - limb[i - 1].center) * axis / axis.squared_length(), 0.), 1.);
    const double radius = limb[i - 1].radius + t * (limb[i].radius - limb[i - 1].radius);
    const Point_3 foot = limb[i - 1].center + t * axis;
    nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(p, foot)) - radius);
  }
  return nearest;
}

// Negative inside. The limbs blend into one another.
double dinosaur(const Point_3& p)
{
  static const std::vector<Limb> limbs = dinosaur_limbs();
  const double sharpness = 14.;
  double sum = 0.;
  for(const Limb& limb : limbs) {
    sum += std::exp(-sharpness * distance_to_limb(limb, p));
  }
  return -std::log(sum) / sharpness;
}

// In the plane of symmetry.
Vector_3 dinosaur_gradient(const Point_3& p)
{
  const double h = 1e-5;
  const Vector_3 x(h, 0, 0), z(0, 0, h);
  return Vector_3((dinosaur(p + x) - dinosaur(p - x)) / (2. * h), 0.,
                  (dinosaur(p + z) - dinosaur(p - z)) / (2. * h));
}

// The underside in the plane of symmetry, from the tip of the tail to the throat.
std::vector<Point_3> dinosaur_seam()
{
  const auto onto_surface = [](Point_3 p) {
    for(int step = 0; step < 5; ++step) {
      const Vector_3 gradient = dinosaur_gradient(p);
      p = p - dinosaur(p) / gradient.squared_length() * gradient;
    }
    return p;
  };
  std::vector<Point_3> seam{onto_surface(Point_3(-3.2, 0, -0.3))};
  while(seam.back().x() < 1.85) {
    const Vector_3 normal = dinosaur_gradient(seam.back());
    const Vector_3 along(-normal.z(), 0, normal.x());
    seam.push_back(onto_surface(seam.back() + 0.01 / std::sqrt(normal.squared_length()) * along));
  }
  return seam;
}

// Upper bounds: of the edges on curves, of the circumradii of triangles, and of the distance to the surface.
struct Sizes
{
  double edge, triangle, distance;
};

Mesh::Property_map<Mesh::Edge_index, bool> edges_on_curves(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:curve", false).first;
}

// The surface of a solid, which is where the function is negative. The curves are among its edges.
Mesh mesh_solid(double (*solid)(const Point_3&), const std::vector<std::vector<Point_3>>& curves,
                const Sizes& sizes)
{
  namespace parameters = CGAL::parameters;
  using Implicit_domain = CGAL::Labeled_mesh_domain_3<Kernel>;
  using Domain = CGAL::Mesh_domain_with_polyline_features_3<Implicit_domain>;
  using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
  using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
  Domain domain(Implicit_domain::create_implicit_mesh_domain(solid, Kernel::Sphere_3(CGAL::ORIGIN, 20.),
                                                             parameters::relative_error_bound = 1e-6));
  domain.add_features(curves.begin(), curves.end());
  const CGAL::Mesh_criteria_3<Triangulation> criteria(
      parameters::edge_size = sizes.edge, parameters::facet_angle = 30.,
      parameters::facet_size = sizes.triangle, parameters::facet_distance = sizes.distance);
  const Complex complex =
      CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(), parameters::no_exude());
  Mesh mesh;
  CGAL::facets_in_complex_3_to_triangle_mesh(complex, mesh);

  std::map<Point_3, Mesh::Vertex_index> vertex;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    vertex[mesh.point(v)] = v;
  }
  const auto on_curve = edges_on_curves(mesh);
  for(auto e = complex.edges_in_complex_begin(); e != complex.edges_in_complex_end(); ++e) {
    on_curve[mesh.edge(mesh.halfedge(vertex.at(e->first->vertex(e->second)->point().point()),
                                     vertex.at(e->first->vertex(e->third)->point().point())))] = true;
  }
  return mesh;
}

// A closed surface that has the seam among its edges, and is cut open there.
Mesh make_dinosaur()
{
  Mesh closed = mesh_solid(dinosaur, {dinosaur_seam()}, {0.05, 0.06, 0.003});
  const auto on_curve = edges_on_curves(closed);
  const auto seam_edges = closed.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const auto seam_vertices = closed.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
  CGAL::Seam_mesh<Mesh, decltype(seam_edges), decltype(seam_vertices)> cut(closed, seam_edges, seam_vertices);
  for(const Mesh::Edge_index e : closed.edges()) {
    if(on_curve[e]) {
      cut.add_seam(closed.vertex(e, 0), closed.vertex(e, 1));
    }
  }
  Mesh open;
  CGAL::copy_face_graph(cut, open);
  return open;
}

// What stands out from the mask, seen from the front, or lies deeper. What is not in the middle is on both sides.
struct Feature
{
  double x, z, width, height, depth;
};

// Negative inside: half an egg, with a face. The y axis points backwards, the z axis upwards.
double mask(const Point_3& p)
{
  static const std::vector<Feature> features{
      {0, 0.22, 0.09, 0.16, 0.1}, // nose
      {0, 0.03, 0.085, 0.13, 0.16},   {0, -0.09, 0.11, 0.09, 0.18},
      {0.1, -0.13, 0.06, 0.05, 0.09}, {0.17, 0.39, 0.13, 0.06, 0.08},  // brows
      {0.38, 0.4, 0.13, 0.07, 0.1},   {0.33, 0.2, 0.25, 0.2, -0.25},   // eyes, and the lids
      {0.33, 0.2, 0.18, 0.1, 0.34},   {0.42, -0.12, 0.16, 0.14, 0.12}, // cheeks
      {0.3, -0.4, 0.08, 0.14, -0.05}, {0, -0.5, 0.36, 0.22, 0.26},     // lips
      {0, -0.72, 0.2, 0.04, -0.04},   {0, -0.86, 0.22, 0.12, 0.14},    // chin
      {0, 0.65, 0.35, 0.2, 0.04}};                                     // forehead
  double relief = 0.;
  for(const Feature& feature : features) {
    const double z = (p.z() - feature.z) / feature.height;
    for(const double x : {p.x() - feature.x, p.x() + feature.x}) {
      relief += (feature.x == 0. ? 0.5 : 1.) * feature.depth *
                std::exp(-x * x / (feature.width * feature.width) - z * z);
    }
  }
  relief *= p.y() < 0. ? 1. - std::exp(-10. * p.y() * p.y()) : 0.;
  const double x = p.x() / (0.76 + 0.1 * std::tanh(2.5 * p.z() + 0.625)), y = p.y() / 0.72;
  return std::sqrt(x * x + y * y + p.z() * p.z()) - 1. - relief / 0.7;
}

// Where the ray leaves the mask.
Point_3 point_on_mask(const Point_3& inside, const Vector_3& direction)
{
  double lower = 0., upper = 2.;
  for(int i = 0; i < 60; ++i) {
    const double middle = (lower + upper) / 2.;
    (mask(inside + middle * direction) < 0. ? lower : upper) = middle;
  }
  return inside + lower * direction;
}

// The outer border, the mouth, and the eyes.
std::vector<std::vector<Point_3>> mask_borders()
{
  const auto in_front = [](const double x, const double z) {
    return point_on_mask(Point_3(x, 0, z), Vector_3(0, -1, 0));
  };
  std::vector<std::vector<Point_3>> borders(4);
  const int points = 400;
  for(int i = 0; i <= points; ++i) {
    const double turn = 2. * CGAL_PI * (i % points) / points;
    const double x = std::cos(turn), z = std::sin(turn);
    borders[0].push_back(point_on_mask(CGAL::ORIGIN, Vector_3(x, 0, z)));
    borders[1].push_back(in_front(0.44 * x, -0.55 + 0.13 * z + 0.174 * x * x));
    for(const int side : {-1, 1}) {
      borders[side < 0 ? 2 : 3].push_back(
          in_front(side * (0.34 + 0.2 * x), 0.2 + 0.085 * z - 0.052 * x * x - 0.02 * x));
    }
  }
  return borders;
}

// The part of the surface that the curves bound, from the face on.
Mesh part_within_curves(Mesh& mesh, const Mesh::Face_index first)
{
  const auto on_curve = edges_on_curves(mesh);
  std::vector<bool> is_inside(mesh.number_of_faces(), false);
  std::vector<Mesh::Face_index> faces{first};
  is_inside[first.idx()] = true;
  for(std::size_t i = 0; i < faces.size(); ++i) {
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(faces[i]))) {
      const Mesh::Face_index neighbor = mesh.face(mesh.opposite(h));
      if(!on_curve[mesh.edge(h)] && !is_inside[neighbor.idx()]) {
        is_inside[neighbor.idx()] = true;
        faces.push_back(neighbor);
      }
    }
  }
  std::map<Mesh::Vertex_index, Mesh::Vertex_index> vertex;
  Mesh part;
  for(const Mesh::Face_index f : mesh.faces()) {
    if(is_inside[f.idx()]) {
      std::vector<Mesh::Vertex_index> corners;
      for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
        const auto found = vertex.find(v);
        corners.push_back(found != vertex.end() ? found->second : vertex[v] = part.add_vertex(mesh.point(v)));
      }
      part.add_face(corners);
    }
  }
  return part;
}

Mesh make_mask()
{
  Mesh closed = mesh_solid(mask, mask_borders(), {0.04, 0.038, 0.0015});
  const Point_3 nose(0, -1, -0.09);
  const auto is_nearer = [&](const Mesh::Vertex_index v, const Mesh::Vertex_index w) {
    return CGAL::squared_distance(closed.point(v), nose) < CGAL::squared_distance(closed.point(w), nose);
  };
  const Mesh::Vertex_index nearest =
      *std::min_element(closed.vertices_begin(), closed.vertices_end(), is_nearer);
  return part_within_curves(closed, closed.face(closed.halfedge(nearest)));
}
// Random numbers between -1 and 1. The distributions of the standard library differ between its makers.
class Jitter
{
public:
  double operator()() { return 2. * m_random() / static_cast<double>(std::mt19937::max()) - 1.; }

private:
  std::mt19937 m_random;
};

// The egg: a sphere, longer and more pointed upwards. `part` goes from 0 at the lower pole to 1 at the upper.
Point_3 egg_point(const double part, const double turn)
{
  const double z = 2. * part - 1.;
  const double radius = std::sqrt((std::max)(0., 1. - z * z)) * (1. - 0.18 * z);
  return Point_3(radius * std::cos(turn), radius * std::sin(turn), 1.3 * z);
}

// Points at even distances on the spiral from near one pole to near the other.
std::vector<Point_3> peel_seam(const double turns, const double distance)
{
  const auto on_spiral = [turns](const double t) {
    return egg_point((1. - std::cos(t)) / 2., 2. * turns * t);
  };
  std::vector<Point_3> seam;
  const double last = CGAL_PI - 0.12;
  for(double t = 0.12; t < last; t += 1e-5) {
    const Point_3 p = on_spiral(t);
    if(seam.empty() || CGAL::squared_distance(seam.back(), p) >= distance * distance) {
      seam.push_back(p);
    }
  }
  return seam;
}

// The seam, then random points that keep their distance from it and from one another.
std::vector<Point_3> egg_points(std::vector<Point_3> points, const double distance)
{
  Jitter jitter;
  for(int trial = 0; trial < 60000; ++trial) {
    const double part = (jitter() + 1.) / 2.;
    const Point_3 p = egg_point(part, CGAL_PI * jitter());
    bool is_free = true;
    for(std::size_t i = 0; i < points.size() && is_free; ++i) {
      is_free = CGAL::squared_distance(points[i], p) >= distance * distance;
    }
    if(is_free) {
      points.push_back(p);
    }
  }
  return points;
}

void write_off(const std::string& name, const std::string& remark, const Mesh& mesh)
{
  std::ofstream file(name);
  file << "OFF\n# " << remark
       << "\n# Made by generate_meshes.cpp of Angle_based_flattening; GPL-3.0-or-later.\n"
       << mesh.number_of_vertices() << ' ' << mesh.number_of_faces() << " 0\n"
       << std::setprecision(6);
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    file << mesh.point(v).x() << ' ' << mesh.point(v).y() << ' ' << mesh.point(v).z() << '\n';
  }
  for(const Mesh::Face_index f : mesh.faces()) {
    file << 3;
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      file << ' ' << v.idx();
    }
    file << '\n';
  }
}

// A selection file as CGAL's Seam_mesh reads it: the third line holds the edges.
void write_seam(const std::string& name, const std::size_t length)
{
  std::ofstream file(name);
  file << "\n\n";
  for(std::size_t i = 1; i < length; ++i) {
    file << (i == 1 ? "" : " ") << i - 1 << ' ' << i;
  }
  file << '\n';
}

// The points lie on a convex surface, so that their hull is a triangulation of all of them. In the result
// they have the order that they have here.
Mesh convex_surface(const std::vector<Point_3>& points)
{
  Mesh hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  std::map<Point_3, Mesh::Vertex_index> vertex;
  Mesh mesh;
  for(const Point_3& p : points) {
    vertex[p] = mesh.add_vertex(p);
  }
  for(const Mesh::Face_index f : hull.faces()) {
    std::vector<Mesh::Vertex_index> corners;
    for(const Mesh::Vertex_index v : hull.vertices_around_face(hull.halfedge(f))) {
      corners.push_back(vertex.at(hull.point(v)));
    }
    mesh.add_face(corners);
  }
  return mesh;
}

// Whether every edge of the seam, the vertices from 0 to `length - 1`, is an edge of the mesh.
bool has_seam(const Mesh& mesh, const std::size_t length)
{
  for(std::size_t i = 1; i < length; ++i) {
    if(mesh.halfedge(Mesh::Vertex_index(i - 1), Mesh::Vertex_index(i)) == Mesh::null_halfedge()) {
      return false;
    }
  }
  return true;
}

long number_of_borders(const Mesh& mesh)
{
  long borders = 0;
  std::vector<bool> visited(mesh.number_of_halfedges(), false);
  for(const Mesh::Halfedge_index start : mesh.halfedges()) {
    borders += mesh.is_border(start) && !visited[start.idx()] ? 1 : 0;
    for(Mesh::Halfedge_index h = start; mesh.is_border(h) && !visited[h.idx()]; h = mesh.next(h)) {
      visited[h.idx()] = true;
    }
  }
  return borders;
}

// Whether it is a disk with so many borders, all but one of which are holes.
bool is_disk(const Mesh& mesh, const long borders)
{
  const auto euler = static_cast<long>(mesh.number_of_vertices()) -
                     static_cast<long>(mesh.number_of_edges()) + static_cast<long>(mesh.number_of_faces());
  return CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh) && euler == 2 - borders &&
         number_of_borders(mesh) == borders;
}

int main(int argc, char* argv[])
{
  const std::string folder = argc > 1 ? argv[1] : "data";

  const double distance = 0.065;
  const std::vector<Point_3> seam = peel_seam(4., distance);
  const Mesh egg = convex_surface(egg_points(seam, distance));
  if(!CGAL::is_valid_polygon_mesh(egg) || !CGAL::is_closed(egg) || !has_seam(egg, seam.size())) {
    std::cerr << "The egg is not closed, or lacks its seam.\n";
    return 1;
  }
  write_off(folder + "/egg.off",
            "An egg. Vertices from 0 on are a spiral from pole to pole: egg.selection.txt.", egg);
  write_seam(folder + "/egg.selection.txt", seam.size());

  const Mesh dinosaur = make_dinosaur();
  if(!is_disk(dinosaur, 1)) {
    std::cerr << "The dinosaur is not a disk.\n";
    return 1;
  }
  write_off(folder + "/dinosaur.off", "A dinosaur, cut open on its underside from the tail to the throat.",
            dinosaur);

  const Mesh mask = make_mask();
  if(!is_disk(mask, 4)) {
    std::cerr << "The mask is not a disk with three holes.\n";
    return 1;
  }
  write_off(folder + "/mask.off", "A mask with holes for the eyes and the mouth.", mask);

  std::cout << "dinosaur: " << dinosaur.number_of_faces() << " triangles; egg: " << egg.number_of_faces()
            << " triangles, a seam of " << seam.size() - 1 << " edges; mask: " << mask.number_of_faces()
            << " triangles\n";
}
