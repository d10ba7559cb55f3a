# The parts of the program that tests compile, too: file formats and pictures, in examples/program/. They are no part of the
# package, and neither are Cairo, which draws the pictures, and zlib, which compresses VTU files.
#
# Reads     FLIP_FREE_MAPS_UNITY_BUILD, FLIP_FREE_MAPS_WITH_CAIRO, FLIP_FREE_MAPS_WITH_ZLIB
# Creates   flip_free_maps_program, their headers; flip_free_maps_formats, their sources
# Sets      FLIP_FREE_MAPS_CAIRO_STATUS, FLIP_FREE_MAPS_ZLIB_STATUS (text for the user)

add_library(flip_free_maps_program INTERFACE)
target_include_directories(flip_free_maps_program INTERFACE "${PROJECT_SOURCE_DIR}/examples")
target_link_libraries(flip_free_maps_program INTERFACE Flip_free_maps::Flip_free_maps)

# Cairo: pkg-config knows unusual places, but is not needed for the usual ones.
if(FLIP_FREE_MAPS_WITH_CAIRO)
  find_package(PkgConfig QUIET)
  if(PKG_CONFIG_FOUND)
    pkg_check_modules(FLIP_FREE_MAPS_PC_CAIRO QUIET cairo)
  endif()
  find_path(FLIP_FREE_MAPS_CAIRO_INCLUDE_DIR cairo.h HINTS ${FLIP_FREE_MAPS_PC_CAIRO_INCLUDE_DIRS} PATH_SUFFIXES cairo)
  find_library(FLIP_FREE_MAPS_CAIRO_LIBRARY cairo HINTS ${FLIP_FREE_MAPS_PC_CAIRO_LIBRARY_DIRS})
  mark_as_advanced(FLIP_FREE_MAPS_CAIRO_INCLUDE_DIR FLIP_FREE_MAPS_CAIRO_LIBRARY)
  if(FLIP_FREE_MAPS_CAIRO_INCLUDE_DIR AND FLIP_FREE_MAPS_CAIRO_LIBRARY)
    if(NOT TARGET Flip_free_maps::Cairo)
      add_library(Flip_free_maps::Cairo UNKNOWN IMPORTED)
      set_target_properties(Flip_free_maps::Cairo PROPERTIES
        IMPORTED_LOCATION "${FLIP_FREE_MAPS_CAIRO_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${FLIP_FREE_MAPS_CAIRO_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS CGAL_FLIP_FREE_MAPS_USE_CAIRO)
      target_link_libraries(flip_free_maps_program INTERFACE Flip_free_maps::Cairo)
    endif()
    set(FLIP_FREE_MAPS_CAIRO_STATUS "found, ${FLIP_FREE_MAPS_CAIRO_LIBRARY}")
  else()
    set(FLIP_FREE_MAPS_CAIRO_STATUS "not found, the program draws no pictures, --svg and --png are refused")
  endif()
else()
  set(FLIP_FREE_MAPS_CAIRO_STATUS "switched off, the program draws no pictures, --svg and --png are refused")
endif()

file(GLOB format_files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/examples/program/formats/*.cpp")
add_library(flip_free_maps_formats STATIC EXCLUDE_FROM_ALL ${format_files})
set_target_properties(flip_free_maps_formats PROPERTIES UNITY_BUILD ${FLIP_FREE_MAPS_UNITY_BUILD} UNITY_BUILD_BATCH_SIZE 0)
target_link_libraries(flip_free_maps_formats PUBLIC flip_free_maps_program)
target_compile_options(flip_free_maps_formats PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra>)

if(FLIP_FREE_MAPS_WITH_ZLIB)
  find_package(ZLIB QUIET)
  if(ZLIB_FOUND)
    target_link_libraries(flip_free_maps_formats PRIVATE ZLIB::ZLIB)
    target_compile_definitions(flip_free_maps_formats PRIVATE CGAL_FLIP_FREE_MAPS_USE_ZLIB)
    set(FLIP_FREE_MAPS_ZLIB_STATUS "found, ${ZLIB_VERSION_STRING}")
  else()
    set(FLIP_FREE_MAPS_ZLIB_STATUS "not found, compressed VTU files are refused")
  endif()
else()
  set(FLIP_FREE_MAPS_ZLIB_STATUS "switched off, compressed VTU files are refused")
endif()
