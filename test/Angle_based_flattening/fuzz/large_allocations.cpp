// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The solver allocates 150 MB before each factorization, only to know that they are there, and the address sanitizer takes
// milliseconds to mark them. The linker puts these functions in the place of malloc() and free(): such an allocation
// gets an address that nobody may use.

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
