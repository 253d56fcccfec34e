#pragma once

/// GRAFTSMAN_VECTOR_CLONES before a function: compiled once more for wider vectors, chosen when the program
/// starts. The operations and their order are the same in every copy, and -ffp-contract=off keeps products
/// and sums apart, so that all copies give the same bits. A product and sum in one are written std::fma: one
/// instruction in the wider copies (AVX2 and AVX-512 both have it), the same bits by the C library, though
/// slowly, in the default one. What it calls must be GRAFTSMAN_INLINE to be copied, too. Left out where the
/// choice at program start is not to be had (it does not get along with sanitizers).
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GRAFTSMAN_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define GRAFTSMAN_VECTOR_CLONES
#endif

#define GRAFTSMAN_INLINE __attribute__((always_inline)) inline
