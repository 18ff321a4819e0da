// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Places all charts at one scale, the largest first, each where a rule finds it lowest.
// `search_scale.h` tries scales and rules with it, `fill_pages.h` fills one page after the other, and `pack_impl.h`
// reads the places.
//
// The cells of a page that are taken, and a fast search for the lowest place where a mask is free of them.
// `place_charts.h` places one chart after the other with it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PLACE_CHARTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PLACE_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/packing/chart_shape.h>
#include <CGAL/Texture_atlas/internal/packing/charts_to_pack.h>
#include <CGAL/Texture_atlas/internal/packing/scaled_charts.h>
#include <CGAL/Texture_atlas/internal/packing/texel_mask.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The cells of a page that charts occupy, and the search for places that are free
class Occupied_cells
{
  typedef Texel_mask::Word Word;
  static constexpr int word_size = Texel_mask::word_size;

public:
  // `margin` are the cells around the page that masks of `add()` may reach.
  Occupied_cells(int width, int height, int margin)
      : m_width(width), m_height(height), m_margin(margin), m_cells(width + 2 * margin, height + 2 * margin),
        m_longest_free_run(static_cast<std::size_t>(height) + 2 * margin, width + 2 * margin)
  {}

  // At least those of the page that are free
  std::size_t number_of_free_cells() const
  {
    return static_cast<std::size_t>(m_cells.width()) * m_cells.height() - m_cells.number_of_texels();
  }

  // Adds a mask that is larger by the margin on all sides than the one at (x, y).
  void add(const Texel_mask& mask, int x, int y)
  {
    m_cells.add(mask, x, y);
    for(int row = y; row < y + mask.height(); ++row)
      m_longest_free_run[row] = m_cells.longest_run(row, true, m_longest_free_run[row]);
  }

  // The first place for the lower left corner of a mask, by rows from `first_row` to `last_row`, and in them from the
  // left. `runs` are of rows of the mask, the longest first.
  //
  // A cell of the mask that meets an occupied one rules out 64 places at a time. Those cells that did so before come
  // first: they leave few places for which the whole mask is compared.
  std::optional<Texel> find_place(const Texel_mask& mask, const std::vector<Row_run>& runs, int first_row,
                                  int last_row)
  {
    const int places = m_width - mask.width() + 1;
    if(places < 1)
      return std::nullopt;
    m_free.resize((places + word_size - 1) / word_size);
    m_witnesses.clear();
    last_row = (std::min)(last_row, m_height - mask.height());
    for(int y = first_row; (y = next_wide_row(runs, y, last_row)) <= last_row; ++y) {
      std::fill(m_free.begin(), m_free.end(), ~Word(0));
      if(places % word_size != 0)
        m_free.back() >>= word_size - places % word_size;
      for(std::size_t i = 0; i < m_witnesses.size(); ++i)
        if(!rule_out(m_free, m_witnesses[i], y)) {
          std::rotate(m_witnesses.begin() + i / 2, m_witnesses.begin() + i, m_witnesses.begin() + i + 1);
          break;
        }
      for(int x; (x = first_of(m_free)) >= 0;) {
        const std::optional<Texel> witness = collision(mask, x, y);
        if(!witness)
          return Texel{x, y};
        m_witnesses.insert(m_witnesses.begin(), *witness);
        rule_out(m_free, *witness, y);
      }
    }
    return std::nullopt;
  }

private:
  // The first row from y on where no row of the mask is wider than all that is free there, or one behind `last_row`
  int next_wide_row(const std::vector<Row_run>& runs, int y, int last_row) const
  {
    const int longest = runs.front().length;
    const int* free_run = m_longest_free_run.data() + m_margin;
    const int* free_of_longest = free_run + runs.front().y;
    for(;; ++y) {
      while(y <= last_row && free_of_longest[y] < longest)
        ++y;
      if(y > last_row || std::none_of(runs.begin() + 1, runs.end(),
                                      [&](const Row_run& run) { return free_run[y + run.y] < run.length; }))
        return y;
    }
  }

  // Takes out the places where a cell of the mask would be on an occupied one. Returns whether some are left.
  bool rule_out(std::vector<Word>& free, const Texel& cell, int y) const
  {
    const unsigned x = static_cast<unsigned>(cell.x + m_margin), shift = x % word_size;
    const Word* words = m_cells.row(y + m_margin + cell.y) + x / word_size;
    Word left = 0;
    for(Word& places : free) {
      places &= ~(words[0] >> shift | words[1] << 1 << (word_size - 1 - shift));
      left |= places;
      ++words;
    }
    return left != 0;
  }

  static int first_of(const std::vector<Word>& words)
  {
    for(std::size_t i = 0; i < words.size(); ++i)
      if(words[i] != 0)
        return static_cast<int>(i) * word_size + Texel_mask::lowest_bit(words[i]);
    return -1;
  }

  // A cell of the mask at (x, y) that is on an occupied one. What is occupied is large mostly: every eighth row comes
  // first.
  std::optional<Texel> collision(const Texel_mask& mask, int x, int y) const
  {
    const unsigned left = static_cast<unsigned>(x + m_margin), shift = left % word_size;
    const int words = mask.words_of_row();
    for(const int first : {0, 4, 2, 6, 1, 5, 3, 7})
      for(int j = first; j < mask.height(); j += 8) {
        const Word *row = m_cells.row(y + m_margin + j) + left / word_size, *cells = mask.row(j);
        for(int i = 0; i < words; ++i)
          if(const Word both = cells[i] & (row[i] >> shift | row[i + 1] << 1 << (word_size - 1 - shift));
             both != 0)
            return Texel{i * word_size + Texel_mask::lowest_bit(both), j};
      }
    return std::nullopt;
  }

  int m_width, m_height, m_margin;
  Texel_mask m_cells;
  std::vector<int> m_longest_free_run; // of each row
  std::vector<Word> m_free;            // places in the row of the search
  std::vector<Texel> m_witnesses;      // of the search
};

struct Chart_place
{
  int direction = 0;
  int page = 0;
  double cosine = 1, sine = 0;               // times the scale, in texels
  Planar_point shift = Planar_point::Zero(); // in texels
};

// Places that are best by one rule need not leave good ones for the next charts: different rules are tried.
struct Placement_rule
{
  double height_weight = 1; // The row of the lower end counts, and the height times this number.
  int first_direction = -1; // that the largest chart has to take, or -1
};

// The more charts, the fewer rules
inline std::vector<Placement_rule> placement_rules(const Charts_to_pack& charts)
{
  const double height_weights[] = {1, 0.5, 1.5, 0};
  int directions = 0, most = 0;
  for(int c = 0; c < charts.number_of_charts(); ++c) {
    const int number = static_cast<int>(charts.directions(c).size());
    directions += number;
    most = (std::max)(most, 4 * (1 + number));
  }
  std::vector<Placement_rule> result;
  const int tries = 1 << 15, many_directions = 1 << 13, least = directions > many_directions ? 4 : 10;
  const int number =
      charts.number_of_charts() == 1 ? 1 : (std::min)(most, (std::max)(least, tries / directions));
  for(int i = 0; i < number; ++i)
    result.push_back({height_weights[i % 4], i / 4 - 1});
  return result;
}

// Places charts of one scale, the largest first, each where it is lowest.
class Chart_placer
{
public:
  Chart_placer(const Scaled_charts& scaled, const Placement_rule& rule)
      : m_scaled(scaled), m_rule(rule), m_gutter(scaled.charts().options().number_of_gutter_texels()),
        m_border((m_gutter + 1) / 2), m_cell(scaled.texels_of_cell()),
        m_margin((m_gutter + m_cell - 1) / m_cell),
        m_occupied((std::max)(0, scaled.charts().options().resolution - 2 * m_border) / m_cell,
                   (std::max)(0, scaled.charts().options().number_of_rows() - 2 * m_border) / m_cell,
                   m_margin)
  {}

  // All charts on one page, if it holds them
  std::optional<std::vector<Chart_place>> run()
  {
    std::vector<Chart_place> places(static_cast<std::size_t>(m_scaled.charts().number_of_charts()));
    for(int c : m_scaled.largest_first())
      if(const std::optional<Chart_place> found = place(c))
        places[c] = *found;
      else
        return std::nullopt;
    return places;
  }

  // The place that a chart takes, if there is one
  std::optional<Chart_place> place(int c)
  {
    Deadline::ask();
    const double texels = m_scaled.needed_texels(c);
    if(!m_scaled.charts().is_small(c) || texels < alike * m_texels_at_first_row) {
      m_texels_at_first_row = texels;
      m_first_row = 0;
    }
    const bool is_first = c == m_scaled.largest_first().front();
    Choice best;
    for(int i = 0; i < m_scaled.number_of_directions(c); ++i)
      if(!is_first || m_rule.first_direction < 0 || i == m_rule.first_direction)
        look_for_better(c, i, best);
    if(best.direction < 0)
      return std::nullopt;
    m_first_row = best.place.y;
    return occupy(c, best.direction, best.place);
  }

  // At least those of the page that are free
  std::size_t number_of_free_cells() const { return m_occupied.number_of_free_cells(); }

private:
  struct Choice
  {
    int direction = -1;
    Texel place{0, 0};
    double height = std::numeric_limits<double>::infinity();
  };

  void look_for_better(int c, int direction, Choice& best)
  {
    if(!m_scaled.shape(c, direction))
      return;
    const Scaled_charts::Shape& shape = *m_scaled.shape(c, direction);
    const double height = m_rule.height_weight * shape.cells.height();
    const int last_row =
        static_cast<int>((std::min)(std::floor(best.height - height), double(largest_resolution)));
    const std::optional<Texel> place = m_occupied.find_place(shape.cells, shape.runs, m_first_row, last_row);
    if(place && (place->y + height < best.height || place->x < best.place.x))
      best = {direction, *place, place->y + height};
  }

  // With the gutter
  Chart_place occupy(int c, int direction, const Texel& at)
  {
    const Scaled_charts::Shape& scaled = *m_scaled.shape(c, direction);
    const Chart_shape& shape = scaled.texels;
    m_occupied.add(scaled.cells_with_gutter(m_gutter, m_margin), at.x, at.y);
    Chart_place result;
    result.direction = direction;
    result.cosine = shape.cosine();
    result.sine = shape.sine();
    result.shift = shape.shift() + Planar_point(m_border + m_cell * at.x, m_border + m_cell * at.y);
    return result;
  }

  const Scaled_charts& m_scaled;
  const Placement_rule m_rule;
  const int m_gutter, m_border; // texels between charts, and between them and the border of the page
  const int m_cell;             // texels along the side of a cell
  const int m_margin;           // cells that the gutter may stick out
  Occupied_cells m_occupied;
  double m_texels_at_first_row = 0; // that the chart needed which was tried from the first row on
  int m_first_row = 0;              // where the next alike is tried
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PLACE_CHARTS_H
