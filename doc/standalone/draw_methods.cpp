// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws a small picture of what each method is for, and prints measures of it:
// `draw_methods DATA_FOLDER DEMO_FOLDER PICTURE_FOLDER`.

#include "draw_tile.h"

#include "pictures/textured_atlas.h"
#include "format_number.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/corners_of_map.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Texture_atlas/split_overlaps.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pictures {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace PMP = CGAL::Polygon_mesh_processing;

const Surface_view dinosaur_view({0.45, -1, 0.35}, {0, 0, 1}), mask_view({0.3, -1, 0.1}, {0, 0, 1}),
    homer_view({0.3, 0.1, 1}, {0, 1, 0}), bust_view({0.3, 0.1, 1}, {0, 1, 0}),
    camel_view({1, 0.25, 0.5}, {0, 1, 0}), diplodocus_view({0.6, 0.3, 1}, {0, 1, 0}),
    bull_view({0.4, 0.2, 1}, {0, 1, 0});

void check(const bool is_right, const std::string& what)
{
  if(!is_right) {
    throw std::runtime_error(what + " failed");
  }
}

Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  check(CGAL::IO::read_polygon_mesh(file, mesh), "reading " + file);
  return mesh;
}

class Pictures
{
public:
  explicit Pictures(std::string folder) : m_folder(std::move(folder)) {}

  // The surface to the left, the plane to the right. The borders of what was cut open are drawn like seams.
  void draw(const std::string& name, const Mesh& mesh, const Atlas& atlas, const Surface_view& view,
            const bool is_cut_open = false, const bool is_packed = false) const
  {
    const int size = 260, levels = 25, squares = 18;
    const double margin = 6, inner = size - 2 * margin;
    Textured_surface surface = textured_atlas(mesh, atlas);
    if(is_cut_open) {
      mark_borders(surface);
    }
    const double side = side_of_squares(surface, squares);
    const Frame left{margin, margin, inner, inner}, right{size + margin, margin, inner, inner};
    Canvas canvas(2 * size, size);
    draw_textured_surface(canvas, surface, side, view, left);
    if(is_packed) {
      draw_atlas_square(canvas, surface, side, right);
    } else {
      const Plane_drawing drawing(canvas, box_in_plane(surface), right);
      drawing.draw_charts(surface, side);
      drawing.draw_borders(surface);
    }
    write(canvas, levels, "method_" + name);
  }

  // Several maps of a surface that was cut, side by side on the surface
  void draw_side_by_side(const std::string& name, const std::vector<Mesh>& meshes,
                         const std::vector<Atlas>& atlases, const Surface_view& view) const
  {
    const int width = 330, height = 580, levels = 25, squares = 44;
    const double margin = 6;
    Canvas canvas(width * static_cast<int>(atlases.size()), height);
    for(std::size_t i = 0; i < atlases.size(); ++i) {
      const Textured_surface surface = textured_atlas(meshes[i], atlases[i]);
      draw_textured_surface(
          canvas, surface, side_of_squares(surface, squares), view,
          {margin + static_cast<double>(i) * width, margin, width - 2 * margin, height - 2 * margin});
    }
    write(canvas, levels, name);
  }

private:
  void write(const Canvas& canvas, const int levels, const std::string& name) const
  {
    const std::string png = canvas.png(levels), file = m_folder + "/" + name + ".png";
    std::ofstream stream(file, std::ios::binary);
    check(!!stream.write(png.data(), static_cast<std::streamsize>(png.size())), "writing " + file);
  }

  static void mark_borders(Textured_surface& surface)
  {
    for(Textured_surface::Border& border : surface.borders) {
      for(Textured_surface::Side& side : border.sides) {
        side.seam = (std::max)(side.seam, 0);
      }
    }
  }

  std::string m_folder;
};

// A map of a mesh without seams, as coordinates of its vertices
template <class Parameterizer>
Atlas flatten(const std::string& name, Mesh& mesh, const Parameterizer& parameterizer)
{
  const Halfedge border = PMP::longest_border(mesh).first;
  const auto vertex_uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv_of_" + name).first;
  check(SMP::parameterize(mesh, parameterizer, border, vertex_uv) == SMP::OK, name);
  const SMP::Flattening_measures measures = SMP::measure_flattening(mesh, border, vertex_uv);
  std::cout << "<tr><td>" << name << "</td>";
  for(const double value : {measures.mean_angle_change * 180 / CGAL_PI, measures.mean_quasi_conformal_ratio,
                            measures.l2_area_distortion}) {
    std::cout << "<td>" << format_number("%.3g", value) << "</td>";
  }
  std::cout << "<td>" << measures.flipped_triangles << "</td><td>"
            << (measures.border_is_simple && measures.flipped_triangles == 0 ? "yes" : "no")
            << "</td></tr>\n";
  const Atlas atlas = empty_atlas(mesh);
  for(const Face f : mesh.faces()) {
    atlas.chart[f] = 0;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      atlas.uv[h] = vertex_uv[mesh.target(h)];
    }
  }
  return atlas;
}

// The surface, cut open along seams
Mesh cut_open(Mesh surface, const double stretch_bound)
{
  const Edge_marks seams = seam_marks(surface);
  TA::Seam_options options;
  options.stretch_bound = stretch_bound;
  check(bool(TA::select_seams(surface, seams, options)), "selecting seams");
  Mesh open;
  CGAL::copy_face_graph(TA::make_seam_mesh(surface, seams).mesh, open);
  return open;
}

void draw_disks(const std::string& demo, const Pictures& pictures)
{
  Mesh bust = read_mesh(demo + "/nefertiti.off");
  pictures.draw("direct", bust, flatten("ABF++", bust, SMP::ABF_plus_plus_parameterizer_3<Mesh>()),
                bust_view);
  pictures.draw("lscm", bust, flatten("LSCM", bust, SMP::LSCM_parameterizer_3<Mesh>()), bust_view);
  pictures.draw("arap", bust, flatten("ARAP", bust, SMP::ARAP_parameterizer_3<Mesh>()), bust_view);
  pictures.draw(
      "circle", bust,
      flatten("mean value coordinates, circle", bust, SMP::Mean_value_coordinates_parameterizer_3<Mesh>()),
      bust_view);
}

void draw_cut_surfaces(const std::string& demo, const Pictures& pictures)
{
  Mesh camel = cut_open(read_mesh(demo + "/camel.off"), 1.1);
  pictures.draw("seams", camel, flatten("seams, ABF++", camel, SMP::ABF_plus_plus_parameterizer_3<Mesh>()),
                camel_view, true);
  Mesh diplodocus = cut_open(read_mesh(demo + "/diplodocus.off"), 1.1);
  pictures.draw("hierarchical", diplodocus,
                flatten("seams, hierarchical ABF++", diplodocus, SMP::Hierarchical_parameterizer_3<Mesh>()),
                diplodocus_view, true);
}

void draw_holes(const std::string& data, const Pictures& pictures)
{
  Mesh mask = read_mesh(data + "/mask.off");
  SMP::ABF_plus_plus_options options;
  options.holes = options.SOLVE;
  pictures.draw("solved", mask,
                flatten("holes solved", mask, SMP::ABF_plus_plus_parameterizer_3<Mesh>(options)), mask_view);
  options.holes = options.FILL;
  pictures.draw("filled", mask,
                flatten("holes filled", mask, SMP::ABF_plus_plus_parameterizer_3<Mesh>(options)), mask_view);
}

// A rectangle whose corners are near those of the smallest rectangle around the map with a free border
void draw_rectangle(const std::string& data, const Pictures& pictures)
{
  Mesh mask = read_mesh(data + "/mask.off");
  SMP::ABF_plus_plus_options options;
  options.holes = options.SOLVE;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  const Halfedge border = PMP::longest_border(mask).first;
  const auto uv = mask.add_property_map<Vertex, Kernel::Point_2>("v:free_uv").first;
  check(SMP::parameterize(mask, parameterizer, border, uv) == SMP::OK, "the map with a free border");
  std::vector<Vertex> vertices;
  for(const Halfedge h : mask.halfedges_around_face(border)) {
    vertices.push_back(mask.target(h));
  }
  const SMP::Vertex_angles<Mesh> angles =
      SMP::rectangle_angles(mask, SMP::internal::ABF::corners_of_map(vertices, uv)).angles;
  SMP::split_flat_chords(mask, border, angles);
  parameterizer.set_angle_sums(angles);
  pictures.draw("rectangle", mask, flatten("rectangle", mask, parameterizer), mask_view);
}

// Seams of a surface through its cones
Atlas cut_through(Mesh& mesh, const TA::Cone_selection<Mesh>& cones)
{
  const Atlas atlas = empty_atlas(mesh);
  const std::set<Vertex> terminals = cones.vertices();
  const auto report = TA::cut_to_disks(
      mesh, atlas.seams,
      CGAL::parameters::vertex_is_constrained_map(CGAL::make_boolean_property_map(terminals)));
  check(bool(report), "seams through cones");
  for(const Face f : mesh.faces()) {
    atlas.chart[f] = 0;
  }
  return atlas;
}

// Cut first, with equal lengths along seams, and with rigid transitions, side by side. The last one is also a picture
// of its own.
void draw_cones(const std::string& demo, const Pictures& pictures)
{
  const Mesh mesh = read_mesh(demo + "/homer.off");
  const TA::Cone_selection<Mesh> cones = TA::select_cones(mesh, 24);
  check(bool(cones), "selecting cones");
  SMP::ABF_plus_plus_options cut_first;
  cut_first.equal_seam_lengths = false;
  typedef TA::Cut_mesh<Mesh> Cut;
  SMP::ABF_plus_plus_parameterizer_3<Cut> apart(cut_first), equal, rigid;
  rigid.set_angle_sums(cones.angles());
  std::vector<Mesh> copies(3, mesh);
  std::vector<Atlas> atlases;
  for(auto* parameterizer : {&apart, &equal, &rigid}) {
    Mesh& copy = copies[atlases.size()];
    atlases.push_back(cut_through(copy, cones));
    Cut cut = TA::make_seam_mesh(copy, atlases.back().seams).mesh;
    const auto border = TA::border_halfedge(cut);
    const auto uv = copy.add_property_map<Halfedge, Kernel::Point_2>("h:uv_of_copies").first;
    check(SMP::parameterize(cut, *parameterizer, border, uv) == SMP::OK, "a map with cones");
    const SMP::Flattening_measures measures = SMP::measure_flattening(cut, border, uv);
    for(const Halfedge h : copy.halfedges()) {
      if(!copy.is_border(h)) {
        atlases.back().uv[h] = uv[target(boost::graph_traits<Cut>::halfedge_descriptor(h), cut)];
      }
    }
    std::cout << "cones: jump by "
              << format_number("%.3g", std::exp(parameterizer->report().largest_seam_jump))
              << ", quasi-conformal ratio " << format_number("%.3g", measures.mean_quasi_conformal_ratio)
              << ", stretch " << format_number("%.3g", measures.l2_stretch) << "\n";
  }
  pictures.draw_side_by_side("cones", copies, atlases, homer_view);
  pictures.draw("cones", copies.back(), atlases.back(), homer_view);
}

// The dinosaur, cut so that its map overlaps itself: as one injective chart, and split into charts that are packed
void draw_overlaps(const std::string& data, const Pictures& pictures)
{
  Mesh dinosaur = cut_open(read_mesh(data + "/dinosaur.off"), 1.05);
  SMP::Hierarchical_options options;
  options.injective = true;
  pictures.draw(
      "injective", dinosaur,
      flatten("injective", dinosaur, SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>(options)),
      dinosaur_view, true);
  const Atlas atlas = flatten("the same, overlapping", dinosaur, SMP::ABF_plus_plus_parameterizer_3<Mesh>());
  const auto split = TA::split_overlaps(dinosaur, atlas.uv, atlas.seams, atlas.chart);
  check(!!split, "splitting");
  check(!!TA::pack_charts(dinosaur, atlas.chart, atlas.uv), "packing");
  pictures.draw("split", dinosaur, atlas, dinosaur_view, true, true);
}

// Charts of several surfaces side by side
class Collection
{
public:
  // Flattens a surface and adds it to the right of the others.
  void add(Mesh surface, const double size)
  {
    const Atlas atlas = flatten("packed chart", surface, options_with_holes());
    const CGAL::Bbox_3 box = PMP::bbox(surface);
    const double scale = size / box.z_span();
    for(const Vertex v : surface.vertices()) {
      const Kernel::Point_3 p = surface.point(v);
      surface.point(v) = {m_right + scale * (p.x() - box.xmin()), scale * (p.y() - box.ymin()),
                          scale * (p.z() - box.zmin())};
    }
    m_right += 1.05 * scale * box.x_span();
    std::vector<std::pair<Halfedge, Halfedge>> copies;
    CGAL::copy_face_graph(surface, m_mesh,
                          CGAL::parameters::halfedge_to_halfedge_output_iterator(std::back_inserter(copies)));
    for(const auto& [from, to] : copies) {
      if(!m_mesh.is_border(to)) {
        m_atlas.uv[to] = Kernel::Point_2(scale * atlas.uv[from].x(), scale * atlas.uv[from].y());
        m_atlas.chart[m_mesh.face(to)] = m_number_of_charts;
      }
    }
    ++m_number_of_charts;
  }

  void draw(const Pictures& pictures)
  {
    check(!!TA::pack_charts(m_mesh, m_atlas.chart, m_atlas.uv), "packing");
    pictures.draw("packed", m_mesh, m_atlas, mask_view, false, true);
  }

private:
  static SMP::ABF_plus_plus_parameterizer_3<Mesh> options_with_holes()
  {
    SMP::ABF_plus_plus_options options;
    options.holes = options.SOLVE;
    return SMP::ABF_plus_plus_parameterizer_3<Mesh>(options);
  }

  Mesh m_mesh;
  Atlas m_atlas = empty_atlas(m_mesh);
  int m_number_of_charts = 0;
  double m_right = 0;
};

void draw_packed_charts(const std::string& data, const Pictures& pictures)
{
  Collection collection;
  collection.add(read_mesh(data + "/mask.off"), 1);
  collection.add(cut_open(read_mesh(data + "/egg.off"), 1.1), 0.7);
  collection.add(cut_open(read_mesh(data + "/dinosaur.off"), 1.2), 0.5);
  collection.draw(pictures);
}

void draw_atlas(const std::string& demo, const Pictures& pictures)
{
  Mesh bull = read_mesh(demo + "/bull.off");
  const Atlas atlas = empty_atlas(bull);
  check(bool(TA::make_atlas(bull, atlas.seams, atlas.uv, atlas.chart, TA::Atlas_options::FEW_CHARTS)),
        "the atlas");
  pictures.draw("atlas", bull, atlas, bull_view, false, true);
}

void run(const std::string& data, const std::string& demo, const Pictures& pictures)
{
  if(!std::ifstream(demo + "/camel.off")) {
    std::cerr << "no camel.off in '" << demo << "': the pictures of the methods are left as they are\n";
    return;
  }
  draw_disks(demo, pictures);
  draw_cut_surfaces(demo, pictures);
  draw_holes(data, pictures);
  draw_rectangle(data, pictures);
  draw_cones(demo, pictures);
  draw_overlaps(data, pictures);
  draw_packed_charts(data, pictures);
  draw_atlas(demo, pictures);
}

} // namespace pictures

int main(int argc, char* argv[])
{
  if(argc != 4) {
    std::cerr << "usage: draw_methods DATA_FOLDER DEMO_FOLDER PICTURE_FOLDER\n";
    return 2;
  }
  try {
    pictures::run(argv[1], argv[2], pictures::Pictures(argv[3]));
  } catch(const std::exception& error) {
    std::cerr << "draw_methods: " << error.what() << '\n';
    return 1;
  }
}
