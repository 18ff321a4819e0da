// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The arrays of SuperLU's factors, which one factorization after the other can fill. `SuperLU_factors.h` passes them to
// SuperLU.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ARRAYS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ARRAYS_H

#include <CGAL/Solver_interface/internal/Spare_objects.h>
#include <CGAL/Solver_interface/internal/SuperLU_headers.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

namespace CGAL {
namespace internal {
inline namespace CGAL_SUPERLU_TYPES {

// An array from SuperLU's allocator, because SuperLU may replace it by a larger one
template <class T>
class SuperLU_array
{
public:
  SuperLU_array() = default;
  SuperLU_array(const SuperLU_array&) = delete;
  SuperLU_array& operator=(const SuperLU_array&) = delete;
  ~SuperLU_array() { release(); }

  // Makes room for `size` entries; the old ones are lost.
  void reserve(std::size_t size)
  {
    if(size <= m_size)
      return;
    release();
    m_data = static_cast<T*>(superlu::superlu_malloc(size * sizeof(T)));
    if(m_data == nullptr)
      throw std::bad_alloc();
    m_size = size;
  }

  // Takes what SuperLU has put into the place of this array.
  void set(T* data, std::size_t size)
  {
    m_data = data;
    m_size = size;
  }

  T* data() const { return m_data; }
  std::size_t size() const { return m_size; }

private:
  void release()
  {
    if(m_data != nullptr)
      superlu::superlu_free(m_data);
    set(nullptr, 0);
  }

  T* m_data = nullptr;
  std::size_t m_size = 0;
};

// The lower factor
template <class FT>
struct SuperLU_lower_arrays
{
  SuperLU_array<int> supernode_of_column, first_column, row_begin, value_begin, row;
  SuperLU_array<FT> value;
  std::vector<int> row_permutation;

  void reserve(std::size_t columns, std::size_t rows, std::size_t values)
  {
    for(SuperLU_array<int>* array : {&supernode_of_column, &first_column, &row_begin, &value_begin})
      array->reserve(columns + 1);
    row.reserve(rows);
    value.reserve(values);
  }

  superlu::SCformat pass(superlu::GlobalLU_t& growing) const
  {
    growing.nzlmax = static_cast<int>(row.size());
    growing.nzlumax = static_cast<int>(value.size());
    return {0,
            0,
            value.data(),
            value_begin.data(),
            row.data(),
            row_begin.data(),
            supernode_of_column.data(),
            first_column.data()};
  }

  // Takes them back, or takes others that SuperLU has put into their place.
  void take(const superlu::GlobalLU_t& growing, std::size_t columns)
  {
    if(growing.xsup == nullptr)
      return;
    supernode_of_column.set(growing.supno, columns + 1);
    first_column.set(growing.xsup, columns + 1);
    row_begin.set(growing.xlsub, columns + 1);
    value_begin.set(growing.xlusup, columns + 1);
    row.set(growing.lsub, growing.nzlmax);
    value.set(static_cast<FT*>(growing.lusup), growing.nzlumax);
  }
};

// The upper factor, and what else only a factorization needs
template <class FT>
struct SuperLU_upper_arrays
{
  SuperLU_array<int> begin, row;
  SuperLU_array<FT> value;
  std::vector<int> column_begin, column_end, tree;

  void reserve(std::size_t columns, std::size_t values)
  {
    begin.reserve(columns + 1);
    row.reserve(values);
    value.reserve(values);
  }

  // Sets where the columns of a matrix are, in another order.
  void set_columns(const int* outer, const std::vector<int>& position)
  {
    column_begin.resize(position.size());
    column_end.resize(position.size());
    for(std::size_t j = 0; j < position.size(); ++j) {
      column_begin[position[j]] = outer[j];
      column_end[position[j]] = outer[j + 1];
    }
  }

  superlu::NCformat pass(superlu::GlobalLU_t& growing) const
  {
    growing.nzumax = static_cast<int>((std::min)(row.size(), value.size()));
    return {0, value.data(), row.data(), begin.data()};
  }

  void take(const superlu::GlobalLU_t& growing, std::size_t columns)
  {
    if(growing.xsup == nullptr)
      return;
    begin.set(growing.xusub, columns + 1);
    row.set(growing.usub, growing.nzumax);
    value.set(static_cast<FT*>(growing.ucol), growing.nzumax);
  }
};

// What factorizations have left for later ones, and vectors for solutions
template <class FT>
struct SuperLU_spare_memory
{
  Spare_objects<SuperLU_lower_arrays<FT>> lower;
  Spare_objects<SuperLU_upper_arrays<FT>> upper;
  Spare_objects<std::vector<FT>> vectors;
};

} // namespace CGAL_SUPERLU_TYPES
} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ARRAYS_H
