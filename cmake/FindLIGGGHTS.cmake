# SPDX-License-Identifier: GPL-2.0-only
# Finds LIGGGHTS 3.8: Debian's package, or a source build given by -DLIGGGHTS_ROOT=DIR, where DIR
# holds src/ with the headers and the shared library (or lib/ and include/liggghts/).
# Defines the target LIGGGHTS::LIGGGHTS and LIGGGHTS_VERSION.

set(LIGGGHTS_ROOT "$ENV{LIGGGHTS_ROOT}" CACHE PATH "LIGGGHTS built from source, empty for Debian's package")

# What was found for another root stays in the cache otherwise.
if(DEFINED LIGGGHTS_ROOT_BEFORE AND NOT LIGGGHTS_ROOT STREQUAL LIGGGHTS_ROOT_BEFORE)
  unset(LIGGGHTS_INCLUDE_DIR CACHE)
  unset(LIGGGHTS_LIBRARY CACHE)
endif()
set(LIGGGHTS_ROOT_BEFORE "${LIGGGHTS_ROOT}" CACHE INTERNAL "")

# A root that was given is the only place: Debian's package must not take its part unseen.
set(places)
if(LIGGGHTS_ROOT)
  set(places PATHS ${LIGGGHTS_ROOT} NO_DEFAULT_PATH)
endif()
find_path(LIGGGHTS_INCLUDE_DIR pair_gran_base.h PATH_SUFFIXES liggghts include/liggghts src ${places})
find_library(LIGGGHTS_LIBRARY NAMES liggghts lmp_auto PATH_SUFFIXES lib src src-build ${places})

set(missing)
if(NOT LIGGGHTS_INCLUDE_DIR)
  list(APPEND missing "no src/pair_gran_base.h or include/liggghts/pair_gran_base.h")
endif()
if(NOT LIGGGHTS_LIBRARY)
  list(APPEND missing "no libliggghts.so or liblmp_auto.so in lib/, src/ or src-build/")
endif()
if(LIGGGHTS_ROOT AND missing)
  list(JOIN missing " and " missing)
  message(FATAL_ERROR "LIGGGHTS_ROOT must name a folder with a built LIGGGHTS, found ${missing} in "
    "'${LIGGGHTS_ROOT}', give -DLIGGGHTS_ROOT=DIR, or -DLIGGGHTS_ROOT= for Debian's package.")
endif()

# Debian's headers do not tell the version; the library of either does.
if(LIGGGHTS_LIBRARY)
  set(version "LIGGGHTS[-A-Z]* ([0-9]+(\\.[0-9]+)+)")
  file(STRINGS ${LIGGGHTS_LIBRARY} line REGEX "${version}" LIMIT_COUNT 1)
  if(line MATCHES "${version}")
    set(LIGGGHTS_VERSION ${CMAKE_MATCH_1})
  endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR
  VERSION_VAR LIGGGHTS_VERSION
  REASON_FAILURE_MESSAGE "install liggghts and libliggghts-dev, or give -DLIGGGHTS_ROOT=DIR")

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::LIGGGHTS)
  find_package(MPI REQUIRED COMPONENTS CXX)
  add_library(LIGGGHTS::LIGGGHTS UNKNOWN IMPORTED)
  set_target_properties(LIGGGHTS::LIGGGHTS PROPERTIES IMPORTED_LOCATION ${LIGGGHTS_LIBRARY})
  target_include_directories(LIGGGHTS::LIGGGHTS SYSTEM INTERFACE ${LIGGGHTS_INCLUDE_DIR})
  target_compile_options(LIGGGHTS::LIGGGHTS INTERFACE -Wno-register)
  target_link_libraries(LIGGGHTS::LIGGGHTS INTERFACE MPI::MPI_CXX)
endif()
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY)
