# SPDX-License-Identifier: GPL-2.0-only
# What is installed beside programs and decks, and the Debian packages: `cpack -B FOLDER` in the build folder makes
# encased-columns_VERSION_ARCHITECTURE.deb of what was built, and encased-columns-calibration_... where `encase calibrate` was.
set(documents ${CMAKE_INSTALL_DATADIR}/doc/encased-columns)

# The pages lie as in the sources, with all that they link to, so that their links hold (tests/pages/test_documents.cpp).
file(GLOB_RECURSE pages RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/calibration/*.md ${CMAKE_SOURCE_DIR}/input_scripts/*.md ${CMAKE_SOURCE_DIR}/src_plugin/*.md
  ${CMAKE_SOURCE_DIR}/postprocess/*.md ${CMAKE_SOURCE_DIR}/postprocess/results/*.png
  ${CMAKE_SOURCE_DIR}/postprocess/results/*.txt ${CMAKE_SOURCE_DIR}/postprocess/results/*.csv
  ${CMAKE_SOURCE_DIR}/tests/bench/*.md ${CMAKE_SOURCE_DIR}/tests/bench/*.csv)
foreach(page README.md CONTRIBUTING.md CHANGELOG.md CITATION.cff LICENSE ${pages} input_scripts/common/strip_geotextile.csv
    postprocess/targets.csv src_plugin/main.cpp src_plugin/plugin_entry.h
    tests/bench/contacts.cpp tests/bench/facets.cpp tests/unit/floors/floors.txt)
  cmake_path(GET page PARENT_PATH folder)
  install(FILES ${CMAKE_SOURCE_DIR}/${page} DESTINATION ${documents}/${folder})
endforeach()
configure_file(${CMAKE_SOURCE_DIR}/cmake/copyright.in ${CMAKE_BINARY_DIR}/copyright @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/copyright DESTINATION ${documents})
# Debian wants the changes and the pages of `man` compressed.
install(FILES ${CMAKE_SOURCE_DIR}/CHANGELOG.md DESTINATION ${documents} RENAME changelog)
install(CODE "
  file(GLOB texts \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1/*encase*.1\")
  execute_process(COMMAND gzip -9nf \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${documents}/changelog\" \${texts})")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME encased-columns)
set(CPACK_PACKAGE_CONTACT "The encased-columns authors <encased-columns@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own first line
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# `encase-calibrate` has a package of its own: the libraries it needs are no matter of those who run tests.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME encased-columns)
set(CPACK_DEBIAN_UNSPECIFIED_DESCRIPTION "Discrete element tests of gravel columns in a geotextile
Programs, decks and pages for triaxial tests of gravel columns in a geotextile sleeve: a plugin
for LIGGGHTS 3.8 (dense packings, walls driven by stress, a deformable sleeve, measures), the command `encase` that runs
tests and series of them, and reports with curves, tables and pictures.")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_DEPENDS "openmpi-bin, xvfb, xauth")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS "encased-columns-calibration, paraview, slurm-client")
if(ENCASE_CALIBRATION)
  list(APPEND CPACK_COMPONENTS_ALL calibration)
  set(CPACK_DEBIAN_CALIBRATION_PACKAGE_NAME encased-columns-calibration)
  set(CPACK_DEBIAN_CALIBRATION_PACKAGE_DEPENDS "encased-columns (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_CALIBRATION_DESCRIPTION "Parameters of discrete element tests from laboratory results
The program behind `encase calibrate` of encased-columns: designs, surrogates, search and intervals.")
  install(FILES ${CMAKE_BINARY_DIR}/copyright DESTINATION ${documents}-calibration COMPONENT calibration)
endif()
include(CPack)
