// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_ATLAS_VISITOR_H
#define CGAL_TEXTURE_ATLAS_ATLAS_VISITOR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>

/// \file Atlas_visitor.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// Base class of visitors that follow `make_atlas()`, and may cancel it (`Atlas_options::visitor`).
///
/// \cgalModels{AtlasVisitor}
///
/// By default, its functions do nothing. One thread at a time calls them, but not always the same thread. If a function
/// returns `false`, the computation ends with `Diagnosis::CANCELLED`, and no property map is changed.
class Atlas_visitor
{
public:
  /// The stages, in their order. Each begins once.
  enum Stage
  {
    READ,    ///< Copying the mesh into arrays, and checking it.
    CHARTS,  ///< Finding seams, and flattening.
    PACK,    ///< Placing the charts in the square.
    CERTIFY, ///< Exact checks of the final coordinates.
    MEASURE, ///< Measuring distortion.
    WRITE    ///< Writing the caller's property maps.
  };

  virtual ~Atlas_visitor() {}

  /// is called when a stage begins. Returns whether to continue.
  virtual bool start(Stage) { return true; }

  /// is called repeatedly during `CHARTS`, with the estimated share of work done, from 0 to 1, which never decreases.
  /// Returns whether to continue.
  virtual bool progress(double) { return true; }
};

/// \ingroup PkgTextureAtlasRef
///
/// returns a name, such as `"WRITE"`.
///
/// \relates Atlas_visitor
inline const char* to_string(Atlas_visitor::Stage stage)
{
  constexpr const char* names[] = {"READ", "CHARTS", "PACK", "CERTIFY", "MEASURE", "WRITE"};
  return Surface_mesh_parameterization::internal::ABF::name_of(stage, names);
}

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_ATLAS_VISITOR_H
