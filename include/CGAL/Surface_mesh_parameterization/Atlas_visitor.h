// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_VISITOR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_VISITOR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>

/// \file Atlas_visitor.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// A base class of visitors that follow `make_atlas()`, and may stop it (`Atlas_options::visitor`). By default its
/// functions do nothing. They are called by one thread at a time, but not always by the same. A function that returns
/// `false` stops the computation, whose report then has the diagnosis `Diagnosis::CANCELLED`. All maps of the caller
/// are unchanged then.
class Atlas_visitor
{
public:
  /// The stage that begins. They come in this order, each once.
  enum Stage
  {
    READ,    ///< Copying the mesh into arrays, and checking it.
    CHARTS,  ///< Seams and maps.
    PACK,    ///< Placing the charts in the square.
    CERTIFY, ///< Exact checks of the final coordinates.
    MEASURE, ///< Measuring distortion.
    WRITE    ///< Writing the caller's property maps.
  };

  virtual ~Atlas_visitor() {}

  /// is called at the beginning of a stage. Returns whether to continue.
  virtual bool start(Stage) { return true; }

  /// is called during `CHARTS` again and again, with an estimate of the share of the work that is done, from 0 to 1, which never
  /// falls. Returns whether to continue.
  virtual bool progress(double) { return true; }
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_VISITOR_H
