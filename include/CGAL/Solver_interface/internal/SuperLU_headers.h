// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// SuperLU's C headers inside the namespace `CGAL::internal::superlu`, so that their macros and names do not reach the
// programs that include the traits. `SuperLU_library.h` includes it. No other header includes SuperLU's.
//
// The limits:
// - Types, enumerators (NO, ROW, TRANS, FACT, ...) and functions are visible in that namespace only.
// - A macro of the user with the name of one of the macros and enumerators below has its own value again afterwards,
//   and these macros of SuperLU are gone. Others remain, which no other program is likely to have.
// - The Fortran routines of the BLAS that SuperLU declares are declared under other names here, so that they do not
//   conflict with other prototypes (in LAPACKE, CHOLMOD, Eigen, ...).
// - A file that also includes SuperLU itself, or `<Eigen/SuperLUSupport>`, has to do so *before* this file, and both
// then use the types in the global namespace. In the other order the compiler reports that declarations of C
// functions contradict: a C function has one signature in a program, and it would mention two sets of types. What is
// made of the types has another name in such a file (`CGAL_SUPERLU_TYPES` is an inline namespace), so that the linker
// does not take one for the other.
// - SuperLU_DIST and SuperLU_MT reuse the names of these headers for other contents. They cannot be used in the same
//   file.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_HEADERS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_HEADERS_H

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

#define CGAL_SUPERLU_PRAGMA(pragma) _Pragma(#pragma)
#define CGAL_SUPERLU_PUSH(macro) CGAL_SUPERLU_PRAGMA(push_macro(#macro))
#define CGAL_SUPERLU_POP(macro) CGAL_SUPERLU_PRAGMA(pop_macro(#macro))

// clang-format off
// Let the headers be read although somebody may have read them in the global namespace. The types are shared with that
// namespace then.
CGAL_SUPERLU_PUSH(__SUPERLU_dSP_DEFS) CGAL_SUPERLU_PUSH(__SUPERLU_sSP_DEFS)
#undef __SUPERLU_dSP_DEFS
#undef __SUPERLU_sSP_DEFS
#ifdef __SUPERLU_UTIL
#define CGAL_SUPERLU_TYPES global_superlu_types
#else
#define CGAL_SUPERLU_TYPES hidden_superlu_types
#define CGAL_SUPERLU_TYPES_ARE_HIDDEN
#endif

CGAL_SUPERLU_PUSH(EMPTY) CGAL_SUPERLU_PUSH(TRUE) CGAL_SUPERLU_PUSH(FALSE) CGAL_SUPERLU_PUSH(NO_MARKER)
CGAL_SUPERLU_PUSH(ABORT) CGAL_SUPERLU_PUSH(CHECK_MALLOC) CGAL_SUPERLU_PUSH(ADD_) CGAL_SUPERLU_PUSH(ADD__)
CGAL_SUPERLU_PUSH(NOCHANGE) CGAL_SUPERLU_PUSH(UPCASE) CGAL_SUPERLU_PUSH(NO) CGAL_SUPERLU_PUSH(YES)
CGAL_SUPERLU_PUSH(ROW) CGAL_SUPERLU_PUSH(COL) CGAL_SUPERLU_PUSH(BOTH) CGAL_SUPERLU_PUSH(TRANS)
CGAL_SUPERLU_PUSH(NOTRANS) CGAL_SUPERLU_PUSH(CONJ) CGAL_SUPERLU_PUSH(FACT) CGAL_SUPERLU_PUSH(SOLVE)
CGAL_SUPERLU_PUSH(REFINE) CGAL_SUPERLU_PUSH(HEAD) CGAL_SUPERLU_PUSH(TAIL) CGAL_SUPERLU_PUSH(SYSTEM)
CGAL_SUPERLU_PUSH(USER) CGAL_SUPERLU_PUSH(NATURAL) CGAL_SUPERLU_PUSH(COMM) CGAL_SUPERLU_PUSH(DIST)
CGAL_SUPERLU_PUSH(EQUIL) CGAL_SUPERLU_PUSH(RELAX)
#undef EMPTY
#undef TRUE
#undef FALSE
#undef NO_MARKER
#undef ABORT
#undef CHECK_MALLOC
#undef ADD_
#undef ADD__
#undef NOCHANGE
#undef UPCASE
#undef NO
#undef YES
#undef ROW
#undef COL
#undef BOTH
#undef TRANS
#undef NOTRANS
#undef CONJ
#undef FACT
#undef SOLVE
#undef REFINE
#undef HEAD
#undef TAIL
#undef SYSTEM
#undef USER
#undef NATURAL
#undef COMM
#undef DIST
#undef EQUIL
#undef RELAX

// Other prototypes of these may be there, as Eigen has some.
CGAL_SUPERLU_PUSH(dgemm_) CGAL_SUPERLU_PUSH(dtrsv_) CGAL_SUPERLU_PUSH(dtrsm_) CGAL_SUPERLU_PUSH(dgemv_)
CGAL_SUPERLU_PUSH(sgemm_) CGAL_SUPERLU_PUSH(strsv_) CGAL_SUPERLU_PUSH(strsm_) CGAL_SUPERLU_PUSH(sgemv_)
CGAL_SUPERLU_PUSH(xerbla_) CGAL_SUPERLU_PUSH(dgsisx) CGAL_SUPERLU_PUSH(sgsisx)
#undef dgemm_
#define dgemm_ cgal_unused_dgemm_
#undef dtrsv_
#define dtrsv_ cgal_unused_dtrsv_
#undef dtrsm_
#define dtrsm_ cgal_unused_dtrsm_
#undef dgemv_
#define dgemv_ cgal_unused_dgemv_
#undef sgemm_
#define sgemm_ cgal_unused_sgemm_
#undef strsv_
#define strsv_ cgal_unused_strsv_
#undef strsm_
#define strsm_ cgal_unused_strsm_
#undef sgemv_
#define sgemv_ cgal_unused_sgemv_
#undef xerbla_
#define xerbla_ cgal_unused_xerbla_
#undef dgsisx
#define dgsisx cgal_unused_dgsisx
#undef sgsisx
#define sgsisx cgal_unused_sgsisx

namespace CGAL {
namespace internal {
namespace superlu {

#if __has_include(<superlu/slu_ddefs.h>)
#include <superlu/slu_ddefs.h>
#else
#include <slu_ddefs.h>
#endif

// (SuperLU may have been built without single precision, and then has no such header)
#if __has_include(<superlu/slu_sdefs.h>)
#include <superlu/slu_sdefs.h>
#define CGAL_SUPERLU_HAS_SINGLE_PRECISION
#elif __has_include(<slu_sdefs.h>)
#include <slu_sdefs.h>
#define CGAL_SUPERLU_HAS_SINGLE_PRECISION
#endif

#ifndef CGAL_SUPERLU_TYPES_ARE_HIDDEN
using ::SuperMatrix; using ::NCformat; using ::NCPformat; using ::SCformat; using ::DNformat; using ::superlu_options_t;
using ::SuperLUStat_t; using ::GlobalLU_t; using ::SLU_NC; using ::SLU_NCP; using ::SLU_SC; using ::SLU_DN;
using ::Dtype_t; using ::SLU_S; using ::SLU_D; using ::SLU_GE; using ::SLU_TRLU; using ::SLU_TRU;
using ::NO; using ::YES; using ::MY_PERMC; using ::NOTRANS; using ::sp_ienv;
using ::set_default_options; using ::StatInit; using ::StatFree; using ::superlu_malloc; using ::superlu_free;
using ::Destroy_SuperNode_Matrix; using ::Destroy_CompCol_Matrix;
#endif

static_assert(sizeof(int_t) == sizeof(int), "SuperLU_solver_traits needs a SuperLU with 32 bit indices");

} // namespace superlu
} // namespace internal
} // namespace CGAL

#undef EMPTY
#undef TRUE
#undef FALSE
#undef NO_MARKER
#undef ABORT
#undef CHECK_MALLOC
#undef ADD_
#undef ADD__
#undef NOCHANGE
#undef UPCASE
CGAL_SUPERLU_POP(EMPTY) CGAL_SUPERLU_POP(TRUE) CGAL_SUPERLU_POP(FALSE) CGAL_SUPERLU_POP(NO_MARKER)
CGAL_SUPERLU_POP(ABORT) CGAL_SUPERLU_POP(CHECK_MALLOC) CGAL_SUPERLU_POP(ADD_) CGAL_SUPERLU_POP(ADD__)
CGAL_SUPERLU_POP(NOCHANGE) CGAL_SUPERLU_POP(UPCASE) CGAL_SUPERLU_POP(NO) CGAL_SUPERLU_POP(YES) CGAL_SUPERLU_POP(ROW)
CGAL_SUPERLU_POP(COL) CGAL_SUPERLU_POP(BOTH) CGAL_SUPERLU_POP(TRANS) CGAL_SUPERLU_POP(NOTRANS) CGAL_SUPERLU_POP(CONJ)
CGAL_SUPERLU_POP(FACT) CGAL_SUPERLU_POP(SOLVE) CGAL_SUPERLU_POP(REFINE) CGAL_SUPERLU_POP(HEAD) CGAL_SUPERLU_POP(TAIL)
CGAL_SUPERLU_POP(SYSTEM) CGAL_SUPERLU_POP(USER) CGAL_SUPERLU_POP(NATURAL) CGAL_SUPERLU_POP(COMM) CGAL_SUPERLU_POP(DIST)
CGAL_SUPERLU_POP(EQUIL) CGAL_SUPERLU_POP(RELAX) CGAL_SUPERLU_POP(dgemm_) CGAL_SUPERLU_POP(dtrsv_)
CGAL_SUPERLU_POP(dtrsm_) CGAL_SUPERLU_POP(dgemv_) CGAL_SUPERLU_POP(sgemm_) CGAL_SUPERLU_POP(strsv_)
CGAL_SUPERLU_POP(strsm_) CGAL_SUPERLU_POP(sgemv_) CGAL_SUPERLU_POP(xerbla_) CGAL_SUPERLU_POP(dgsisx)
CGAL_SUPERLU_POP(sgsisx)
#undef __SUPERLU_dSP_DEFS
#undef __SUPERLU_sSP_DEFS
CGAL_SUPERLU_POP(__SUPERLU_dSP_DEFS) CGAL_SUPERLU_POP(__SUPERLU_sSP_DEFS)
// clang-format on

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#undef CGAL_SUPERLU_PRAGMA
#undef CGAL_SUPERLU_PUSH
#undef CGAL_SUPERLU_POP

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_HEADERS_H
