// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_DRAWING_H
#define PICTURES_DRAWING_H

#include <cairo-svg.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace pictures {

// Red, green and blue, from 0 to 1.
using Color = std::array<double, 3>;

inline Color mix(const Color& a, const Color& b, const double part)
{
  return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
}

// The colours of a picture, row by row: one byte each for red, green and blue, from the third byte down
struct Pixels
{
  int width, height;
  std::vector<std::uint32_t> colors;
};

// A drawing by Cairo, as the content of an SVG or PNG file. Places are in pixels from the upper left corner.
class Drawing
{
public:
  enum Format
  {
    SVG,
    PNG
  };

  Drawing(const Format format, const double width, const double height)
      : m_format(format),
        m_surface(format == SVG ? cairo_svg_surface_create_for_stream(append, &m_file, width, height)
                                : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                                             static_cast<int>(height)),
                  cairo_surface_destroy),
        m_cairo(cairo_create(m_surface.get()), cairo_destroy)
  {
    if(format == PNG) {
      cairo_set_source_rgb(m_cairo.get(), 1, 1, 1);
      cairo_paint(m_cairo.get());
    }
    cairo_set_line_join(m_cairo.get(), CAIRO_LINE_JOIN_BEVEL);
    cairo_set_line_cap(m_cairo.get(), CAIRO_LINE_CAP_ROUND);
    cairo_select_font_face(m_cairo.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  }

  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  // Paths
  void move_to(const double x, const double y) { cairo_move_to(m_cairo.get(), x, y); }
  void line_to(const double x, const double y) { cairo_line_to(m_cairo.get(), x, y); }
  void close() { cairo_close_path(m_cairo.get()); }
  void rectangle(const double left, const double top, const double width, const double height)
  {
    cairo_rectangle(m_cairo.get(), left, top, width, height);
  }

  void end_path() { cairo_new_path(m_cairo.get()); }

  // Fills what the path winds around, and keeps it for `stroke()`.
  void fill(const Color& color)
  {
    set_color(color);
    cairo_fill_preserve(m_cairo.get());
  }

  // Draws the path, which then ends.
  void stroke(const Color& color, const double width)
  {
    set_color(color);
    cairo_set_line_width(m_cairo.get(), width);
    cairo_stroke(m_cairo.get());
  }

  // Writes a line. `part` of its width is on the left of the place, which is on the base line.
  void write(const double x, const double y, const double size, const std::string& text, const Color& color,
             const double part = 0)
  {
    cairo_set_font_size(m_cairo.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(m_cairo.get(), text.c_str(), &extents);
    set_color(color);
    move_to(x - part * extents.x_advance, y);
    cairo_show_text(m_cairo.get(), text.c_str());
    end_path();
  }

  void paste(Pixels pixels, const double left, const double top)
  {
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> part(
        cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.colors.data()),
                                            CAIRO_FORMAT_RGB24, pixels.width, pixels.height,
                                            4 * pixels.width),
        cairo_surface_destroy);
    cairo_set_source_surface(m_cairo.get(), part.get(), left, top);
    cairo_paint(m_cairo.get());
  }

  // Nothing can be drawn any more.
  std::string file()
  {
    check(cairo_status(m_cairo.get()));
    m_cairo.reset();
    if(m_format == PNG) {
      check(cairo_surface_write_to_png_stream(m_surface.get(), append, &m_file));
    }
    cairo_surface_finish(m_surface.get());
    check(cairo_surface_status(m_surface.get()));
    return m_file;
  }

private:
  static cairo_status_t append(void* file, const unsigned char* data, const unsigned size)
  {
    static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  }

  static void check(const cairo_status_t status)
  {
    if(status == CAIRO_STATUS_NO_MEMORY) {
      throw std::bad_alloc();
    }
    if(status != CAIRO_STATUS_SUCCESS) {
      throw std::runtime_error(std::string("Cairo: ") + cairo_status_to_string(status));
    }
  }

  void set_color(const Color& color) { cairo_set_source_rgb(m_cairo.get(), color[0], color[1], color[2]); }

  Format m_format;
  std::string m_file;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> m_surface;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> m_cairo;
};

inline std::string png_file(const Pixels& pixels)
{
  Drawing drawing(Drawing::PNG, pixels.width, pixels.height);
  drawing.paste(pixels, 0, 0);
  return drawing.file();
}

} // namespace pictures

#endif // PICTURES_DRAWING_H
