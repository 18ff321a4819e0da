// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_OVERLAPPING_CHARTS_H
#define ANGLE_BASED_FLATTENING_OVERLAPPING_CHARTS_H

#include "hard_charts.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// Disks that wind in the plane, or that overlap themselves when they are unrolled. What counts are their lengths: in
// space, too, some of them pass through themselves.
namespace test_charts {

// A strip of unit squares, each of `cells` by `cells` quadrangles: one square, and then one for each of `turns`. These
// lead through the left side (1), the far side (0) or the right side (-1) of the square before. Squares that come to
// lie at the same place stay apart.
class Strip_of_squares
{
public:
  Strip_of_squares(const std::vector<int>& turns, int cells) : m_cells(cells)
  {
    for(int i = 0; i <= cells; ++i)
      m_entry.push_back(add_point(i, 0));
    for(int turn : turns) {
      const std::vector<int> vertices = add_square();
      leave(vertices, turn);
    }
    add_square();
  }

  // With hills of that height
  Chart chart(double hills = 0) const
  {
    std::vector<Point_3> points;
    for(const Point_3& p : m_points)
      points.emplace_back(p.x(), p.y(), hills * std::sin(2 * p.x()) * std::cos(3 * p.y()));
    return make_chart(points, m_triangles);
  }

private:
  // `right` and `ahead` count from the left end of the side through which one enters.
  int add_point(int right, int ahead)
  {
    const double u = double(right) / m_cells, v = double(ahead) / m_cells;
    m_points.emplace_back(m_x + u * m_dy + v * m_dx, m_y - u * m_dx + v * m_dy, 0);
    return static_cast<int>(m_points.size()) - 1;
  }

  // Returns its vertices, row by row.
  std::vector<int> add_square()
  {
    std::vector<int> vertices = m_entry;
    for(int j = 1; j <= m_cells; ++j)
      for(int i = 0; i <= m_cells; ++i)
        vertices.push_back(add_point(i, j));
    const int row = m_cells + 1;
    for(int j = 0; j < m_cells; ++j)
      for(int i = 0; i < m_cells; ++i) {
        const int k = j * row + i;
        const int a = vertices[k], b = vertices[k + 1], c = vertices[k + row + 1], d = vertices[k + row];
        if((i + j) % 2 == 0)
          m_triangles.insert(m_triangles.end(), {{a, b, c}, {a, c, d}});
        else
          m_triangles.insert(m_triangles.end(), {{a, b, d}, {b, c, d}});
      }
    return vertices;
  }

  // The next square begins at the left end of the side through which the strip leaves this one.
  void leave(const std::vector<int>& vertices, int turn)
  {
    const int n = m_cells, row = n + 1;
    for(int i = 0; i <= n; ++i)
      m_entry[i] = vertices[turn > 0 ? i * row : turn < 0 ? (n - i) * row + n : n * row + i];
    if(turn <= 0) {
      m_x += m_dx;
      m_y += m_dy;
    }
    if(turn < 0) {
      m_x += m_dy;
      m_y -= m_dx;
    }
    const int dx = m_dx;
    if(turn != 0) {
      m_dx = -turn * m_dy;
      m_dy = turn * dx;
    }
  }

  int m_cells;
  int m_x = 0, m_y = 0, m_dx = 0, m_dy = 1; // the left end of the side at hand, and the direction
  std::vector<int> m_entry;                 // the vertices of that side, from left to right
  std::vector<Point_3> m_points;
  Triangles m_triangles;
};

// Draws a Hilbert curve: A -> +BF-AFA-FB+ and B -> -AF+BFB+FA-. Every F is two squares long, so that the strip leaves
// gaps as wide as itself.
inline void add_hilbert_turns(int order, int sign, int& turn, std::vector<int>& turns)
{
  if(order == 0)
    return;
  const auto step = [&] {
    turns.push_back(turn);
    turns.push_back(0);
    turn = 0;
  };
  turn += sign;
  add_hilbert_turns(order - 1, -sign, turn, turns);
  step();
  turn -= sign;
  add_hilbert_turns(order - 1, sign, turn, turns);
  step();
  add_hilbert_turns(order - 1, sign, turn, turns);
  turn -= sign;
  step();
  add_hilbert_turns(order - 1, -sign, turn, turns);
  turn += sign;
}

// In the plane, without overlaps
inline Chart hilbert_strip(int order, int cells, double hills = 0)
{
  std::vector<int> turns;
  int turn = 0;
  add_hilbert_turns(order, 1, turn, turns);
  return Strip_of_squares(turns, cells).chart(hills);
}

// A Hilbert curve that turns elsewhere than it should, and therefore runs into itself
inline Chart broken_hilbert_strip(int order, int cells, int mistakes, std::mt19937& random)
{
  std::vector<int> turns;
  int turn = 0;
  add_hilbert_turns(order, 1, turn, turns);
  for(int i = 0; i < mistakes; ++i)
    turns[uniform_int(random, 0, static_cast<int>(turns.size()) - 1)] = uniform_int(random, -1, 1);
  return Strip_of_squares(turns, cells).chart();
}

inline Chart random_strip(int squares, int cells, std::mt19937& random)
{
  std::vector<int> turns;
  for(int i = 1; i < squares; ++i)
    turns.push_back(uniform_int(random, -1, 1));
  return Strip_of_squares(turns, cells).chart();
}

// Goes around a square `rounds` times, over itself.
inline Chart winding_strip(int rounds, int side, int cells)
{
  std::vector<int> turns;
  for(int i = 0; i < 4 * rounds * side; ++i)
    turns.push_back(i % side == 0 ? 1 : 0);
  return Strip_of_squares(turns, cells).chart();
}

// Goes around a square `rounds` times, outward, with gaps as wide as itself.
inline Chart square_spiral(int rounds, int cells)
{
  std::vector<int> turns;
  for(int i = 2; i < 4 * rounds + 2; ++i) {
    turns.push_back(1);
    turns.insert(turns.end(), static_cast<std::size_t>(i / 2 * 2 - 1), 0);
  }
  return Strip_of_squares(turns, cells).chart();
}

// A sector of a ring that takes `turns` full turns, as a spiral staircase with steps of height `rise`, or flat. Its
// radius grows by `growth` in each turn.
inline Chart staircase(int columns, int rows, double turns, double rise, double growth = 0)
{
  return patch(columns, rows, [=](int i, int j) {
    const double turn = turns * i / columns, angle = -2 * CGAL_PI * turn;
    const double radius = 1 + double(j) / rows + growth * turn;
    return Point_3(radius * std::cos(angle), radius * std::sin(angle), rise * turn);
  });
}

// The same on a logarithmic spiral: all of it becomes smaller by `factor` in each turn. Its width is that of a turn
// times `width`, so that it overlaps itself above 1.
inline Chart logarithmic_spiral(int columns, int rows, double turns, double factor, double width)
{
  return patch(columns, rows, [=](int i, int j) {
    const double turn = turns * i / columns, angle = -2 * CGAL_PI * turn;
    const double radius = std::pow(factor, width * j / rows - turn);
    return Point_3(radius * std::cos(angle), radius * std::sin(angle), 0);
  });
}

// A tube with one open and one closed end. Its conformal map enlarges the open end about exp(length / radius) times as
// much as the closed one.
inline Chart finger(int columns, int rows, double length)
{
  std::vector<Point_3> points{Point_3(0, 0, 0)};
  Triangles triangles;
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i < columns; ++i) {
      const double angle = 2 * CGAL_PI * (i + 0.5 * j) / columns;
      points.emplace_back(std::cos(angle), std::sin(angle), length * j / rows);
      const int a = 1 + columns * j + i, b = 1 + columns * j + (i + 1) % columns;
      if(j == 0)
        triangles.push_back({0, a, b});
      else {
        triangles.push_back({a - columns, a, b - columns});
        triangles.push_back({b - columns, a, b});
      }
    }
  return make_chart(points, triangles);
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_OVERLAPPING_CHARTS_H
