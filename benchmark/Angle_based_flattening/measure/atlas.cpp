// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Measurement.h"
#include "subcommands.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/overlapping_faces.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace ABF_benchmark {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
typedef CGAL::Epick Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Face_index Face;

struct Textured_mesh
{
  Textured_mesh()
      : uv(mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv", {0, 0}).first),
        chart(mesh.add_property_map<Face, int>("f:chart", -1).first),
        is_seam(mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first)
  {}
  Textured_mesh(const Textured_mesh&) = delete; // the maps would still be those of the other mesh
  Textured_mesh& operator=(const Textured_mesh&) = delete;

  Mesh mesh;
  Mesh::Property_map<Halfedge, Kernel::Point_2> uv;
  Mesh::Property_map<Face, int> chart; // -1 for none
  Mesh::Property_map<Mesh::Edge_index, bool> is_seam;
};

void read(const std::string& file, Mesh& mesh)
{
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read a manifold mesh from '" + file + "'");
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
}

// The charts, each apart from the others, with their places in the plane
class Opened_mesh
{
public:
  explicit Opened_mesh(const Textured_mesh& t)
      : m_uv(mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv", {0, 0}).first),
        m_copy(t.mesh.number_of_halfedges())
  {
    const auto cut = TA::make_seam_mesh(t.mesh, t.is_seam).mesh;
    for(const Face f : t.mesh.faces()) {
      if(t.chart[f] < 0)
        continue;
      std::vector<Mesh::Vertex_index> corners;
      for(const auto h : halfedges_around_face(halfedge(f, cut), cut))
        corners.push_back(vertex(t, target(h, cut), h));
      if(mesh.add_face(corners) == Mesh::null_face())
        throw std::runtime_error("the charts are not manifold");
    }
  }

  std::size_t number_of_flips() const
  {
    std::vector<Face> found;
    SMP::flipped_faces(mesh, m_uv, std::back_inserter(found));
    return found.size();
  }

  // Also of different charts
  std::size_t number_of_overlapping_faces() const
  {
    std::vector<Face> found;
    TA::overlapping_faces(mesh, m_uv, std::back_inserter(found));
    return found.size();
  }

  Mesh mesh;

private:
  // All corners at a vertex between two seams have its coordinates.
  Mesh::Vertex_index vertex(const Textured_mesh& t, Halfedge first, Halfedge corner)
  {
    Mesh::Vertex_index& v = m_copy[first];
    if(v == Mesh::null_vertex()) {
      v = mesh.add_vertex(t.mesh.point(t.mesh.target(corner)));
      m_uv[v] = t.uv[corner];
    }
    if(m_uv[v] != t.uv[corner])
      throw std::runtime_error("coordinates differ where there is no seam");
    return v;
  }

  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> m_uv;
  std::vector<Mesh::Vertex_index> m_copy; // of each vertex of the seam mesh
};

// Counts the texels that two charts touch, and those outside of the square, with nothing of how they were packed.
std::size_t number_of_shared_texels(const Textured_mesh& t, int resolution)
{
  std::vector<int> owner(static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution), -1);
  std::size_t shared = 0;
  for(const Face f : t.mesh.faces()) {
    if(t.chart[f] < 0)
      continue;
    std::vector<Kernel::Point_2> p;
    for(const Halfedge h : t.mesh.halfedges_around_face(t.mesh.halfedge(f)))
      p.emplace_back(t.uv[h].x() * resolution, t.uv[h].y() * resolution);
    const Kernel::Triangle_2 triangle(p[0], p[1], p[2]);
    if(triangle.is_degenerate()) // without area in space, and so on an edge of a neighbor
      continue;
    const CGAL::Bbox_2 box = triangle.bbox();
    if(box.xmin() < 0 || box.ymin() < 0 || box.xmax() > resolution || box.ymax() > resolution) {
      ++shared;
      continue;
    }
    const int left = static_cast<int>(box.xmin()), bottom = static_cast<int>(box.ymin());
    const int right = (std::min)(resolution - 1, static_cast<int>(box.xmax()));
    const int top = (std::min)(resolution - 1, static_cast<int>(box.ymax()));
    for(int y = bottom; y <= top; ++y)
      for(int x = left; x <= right; ++x) {
        if(!CGAL::do_intersect(triangle, Kernel::Iso_rectangle_2(x, y, x + 1, y + 1)))
          continue;
        int& chart = owner[static_cast<std::size_t>(y) * static_cast<std::size_t>(resolution) + x];
        if(chart >= 0 && chart != t.chart[f])
          ++shared;
        chart = t.chart[f];
      }
  }
  return shared;
}

void add_report(const TA::Atlas_report& report, Measurement& m)
{
  m.add("parts", report.number_of_parts);
  m.add("skipped", report.skipped.size());
  m.add("message", report.message);
  m.add("charts", report.charts.size());
  m.add("terminals", report.number_of_terminals);
  m.add("seam", report.relative_seam_length);
  m.add("stretch", report.measures.l2_stretch);
  m.add("energy", report.measures.angular_distortion);
  m.add("angle_change", report.measures.mean_angle_change);
  m.add("covered", report.covered_share);
  std::vector<std::size_t> made_by(4, 0);
  std::size_t missed = 0;
  double contact = 0, scale_stretch = 1;
  for(const TA::Atlas_report::Chart& chart : report.charts) {
    ++made_by[chart.method];
    missed += !chart.bound_reached;
    contact = (std::max)(contact, chart.contact);
    scale_stretch = (std::max)(scale_stretch, chart.scale_stretch);
  }
  m.add("contact", contact);
  m.add("scale_stretch", scale_stretch);
  m.add("missed", missed);
  m.add("direct", made_by[TA::Atlas_report::ABF_PLUS_PLUS]);
  m.add("hierarchical", made_by[TA::Atlas_report::HIERARCHICAL]);
  m.add("injective", made_by[TA::Atlas_report::INJECTIVE]);
  m.add("separated", made_by[TA::Atlas_report::SEPARATED]);
  m.add("texel_density", report.texel_density);
  m.add("low_texel_density", report.low_texel_density);
  m.add("read", report.seconds.read);
  m.add("chart_seconds", report.seconds.charts);
  m.add("pack", report.seconds.pack);
  m.add("certify", report.seconds.certify);
  m.add("measure", report.seconds.measure);
  m.add("write", report.seconds.write);
}

TA::Atlas_options::Purpose purpose_of(const std::string& name)
{
  for(const auto& [purpose, known] : {std::pair(TA::Atlas_options::FEW_CHARTS, "few-charts"),
                                      {TA::Atlas_options::CONFORMAL, "conformal"},
                                      {TA::Atlas_options::TEXTURE, "texture"}})
    if(name == known)
      return purpose;
  throw std::runtime_error("unknown purpose '" + name + "'");
}

} // namespace

void atlas(const std::string& file, const Atlas_choice& choice, Measurement& m)
{
  constexpr int resolution = 1024;
  Textured_mesh t;
  read(file, t.mesh);
  m.add("triangles", t.mesh.number_of_faces());
  TA::Atlas_options options(purpose_of(choice.purpose));
  if(choice.bound > 0)
    options.stretch_bound = choice.bound;
  const Gauge gauge;
  const auto report = TA::make_atlas(t.mesh, t.is_seam, t.uv, t.chart, options);
  gauge.add_to(m);
  m.add("diagnosis", to_string(report.status));
  if(!report.has_atlas())
    return m.fail(report.message);
  add_report(report, m);
  const auto has_chart = [&](Face f) { return t.chart[f] >= 0; };
  m.add("charted", std::count_if(t.mesh.faces_begin(), t.mesh.faces_end(), has_chart));
  if(!choice.checks && choice.output.empty())
    return;
  const Opened_mesh opened(t);
  if(choice.checks) {
    // Faces without area lie on edges of neighbors.
    m.add("flips", opened.number_of_flips() - report.degenerate_triangles);
    m.add("overlapping", opened.number_of_overlapping_faces());
    m.add("shared_texels", number_of_shared_texels(t, resolution));
  }
  if(!choice.output.empty() &&
     !CGAL::IO::write_polygon_mesh(choice.output, opened.mesh, CGAL::parameters::stream_precision(17)))
    throw std::runtime_error("cannot write '" + choice.output + "'");
}

} // namespace ABF_benchmark
