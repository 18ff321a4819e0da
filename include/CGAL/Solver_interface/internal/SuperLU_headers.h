// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// SuperLU's C headers inside a namespace, so that its many macros and names do not reach the programs that include the
// traits. `SuperLU_library.h` includes it. No other header includes SuperLU's.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_HEADERS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_HEADERS_H

// SuperLU's C headers for `double` and `float`, enclosed in the namespace `CGAL::internal::superlu`.
//
// The limits:
// - Types, enumerators (NO, ROW, TRANS, FACT, ...) and functions are visible in that namespace only.
// - A macro of the user with the name of one of SuperLU's macros or enumerators has its own value
//   again afterwards, and SuperLU's macros are gone, except those that begin with `SUPERLU_` or `USER_`
//   and a few that no other program is likely to have.
// - The Fortran routines of the BLAS that SuperLU declares are declared under other names here, so that they do not
//   conflict with other prototypes (in LAPACKE, CHOLMOD, Eigen, ...).
// - A file that also includes SuperLU itself, or `<Eigen/SuperLUSupport>`, has to do so *before* this
//   file, and both then use the types in the global namespace. In the other order the compiler reports
//   that declarations of C functions contradict: a C function has one signature in a program, and it
//   would mention two sets of types. What is made of the types has another name in such a file
//   (`CGAL_SUPERLU_TYPES` is an inline namespace), so that the linker does not take one for the other.
// - SuperLU_DIST and SuperLU_MT reuse the names of these headers for other contents and
//   cannot be used in the same file.

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

// Let the headers be read although somebody may have read them in the global namespace
#pragma push_macro("__SUPERLU_dSP_DEFS")
#undef __SUPERLU_dSP_DEFS
#pragma push_macro("__SUPERLU_sSP_DEFS")
#undef __SUPERLU_sSP_DEFS

// (the types are shared with the global namespace in that case)
#ifdef __SUPERLU_UTIL
#define CGAL_SUPERLU_TYPES global_superlu_types
#else
#define CGAL_SUPERLU_TYPES hidden_superlu_types
#define CGAL_SUPERLU_TYPES_ARE_HIDDEN
#define CGAL_SUPERLU_HEADERS_HIDE_TYPES
#pragma push_macro("__SUPERLU_CNAMES")
#undef __SUPERLU_CNAMES
#pragma push_macro("__SUPERLU_ENUM_CONSTS")
#undef __SUPERLU_ENUM_CONSTS
#pragma push_macro("__SUPERLU_SUPERMATRIX")
#undef __SUPERLU_SUPERMATRIX
#pragma push_macro("__SUPERLU_UTIL")
#undef __SUPERLU_UTIL
#endif

#pragma push_macro("EMPTY")
#undef EMPTY
#pragma push_macro("TRUE")
#undef TRUE
#pragma push_macro("FALSE")
#undef FALSE
#pragma push_macro("NO_MARKER")
#undef NO_MARKER
#pragma push_macro("NO_MEMTYPE")
#undef NO_MEMTYPE
#pragma push_macro("ABORT")
#undef ABORT
#pragma push_macro("CHECK_MALLOC")
#undef CHECK_MALLOC
#pragma push_macro("ADD_")
#undef ADD_
#pragma push_macro("ADD__")
#undef ADD__
#pragma push_macro("NOCHANGE")
#undef NOCHANGE
#pragma push_macro("UPCASE")
#undef UPCASE
#pragma push_macro("OLD_CRAY")
#undef OLD_CRAY
#pragma push_macro("C_CALL")
#undef C_CALL
#pragma push_macro("FIRSTCOL_OF_SNODE")
#undef FIRSTCOL_OF_SNODE
#pragma push_macro("L_SUB_START")
#undef L_SUB_START
#pragma push_macro("L_SUB")
#undef L_SUB
#pragma push_macro("L_NZ_START")
#undef L_NZ_START
#pragma push_macro("L_FST_SUPC")
#undef L_FST_SUPC
#pragma push_macro("U_NZ_START")
#undef U_NZ_START
#pragma push_macro("U_SUB")
#undef U_SUB
#pragma push_macro("NO")
#undef NO
#pragma push_macro("YES")
#undef YES
#pragma push_macro("ROW")
#undef ROW
#pragma push_macro("COL")
#undef COL
#pragma push_macro("BOTH")
#undef BOTH
#pragma push_macro("NOEQUIL")
#undef NOEQUIL
#pragma push_macro("TRANS")
#undef TRANS
#pragma push_macro("NOTRANS")
#undef NOTRANS
#pragma push_macro("CONJ")
#undef CONJ
#pragma push_macro("FACT")
#undef FACT
#pragma push_macro("SOLVE")
#undef SOLVE
#pragma push_macro("REFINE")
#undef REFINE
#pragma push_macro("HEAD")
#undef HEAD
#pragma push_macro("TAIL")
#undef TAIL
#pragma push_macro("SYSTEM")
#undef SYSTEM
#pragma push_macro("USER")
#undef USER
#pragma push_macro("NATURAL")
#undef NATURAL
#pragma push_macro("COMM")
#undef COMM
#pragma push_macro("DIST")
#undef DIST
#pragma push_macro("EQUIL")
#undef EQUIL
#pragma push_macro("RELAX")
#undef RELAX

#pragma push_macro("dgemm_")
#undef dgemm_
#define dgemm_ cgal_unused_dgemm_
#pragma push_macro("dtrsv_")
#undef dtrsv_
#define dtrsv_ cgal_unused_dtrsv_
#pragma push_macro("dtrsm_")
#undef dtrsm_
#define dtrsm_ cgal_unused_dtrsm_
#pragma push_macro("dgemv_")
#undef dgemv_
#define dgemv_ cgal_unused_dgemv_
#pragma push_macro("sgemm_")
#undef sgemm_
#define sgemm_ cgal_unused_sgemm_
#pragma push_macro("strsv_")
#undef strsv_
#define strsv_ cgal_unused_strsv_
#pragma push_macro("strsm_")
#undef strsm_
#define strsm_ cgal_unused_strsm_
#pragma push_macro("sgemv_")
#undef sgemv_
#define sgemv_ cgal_unused_sgemv_
#pragma push_macro("xerbla_")
#undef xerbla_
#define xerbla_ cgal_unused_xerbla_

// (`<Eigen/SuperLUSupport>` declares these with other types, which is an error to Clang)
#pragma push_macro("dgsisx")
#undef dgsisx
#define dgsisx cgal_unused_dgsisx
#pragma push_macro("sgsisx")
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

#ifndef CGAL_SUPERLU_HEADERS_HIDE_TYPES
using ::SuperMatrix;
using ::NCformat;
using ::NCPformat;
using ::SCformat;
using ::DNformat;
using ::superlu_options_t;
using ::SuperLUStat_t;
using ::GlobalLU_t;
using ::SLU_NC;
using ::SLU_NCP;
using ::SLU_SC;
using ::SLU_DN;
using ::Dtype_t;
using ::SLU_S;
using ::SLU_D;
using ::SLU_GE;
using ::SLU_TRLU;
using ::SLU_TRU;
using ::DOFACT;
using ::NO;
using ::YES;
using ::MY_PERMC;
using ::SamePattern_SameRowPerm;
using ::NOTRANS;
using ::sp_ienv;
using ::set_default_options;
using ::StatInit;
using ::StatFree;
using ::superlu_malloc;
using ::superlu_free;
using ::Destroy_SuperNode_Matrix;
using ::Destroy_CompCol_Matrix;
#endif

static_assert(sizeof(int_t) == sizeof(int), "SuperLU_solver_traits needs a SuperLU with 32 bit indices");

} // namespace superlu
} // namespace internal
} // namespace CGAL

#pragma pop_macro("dgsisx")
#pragma pop_macro("sgsisx")
#pragma pop_macro("xerbla_")
#pragma pop_macro("sgemv_")
#pragma pop_macro("strsm_")
#pragma pop_macro("strsv_")
#pragma pop_macro("sgemm_")
#pragma pop_macro("dgemv_")
#pragma pop_macro("dtrsm_")
#pragma pop_macro("dtrsv_")
#pragma pop_macro("dgemm_")

#pragma pop_macro("RELAX")
#pragma pop_macro("EQUIL")
#pragma pop_macro("DIST")
#pragma pop_macro("COMM")
#pragma pop_macro("NATURAL")
#pragma pop_macro("USER")
#pragma pop_macro("SYSTEM")
#pragma pop_macro("TAIL")
#pragma pop_macro("HEAD")
#pragma pop_macro("REFINE")
#pragma pop_macro("SOLVE")
#pragma pop_macro("FACT")
#pragma pop_macro("CONJ")
#pragma pop_macro("NOTRANS")
#pragma pop_macro("TRANS")
#pragma pop_macro("NOEQUIL")
#pragma pop_macro("BOTH")
#pragma pop_macro("COL")
#pragma pop_macro("ROW")
#pragma pop_macro("YES")
#pragma pop_macro("NO")
#undef U_SUB
#pragma pop_macro("U_SUB")
#undef U_NZ_START
#pragma pop_macro("U_NZ_START")
#undef L_FST_SUPC
#pragma pop_macro("L_FST_SUPC")
#undef L_NZ_START
#pragma pop_macro("L_NZ_START")
#undef L_SUB
#pragma pop_macro("L_SUB")
#undef L_SUB_START
#pragma pop_macro("L_SUB_START")
#undef FIRSTCOL_OF_SNODE
#pragma pop_macro("FIRSTCOL_OF_SNODE")
#undef C_CALL
#pragma pop_macro("C_CALL")
#undef OLD_CRAY
#pragma pop_macro("OLD_CRAY")
#undef UPCASE
#pragma pop_macro("UPCASE")
#undef NOCHANGE
#pragma pop_macro("NOCHANGE")
#undef ADD__
#pragma pop_macro("ADD__")
#undef ADD_
#pragma pop_macro("ADD_")
#undef CHECK_MALLOC
#pragma pop_macro("CHECK_MALLOC")
#undef ABORT
#pragma pop_macro("ABORT")
#undef NO_MEMTYPE
#pragma pop_macro("NO_MEMTYPE")
#undef NO_MARKER
#pragma pop_macro("NO_MARKER")
#undef FALSE
#pragma pop_macro("FALSE")
#undef TRUE
#pragma pop_macro("TRUE")
#undef EMPTY
#pragma pop_macro("EMPTY")

#ifdef CGAL_SUPERLU_HEADERS_HIDE_TYPES
#undef CGAL_SUPERLU_HEADERS_HIDE_TYPES
#undef __SUPERLU_UTIL
#pragma pop_macro("__SUPERLU_UTIL")
#undef __SUPERLU_SUPERMATRIX
#pragma pop_macro("__SUPERLU_SUPERMATRIX")
#undef __SUPERLU_ENUM_CONSTS
#pragma pop_macro("__SUPERLU_ENUM_CONSTS")
#undef __SUPERLU_CNAMES
#pragma pop_macro("__SUPERLU_CNAMES")
#endif
#undef __SUPERLU_sSP_DEFS
#pragma pop_macro("__SUPERLU_sSP_DEFS")
#undef __SUPERLU_dSP_DEFS
#pragma pop_macro("__SUPERLU_dSP_DEFS")

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_HEADERS_H
