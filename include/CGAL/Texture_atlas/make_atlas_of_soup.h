// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_MAKE_ATLAS_OF_SOUP_H
#define CGAL_TEXTURE_ATLAS_MAKE_ATLAS_OF_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/Soup_options.h>
#include <CGAL/Texture_atlas/Soup_report.h>
#include <CGAL/Texture_atlas/Surface_soup.h>

#include <utility>
#include <vector>

/// \file make_atlas_of_soup.h

namespace CGAL {

namespace Texture_atlas {

namespace internal::prepare {

// Makes one atlas of soups. If `is_common`, messages name them.
CGAL_ANGLE_BASED_FLATTENING_INLINE Soup_report make_atlas_of_soups(
    const std::vector<const Surface_soup*>& soups, bool is_common, const Soup_options& options,
    const Linear_solvers& solvers, std::vector<Soup_atlas>& atlases);

} // namespace internal::prepare

/*!
\ingroup PkgTextureAtlasRef

makes a texture atlas of points and polygons, which need not be a surface yet.

Points at the same place are joined; polygons are oriented alike, separated where more than two meet at an edge, and
divided into triangles, which seams do not divide. What cannot be part of a surface is left out, and reported in
`Soup_report::skipped`: polygons with fewer than three different corners, duplicates, and polygons at points that are
not finite or far away. `Soup_report::notes` tells what was changed. The rest is as of `make_atlas()` for meshes.

If there is no atlas (`Atlas_report::has_atlas()`), `atlas` is unchanged.

Memory that runs out is an exception, `std::bad_alloc`; exceptions of a visitor pass through. For \f$n\f$ corners,
preparing takes the time \cgalBigO{n \log n}.

\code{.cpp}
Soup_atlas atlas;
const Soup_report report = make_atlas(soup, atlas);
if(!report.has_atlas())
  std::cerr << report.message << "\n";
\endcode

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param soup points and polygons
\param atlas receives the coordinates and charts
\param options the options
\param np optional: `sparse_linear_solver` and `visitor`, as of `make_atlas()` for meshes

\return the charts, and what is wrong, if anything. Arrays that do not fit together are `Diagnosis::WRONG_INPUT` or
        `Diagnosis::NUMBER_OUT_OF_RANGE`; no points or polygons are `Diagnosis::EMPTY_MESH`.
*/
template <typename NamedParameters = parameters::Default_named_parameters>
Soup_report make_atlas(const Surface_soup& soup, Soup_atlas& atlas, Soup_options options = Soup_options(),
                       const NamedParameters& np = parameters::default_values())
{
  internal::Visitor_parameter<Atlas_visitor, NamedParameters> visitor(np);
  options.visitor = visitor.pointer(options.visitor);
  std::vector<Soup_atlas> atlases;
  Soup_report report =
      internal::prepare::make_atlas_of_soups({&soup}, false, options, internal::linear_solvers(np), atlases);
  if(report.has_atlas()) {
    atlas = std::move(atlases.front());
  }
  return report;
}

/// \ingroup PkgTextureAtlasRef
///
/// makes an atlas as above, with the default options.
template <typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Soup_report make_atlas(const Surface_soup& soup, Soup_atlas& atlas, const CGAL_NP_CLASS& np)
{
  return make_atlas(soup, atlas, Soup_options(), np);
}

/*!
\ingroup PkgTextureAtlasRef

makes one texture atlas of several soups, with the same texel density, as `make_atlas()` does of one.

Soups that touch are not joined. Charts are numbered through, those of the first soup first.
`Atlas_report::Chart::mesh`, `Atlas_report::Skipped::mesh` and `Soup_report::offending_soup` are numbers of soups.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param soups points and polygons
\param atlases receives an atlas for each soup
\param options the options
\param np optional: `sparse_linear_solver` and `visitor`, as of `make_atlas()` for meshes

\return the charts, and what is wrong, if anything
*/
template <typename NamedParameters = parameters::Default_named_parameters>
Soup_report make_common_atlas(const std::vector<Surface_soup>& soups, std::vector<Soup_atlas>& atlases,
                              Soup_options options = Soup_options(),
                              const NamedParameters& np = parameters::default_values())
{
  internal::Visitor_parameter<Atlas_visitor, NamedParameters> visitor(np);
  options.visitor = visitor.pointer(options.visitor);
  std::vector<const Surface_soup*> pointers;
  for(const Surface_soup& soup : soups) {
    pointers.push_back(&soup);
  }
  return internal::prepare::make_atlas_of_soups(pointers, true, options, internal::linear_solvers(np),
                                                atlases);
}

/// \ingroup PkgTextureAtlasRef
///
/// makes one atlas of several soups as above, with the default options.
template <typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Soup_report make_common_atlas(const std::vector<Surface_soup>& soups, std::vector<Soup_atlas>& atlases,
                              const CGAL_NP_CLASS& np)
{
  return make_common_atlas(soups, atlases, Soup_options(), np);
}

} // namespace Texture_atlas

} // namespace CGAL

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/prepare/soup_atlas_impl.h>
#endif

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_MAKE_ATLAS_OF_SOUP_H
