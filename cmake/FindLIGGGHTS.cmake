# Finds LIGGGHTS 3.8: Debian's package, or a source build given by -DLIGGGHTS_ROOT=DIR, where DIR
# holds src/ with the headers and the shared library (or lib/ and include/liggghts/).
# Defines the target LIGGGHTS::LIGGGHTS.

find_path(LIGGGHTS_INCLUDE_DIR pair_gran_base.h
  HINTS ${LIGGGHTS_ROOT}
  PATH_SUFFIXES liggghts include/liggghts src)
find_library(LIGGGHTS_LIBRARY
  NAMES liggghts lmp_auto
  HINTS ${LIGGGHTS_ROOT}
  PATH_SUFFIXES lib src src-build)

if(LIGGGHTS_INCLUDE_DIR AND EXISTS ${LIGGGHTS_INCLUDE_DIR}/version_liggghts.h)
  file(STRINGS ${LIGGGHTS_INCLUDE_DIR}/version_liggghts.h LIGGGHTS_VERSION_LINE)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR
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
