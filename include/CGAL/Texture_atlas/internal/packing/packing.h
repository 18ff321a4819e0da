// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Options and results of packing, with the similarity that each chart gets, and the outcome of the check.
// `pack.h` has them in its interface, `scaled_charts.h` reads the options.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACKING_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACKING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline constexpr int largest_resolution = 1 << 15, most_pages = 10000;

// The same page whose texels are the blocks. Where charts are apart there, no block belongs to two of them.
inline Packing_options in_blocks(const Packing_options& options)
{
  Packing_options blocks = options;
  blocks.resolution = options.resolution / options.block;
  blocks.height = options.number_of_rows() / options.block;
  blocks.gutter = (options.number_of_gutter_texels() + options.block - 1) / options.block;
  blocks.texels_per_unit = options.texels_per_unit / options.block;
  blocks.block = 1;
  return blocks;
}

// Where coordinates are quantized, vertices move at most that many steps of the grid.
inline constexpr double quantized_move = 3, quantized_border_move = 1;

// The texels between two numbers of the grid of coordinates; 0 if there is none
inline double texels_of_step(const Packing_options& options)
{
  const double side = (std::max)(options.resolution, options.number_of_rows());
  return options.quantization_bits ? side / ((1 << *options.quantization_bits) - 1) : 0;
}

// Borders move at most that many texels in both directions. The grid is even up to a 65535th of the page.
inline double largest_border_move(const Packing_options& options)
{
  const double unevenness = (std::max)(options.resolution, options.number_of_rows()) / 65535.;
  return options.quantization_bits ? quantized_border_move * texels_of_step(options) + unevenness : 0;
}

// The grid of the glTF extension KHR_mesh_quantization, from 0 to 1. A number of fewer than 16 bits is stored as one of
// 16 bits that repeats its first bits at the end, and stands for this divided by 65535.
class Quantization_grid
{
public:
  explicit Quantization_grid(int bits) : m_bits(bits) {}

  int last() const { return (1 << m_bits) - 1; }
  int nearest(double x) const { return static_cast<int>(std::rint(std::clamp(x, 0., 1.) * last())); }

  // As it is stored
  int code(int i) const { return i << (16 - m_bits) | i >> (2 * m_bits - 16); }

  // The nearest number of type `float` for which 1 - x is one, too
  double coordinate(int i) const
  {
    const double unit = 1. / (1 << 24);
    return std::rint(code(i) / 65535. / unit) * unit;
  }

  template <typename Point>
  bool has(const Point& p) const
  {
    return coordinate(nearest(p.x())) == p.x() && coordinate(nearest(p.y())) == p.y();
  }

private:
  int m_bits;
};

// The heights of a page that is a unit square, relative to those where texels are squares
inline double aspect_ratio(const Packing_options& options)
{
  return static_cast<double>(options.resolution) / options.number_of_rows();
}

// The lower left corner of a page: ten are side by side.
inline Planar_point corner_of_page(int page)
{
  return Planar_point(page % 10, page / 10);
}

// A rotation, scaled, without a reflection, where the width of a page has the length 1; then each page becomes a unit
// square at its corner. Small charts far from the origin lose no digits: `origin` is subtracted first.
struct Similarity
{
  double cosine = 1, sine = 0;                                              // times the scale
  Planar_point origin = Planar_point::Zero(), image = Planar_point::Zero(); // of the origin
  double aspect = 1;                                                        // the factor of heights
  Planar_point corner = Planar_point::Zero();                               // of the page

  Planar_point operator()(const Planar_point& p) const
  {
    const double x = p.x() - origin.x(), y = p.y() - origin.y();
    return {cosine * x - sine * y + image.x() + corner.x(),
            aspect * (sine * x + cosine * y + image.y()) + corner.y()};
  }
};

struct Packing
{
  enum Status
  {
    DONE,
    WRONG_OPTION,
    NON_FINITE,       // a coordinate or an area is infinite or not a number, or an area is negative
    DEGENERATE_CHART, // it has no area in the plane
    NO_AREA,          // all triangles should have the area 0
    TOO_MANY_CHARTS,  // they do not fit even where each is as large as one texel
    CHART_TOO_LARGE,  // for a page, with the given number of texels per unit
    TOO_MANY_PAGES
  };

  Status status = DONE;
  int chart = -1;                    // the first that is wrong
  std::vector<Similarity> placement; // of each chart
  std::vector<int> page;             // the same
  std::vector<double> scale;         // the same, relative to that of all: less than 1 if it was reduced alone
  double number_of_pages = 1;        // or about how many there would have to be

  Planar_point texels = Planar_point::Zero(); // along the sides of a chart that is too large
  double covered_share = 0;     // the sum of the areas of the triangles, as a share of all pages
  double texels_per_length = 0; // texels along the side of a square whose area should be 1
  int number_of_turned = 0;     // charts for which all directions were tried
  int number_of_small = 0;      // charts for which places were not looked for where alike ones found none
  int number_of_enlarged =
      0; // charts that would be smaller than a sixteenth of a texel, and have that size now
  int number_of_attempts = 0; // scales that were tried
};

struct Packing_check
{
  enum Status
  {
    CERTIFIED,
    OUTSIDE,     // a triangle is not in its page, or too near to the border of the page
    SHARED_TEXEL // a triangle is too near to another chart
  };

  Status status = CERTIFIED;
  int triangle = -1; // the first that is wrong
};

inline std::string page_text(const Packing_options& options)
{
  return std::to_string(options.resolution) + " x " + std::to_string(options.number_of_rows()) + " texels";
}

// What follows the name of the chart
inline std::string too_large_text(const Packing& packing, const Packing_options& options)
{
  const int border = (in_blocks(options).number_of_gutter_texels() + 1) / 2 * options.block;
  std::ostringstream text;
  text << " takes " << std::ceil(packing.texels.x()) << " x " << std::ceil(packing.texels.y())
       << " texels, and a page has only " << page_text(options) << ", of which " << border
       << " stay free along each side";
  return text.str();
}

inline std::string too_many_pages_text(const Packing& packing, const Packing_options& options)
{
  std::ostringstream text;
  text << "the charts would take at least " << std::setprecision(15) << packing.number_of_pages
       << " pages of " << page_text(options) << ", and there are at most " << most_pages;
  return text.str();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACKING_H
