/* Declarations in C and C++, and which functions are inlined. */
#ifndef PEL_BASE_INLINE_H
#define PEL_BASE_INLINE_H

#include "../pel_config.h"

/* Headers declare C functions; C++ has casts of its own. */
#ifdef __cplusplus
#define PEL_BEGIN_DECLS extern "C" {
#define PEL_END_DECLS }
#define PEL_CAST(type, value) static_cast<type>(value)
#define PEL_CAST_ADDRESS(type, value) reinterpret_cast<type>(value)
#else
#define PEL_BEGIN_DECLS
#define PEL_END_DECLS
#define PEL_CAST(type, value) ((type)(value))
#define PEL_CAST_ADDRESS(type, value) ((type)(value))
#endif

/* Does not compile unless the condition, a constant, holds. */
#define PEL_STATIC_ASSERT(name, condition) \
    typedef char name[(condition) ? 1 : -1]

/* PEL_ALWAYS_INLINE: but not where the compiler is told to inline nothing, as
 * with -O0. PEL_NOINLINE: the function's stack is free again when it returns.
 * PEL_MAY_ALIAS: words of this type may lie in an array of another type. */
#if defined(__GNUC__) && !defined(__NO_INLINE__)
#define PEL_ALWAYS_INLINE inline __attribute__((__always_inline__))
#else
#define PEL_ALWAYS_INLINE inline
#endif
#ifdef __GNUC__
#define PEL_NOINLINE __attribute__((__noinline__))
#define PEL_UNUSED __attribute__((__unused__))
#define PEL_MAY_ALIAS __attribute__((__may_alias__))

/* Zero bits above the highest one of v, which is not 0. */
static inline int pel_leading_zeros(uint64_t v)
{
    return __builtin_clzll(v);
}
#else
#define PEL_NOINLINE
#define PEL_UNUSED
#define PEL_MAY_ALIAS

static inline int pel_leading_zeros(uint64_t v)
{
    int zeros = 0;
    for (; !(v >> 63); v <<= 1)
        zeros++;
    return zeros;
}
#endif

/* Zero bits below the lowest one of v, which is not 0. Small CPUs have no
 * instruction for it: there a loop is shorter than what compilers link. */
static inline int pel_trailing_zeros(uint32_t v)
{
#if (PEL_64BIT || defined(__thumb2__)) && defined(__GNUC__)
    return __builtin_ctz(v);
#else
    int zeros = 0;
    for (; !(v & 1); v >>= 1)
        zeros++;
    return zeros;
#endif
}

/* Of functions in headers that a file calls more than once: in one source, too,
 * they are shared where code is to be small (packaging/amalgamate.awk). */
#define PEL_SHARED inline

/* PEL_HOT: runs for every pixel, row or cell, so it is inlined, even where the
 * compiler optimises for size, but not where code is to be small: there it is a
 * function of its own, which shares its code and frees its stack. */
#if PEL_SMALL_CODE
#define PEL_HOT PEL_NOINLINE PEL_UNUSED
#elif defined(__OPTIMIZE_SIZE__)
#define PEL_HOT PEL_ALWAYS_INLINE
#else
#define PEL_HOT inline
#endif

/* A loop whose variables need all registers: a function of its own where the
 * compiler optimises for size and would not find them. */
#if defined(__OPTIMIZE_SIZE__) && !PEL_SMALL_CODE
#define PEL_HOT_LOOP PEL_NOINLINE
#else
#define PEL_HOT_LOOP inline
#endif

/* Where stack is short a shape's and a paint's add up to 384 bytes at most.
 * Then few rows and colors are kept on it at a time. A PEL_STEP is a function
 * of its own there, whose stack is free again when it returns. Elsewhere a
 * PEL_STEP_OR_INLINE is always inlined, a PEL_STEP_OF_FEW also where there are
 * more registers than Thumb-1 has. */
#if PEL_SHORT_STACK
#define PEL_AT_A_TIME(n, few) ((n) < (few) ? (n) : (few))
#define PEL_STEP PEL_NOINLINE
#define PEL_STEP_OR_INLINE PEL_NOINLINE
#else
#define PEL_AT_A_TIME(n, few) (n)
#define PEL_STEP PEL_HOT
#define PEL_STEP_OR_INLINE PEL_ALWAYS_INLINE
#endif
#define PEL_ROWS PEL_AT_A_TIME(PEL_BATCH_ROWS, 4)
#define PEL_COLORS PEL_AT_A_TIME(PEL_BUFFER_PIXELS, 8)

/* On 32-bit CPUs 64-bit numbers are long code and stack is short: there both
 * are functions of their own. On others the first is inlined, the second as the
 * compiler chooses. PEL_INLINE_KINDS: with a constant kind on 64-bit CPUs,
 * where each kind has a loop of its own; elsewhere one loop serves all. */
#if PEL_64BIT
#define PEL_INLINE_64 PEL_ALWAYS_INLINE
#define PEL_INLINE_KINDS PEL_ALWAYS_INLINE
#define PEL_NOINLINE_32
#else
#define PEL_INLINE_64 PEL_NOINLINE
#define PEL_INLINE_KINDS inline
#define PEL_NOINLINE_32 PEL_NOINLINE
#endif

/* Before a loop over three coordinates or corners: written out on CPUs that
 * multiply to 64 bits, where gcc -O2 does not (clang does). */
#if (PEL_64BIT || (PEL_LONG_MULTIPLY && !defined(__OPTIMIZE_SIZE__))) && \
    defined(__GNUC__) && !defined(__clang__)
#define PEL_UNROLL _Pragma("GCC unroll 3")
#else
#define PEL_UNROLL
#endif

/* gcc -O2 joins ints that lie side by side in a vector: to load it takes longer
 * where they were stored one by one just before. This one stays apart. */
#if PEL_64BIT && defined(__GNUC__) && !defined(__clang__)
#define PEL_APART(value) __asm__("" : "+r"(value))
#else
#define PEL_APART(value) PEL_CAST(void, value)
#endif

/* Thumb-1, as on an M0+: eight registers, and some more to move numbers to. */
#if defined(__thumb__) && !defined(__thumb2__)
#define PEL_FEW_REGISTERS 1
#define PEL_STEP_OF_FEW PEL_STEP_OR_INLINE
#else
#define PEL_FEW_REGISTERS 0
#define PEL_STEP_OF_FEW PEL_ALWAYS_INLINE
#endif

/* A loop that is a function of its own where registers are few or Thumb code is
 * to be small, and is inlined elsewhere. */
#if PEL_FEW_REGISTERS || (defined(__thumb__) && PEL_SMALL_CODE)
#define PEL_INLINE_LOOP PEL_NOINLINE
#else
#define PEL_INLINE_LOOP PEL_ALWAYS_INLINE
#endif

#endif
