# Fails where version.h does not say the version of the project.
#
# usage: cmake -D HEADER=.../version.h -D VERSION=X.Y.Z -P test_version.cmake

cmake_minimum_required(VERSION 3.18)
if(NOT VERSION MATCHES "^([0-9]+)\\.([0-9]+)\\.([0-9]+)$")
  message(FATAL_ERROR "VERSION is ${VERSION}, not X.Y.Z.")
endif()
math(EXPR number "${CMAKE_MATCH_1} * 10000 + ${CMAKE_MATCH_2} * 100 + ${CMAKE_MATCH_3}")
foreach(line "#define CGAL_FLIP_FREE_MAPS_VERSION \"${VERSION}\"" "#define CGAL_FLIP_FREE_MAPS_VERSION_NR ${number}")
  file(STRINGS "${HEADER}" found REGEX "^${line}$")
  if(NOT found)
    message(FATAL_ERROR "${HEADER} has no line: ${line}")
  endif()
endforeach()
