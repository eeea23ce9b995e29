# SPDX-License-Identifier: GPL-2.0-only
# What is installed beside programs and decks, and the Debian package: `cpack -B FOLDER` in the build folder makes
# encased-columns_VERSION_ARCHITECTURE.deb of what was built.
set(documents ${CMAKE_INSTALL_DATADIR}/doc/encased-columns)

# The pages lie as in the sources, so that their links hold.
file(GLOB_RECURSE pages RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS
  ${CMAKE_SOURCE_DIR}/calibration/*.md ${CMAKE_SOURCE_DIR}/input_scripts/*.md ${CMAKE_SOURCE_DIR}/src_plugin/*.md
  ${CMAKE_SOURCE_DIR}/postprocess/*.md ${CMAKE_SOURCE_DIR}/postprocess/results/*.png
  ${CMAKE_SOURCE_DIR}/postprocess/results/*.txt ${CMAKE_SOURCE_DIR}/tests/bench/*.md)
foreach(page README.md CONTRIBUTING.md CITATION.cff ${pages})
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
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Discrete element tests of gravel columns in a geotextile")
set(CPACK_PACKAGE_DESCRIPTION "Programs, decks and pages for triaxial tests of gravel columns in a geotextile sleeve: a plugin
for LIGGGHTS 3.8 (dense packings, walls driven by stress, a deformable sleeve, measures), the command `encase` that runs
tests and series of them, and reports with curves, tables and pictures.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_DEPENDS "openmpi-bin, xvfb, xauth")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview, slurm-client")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
