// VEC_INLINE, of the helpers of vector code: inlined whatever they cost, for a vector that a call
// hands over goes through memory. Left to the compiler in builds with sanitizers, whose checks make
// of the callers functions so large that they take minutes to compile.
#pragma once

#include <hwy/base.h>

#ifdef TERRVIEW_SANITIZED
#define VEC_INLINE inline
#else
#define VEC_INLINE HWY_INLINE
#endif
