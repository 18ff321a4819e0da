// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SHARED_UV_H
#define FLATTEN_MESH_SHARED_UV_H

#include "flatten_mesh/model/Model.h"

#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <cstddef>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// Formats have coordinates for all corners of a face, or for none.
inline bool has_uv_everywhere(const Model& model, const Model_texture& texture, const Index polygon)
{
  for(Index c = model.first_corners[polygon]; c < model.first_corners[polygon + 1]; ++c) {
    if(!texture.has_uv(c)) {
      return false;
    }
  }
  return true;
}

namespace internal {

// The different texture coordinates of a model. Corners at the same point in the same chart share theirs if they are
// equal.
class Shared_uv
{
public:
  Shared_uv(const Model& model, const Model_texture& texture)
      : m_numbers(model.number_of_corners(), no_index), m_first(model.points.size(), no_index)
  {
    for(std::size_t p = 0; p < model.number_of_polygons(); ++p) {
      const auto polygon = static_cast<Index>(p);
      for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
        if(texture.has_uv(c)) {
          m_numbers[c] =
              number_of({texture.uv[c], texture.chart(polygon), no_index}, m_first[model.vertices[c]]);
        }
      }
    }
  }

  std::size_t size() const { return m_places.size(); }
  const Kernel::Point_2& operator[](const std::size_t number) const { return m_places[number].uv; }

  // Of a corner, from 0, or `no_index`
  Index number(const Index corner) const { return m_numbers[corner]; }

private:
  struct Place
  {
    Kernel::Point_2 uv;
    Index chart;
    Index next; // of the same point
  };

  Index number_of(Place place, Index& first)
  {
    for(Index i = first; i != no_index; i = m_places[i].next) {
      if(m_places[i].chart == place.chart && m_places[i].uv == place.uv) {
        return i;
      }
    }
    place.next = first;
    first = static_cast<Index>(m_places.size());
    m_places.push_back(place);
    return first;
  }

  std::vector<Index> m_numbers; // of each corner
  std::vector<Index> m_first;   // of each point: its last place so far
  std::vector<Place> m_places;
};

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SHARED_UV_H
