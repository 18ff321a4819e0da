// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/atlas/read_atlas_input_impl.h"
#include "flatten_mesh/model/read_model_impl.h"
#include "flatten_mesh/model/write_model_impl.h"
