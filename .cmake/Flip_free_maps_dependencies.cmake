# Gathers what Flip_free_maps stands on: CGAL, Eigen and Boost, which the including file has found already, and the
# optional libraries, which are looked for here. Included by the build of the package and by its installed configuration
# file, so that both decide alike.
#
# Reads     FLIP_FREE_MAPS_WITH_CHOLMOD, FLIP_FREE_MAPS_WITH_TBB, FLIP_FREE_MAPS_WITH_TETGEN, FLIP_FREE_MAPS_WITH_PETSC
# Creates   CGAL::Eigen3_support and Flip_free_maps::dependencies, the sum of all
# Sets      FLIP_FREE_MAPS_CHOLMOD_STATUS, FLIP_FREE_MAPS_TBB_STATUS, FLIP_FREE_MAPS_TETGEN_STATUS,
#           FLIP_FREE_MAPS_PETSC_STATUS (text for the user)

include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  message(FATAL_ERROR "Flip_free_maps: CGAL does not accept the Eigen library that was found.")
endif()

# An imported target can be extended only in the directory that created it; a second inclusion just sets the texts again.
set(FLIP_FREE_MAPS_DEPENDENCIES_ARE_NEW OFF)
if(NOT TARGET Flip_free_maps::dependencies)
  set(FLIP_FREE_MAPS_DEPENDENCIES_ARE_NEW ON)
  add_library(Flip_free_maps::dependencies INTERFACE IMPORTED)
  # The number of threads of the BLAS is set through a symbol looked up at run time, hence the dl library.
  target_link_libraries(Flip_free_maps::dependencies INTERFACE
    CGAL::CGAL CGAL::Eigen3_support Boost::headers ${CMAKE_DL_LIBS})
endif()

# CHOLMOD: SuiteSparse before 7 has neither a CMake nor a pkg-config file.
if(FLIP_FREE_MAPS_WITH_CHOLMOD)
  find_path(FLIP_FREE_MAPS_CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
  find_library(FLIP_FREE_MAPS_CHOLMOD_LIBRARY cholmod)
  mark_as_advanced(FLIP_FREE_MAPS_CHOLMOD_INCLUDE_DIR FLIP_FREE_MAPS_CHOLMOD_LIBRARY)
  if(FLIP_FREE_MAPS_CHOLMOD_INCLUDE_DIR AND FLIP_FREE_MAPS_CHOLMOD_LIBRARY)
    if(FLIP_FREE_MAPS_DEPENDENCIES_ARE_NEW)
      add_library(Flip_free_maps::CHOLMOD UNKNOWN IMPORTED)
      set_target_properties(Flip_free_maps::CHOLMOD PROPERTIES
        IMPORTED_LOCATION "${FLIP_FREE_MAPS_CHOLMOD_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${FLIP_FREE_MAPS_CHOLMOD_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS CGAL_FLIP_FREE_MAPS_USE_CHOLMOD)
      target_link_libraries(Flip_free_maps::dependencies INTERFACE Flip_free_maps::CHOLMOD)
    endif()
    set(FLIP_FREE_MAPS_CHOLMOD_STATUS "found, ${FLIP_FREE_MAPS_CHOLMOD_LIBRARY}")
  else()
    set(FLIP_FREE_MAPS_CHOLMOD_STATUS "not found, Eigen's simplicial LDLT is used")
  endif()
else()
  set(FLIP_FREE_MAPS_CHOLMOD_STATUS "switched off, Eigen's simplicial LDLT is used")
endif()

# oneTBB
if(FLIP_FREE_MAPS_WITH_TBB)
  find_package(TBB QUIET CONFIG)
  if(TBB_FOUND AND TARGET TBB::tbb AND TARGET TBB::tbbmalloc)
    if(FLIP_FREE_MAPS_DEPENDENCIES_ARE_NEW)
      include(CGAL_TBB_support)
      target_link_libraries(Flip_free_maps::dependencies INTERFACE CGAL::TBB_support)
    endif()
    set(FLIP_FREE_MAPS_TBB_STATUS "found, version ${TBB_VERSION}")
  else()
    set(FLIP_FREE_MAPS_TBB_STATUS "not found, elements are visited sequentially")
  endif()
else()
  set(FLIP_FREE_MAPS_TBB_STATUS "switched off, elements are visited sequentially")
endif()

# TetGen
if(FLIP_FREE_MAPS_WITH_TETGEN)
  find_path(FLIP_FREE_MAPS_TETGEN_INCLUDE_DIR tetgen.h)
  find_library(FLIP_FREE_MAPS_TETGEN_LIBRARY tet)
  mark_as_advanced(FLIP_FREE_MAPS_TETGEN_INCLUDE_DIR FLIP_FREE_MAPS_TETGEN_LIBRARY)
  if(FLIP_FREE_MAPS_TETGEN_INCLUDE_DIR AND FLIP_FREE_MAPS_TETGEN_LIBRARY)
    if(FLIP_FREE_MAPS_DEPENDENCIES_ARE_NEW)
      add_library(Flip_free_maps::TetGen UNKNOWN IMPORTED)
      set_target_properties(Flip_free_maps::TetGen PROPERTIES
        IMPORTED_LOCATION "${FLIP_FREE_MAPS_TETGEN_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${FLIP_FREE_MAPS_TETGEN_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS CGAL_FLIP_FREE_MAPS_USE_TETGEN)
      target_link_libraries(Flip_free_maps::dependencies INTERFACE Flip_free_maps::TetGen)
    endif()
    set(FLIP_FREE_MAPS_TETGEN_STATUS "found, ${FLIP_FREE_MAPS_TETGEN_LIBRARY}")
  else()
    set(FLIP_FREE_MAPS_TETGEN_STATUS "not found, closed surfaces are filled by Mesh_3 only")
  endif()
else()
  set(FLIP_FREE_MAPS_TETGEN_STATUS "switched off, closed surfaces are filled by Mesh_3 only")
endif()

# PETSc, real and of double precision. It is there only for who asks for it, since it changes the default solver of large solids.
if(FLIP_FREE_MAPS_WITH_PETSC)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(FLIP_FREE_MAPS_PC_PETSC QUIET PETSc>=3.18)
  endif()
  find_path(FLIP_FREE_MAPS_PETSC_INCLUDE_DIR petscksp.h HINTS ${FLIP_FREE_MAPS_PC_PETSC_INCLUDE_DIRS} PATH_SUFFIXES petsc)
  find_library(FLIP_FREE_MAPS_PETSC_LIBRARY NAMES petsc_real petsc NAMES_PER_DIR HINTS ${FLIP_FREE_MAPS_PC_PETSC_LIBRARY_DIRS})
  find_package(MPI QUIET COMPONENTS CXX)
  mark_as_advanced(FLIP_FREE_MAPS_PETSC_INCLUDE_DIR FLIP_FREE_MAPS_PETSC_LIBRARY)
  if(NOT FLIP_FREE_MAPS_PETSC_INCLUDE_DIR OR NOT FLIP_FREE_MAPS_PETSC_LIBRARY OR NOT MPI_CXX_FOUND)
    message(FATAL_ERROR "FLIP_FREE_MAPS_WITH_PETSC is on, but PETSc 3.18 or later with its MPI was not found (Debian: libpetsc-real-dev).")
  endif()
  if(FLIP_FREE_MAPS_DEPENDENCIES_ARE_NEW)
    add_library(Flip_free_maps::PETSc UNKNOWN IMPORTED)
    set_target_properties(Flip_free_maps::PETSc PROPERTIES
      IMPORTED_LOCATION "${FLIP_FREE_MAPS_PETSC_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${FLIP_FREE_MAPS_PETSC_INCLUDE_DIR}"
      INTERFACE_COMPILE_DEFINITIONS CGAL_FLIP_FREE_MAPS_USE_PETSC
      INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
    target_link_libraries(Flip_free_maps::dependencies INTERFACE Flip_free_maps::PETSc)
  endif()
  set(FLIP_FREE_MAPS_PETSC_STATUS "found, ${FLIP_FREE_MAPS_PETSC_LIBRARY}")
else()
  set(FLIP_FREE_MAPS_PETSC_STATUS "not asked for, conjugate gradients are preconditioned without it")
endif()
