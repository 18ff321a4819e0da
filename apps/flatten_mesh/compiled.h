// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_COMPILED_H
#define FLATTEN_MESH_COMPILED_H

// Parts of the program that several others use are compiled once, in files of their own. Tests and tools of the
// documentation use their headers alone.
#ifdef FLATTEN_MESH_COMPILED
#define FLATTEN_MESH_INLINE
#else
#define FLATTEN_MESH_INLINE inline
#endif

#endif // FLATTEN_MESH_COMPILED_H
