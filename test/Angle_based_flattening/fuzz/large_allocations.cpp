// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Before each factorization the solver allocates 150 MB, only to find out whether they are available. The address
// sanitizer takes milliseconds to mark them. The linker replaces malloc() and free() by these functions, which return
// an unusable address for such an allocation.

#include <cstddef>

extern "C" {

void* __real_malloc(std::size_t size);
void __real_free(void* memory);

static char nothing;

void* __wrap_malloc(std::size_t size)
{
  return size < 140000000 ? __real_malloc(size) : &nothing;
}

void __wrap_free(void* memory)
{
  if(memory != &nothing)
    __real_free(memory);
}

} // extern "C"
