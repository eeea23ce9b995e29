#pragma once

/// Marks a function whose loops are compiled for the vector units of newer machines too; which one
/// runs is decided when the program is loaded. Sanitizers have no say at that time, and instrument
/// the plain one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define ENCASE_VECTOR_UNITS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ENCASE_VECTOR_UNITS
#endif
