# SPDX-License-Identifier: GPL-2.0-only
cmake_minimum_required(VERSION 3.25)
# Writes HEADER with the commit of SOURCE; run as a script whenever that has changed.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short HEAD
  OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT commit)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define ENCASE_COMMIT \"@commit@\"\n" @ONLY)
