# What kith's own programs need; nothing of this is installed with the library or seen by a project that includes it.
find_package(Boost 1.74 QUIET COMPONENTS program_options)
find_package(GTest QUIET)
find_package(Eigen3 3.3 QUIET NO_MODULE)
find_package(MPI 3.1 QUIET COMPONENTS CXX)
find_library(METIS_LIBRARY metis) # has no package of CMake's
find_path(METIS_INCLUDE_DIR metis.h)
if(METIS_LIBRARY AND METIS_INCLUDE_DIR)
    set(METIS_FOUND TRUE)
endif()
find_library(OPENSUBDIV_LIBRARY osdCPU) # its package names a library that Debian leaves out
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
if(OPENSUBDIV_LIBRARY AND OPENSUBDIV_INCLUDE_DIR)
    set(OpenSubdiv_FOUND TRUE)
endif()

set(without_CGAL "the programs kith and kith-mpi, all comparisons, everything with CGAL in tests and examples")
set(without_OpenMesh "the programs kith and kith-mpi, everything with OpenMesh in tests, examples and comparisons")
set(without_Boost "the programs kith and kith-mpi, all comparisons")
set(without_OpenMP "threads")
set(without_GTest "the tests")
set(without_Eigen3 "the tests of eigenvalues, matrices and shells, the examples multigrid, surface_eigenvalues and thin_shells")
set(without_MPI "the program kith-mpi and its tests")
set(without_METIS "the programs kith, kith-mpi and virtual_ranks")
set(without_OpenSubdiv "the comparisons with OpenSubdiv")
foreach(package CGAL OpenMesh Boost OpenMP GTest Eigen3 MPI METIS OpenSubdiv)
    if(${package}_FOUND)
        message(STATUS "kith: ${package} found")
    else()
        message(STATUS "kith: ${package} not found, so these are off: ${without_${package}}")
    endif()
endforeach()

set(CMAKE_CXX_EXTENSIONS OFF)

# What every program of ours links, and on top of it what those link that use foreign meshes (kith_meshes), with their properties and
# in place (kith_dialects).
add_library(kith_own INTERFACE)
target_link_libraries(kith_own INTERFACE kith::schemes kith::distributed)
target_compile_options(kith_own INTERFACE -Wall -Wextra $<$<BOOL:${KITH_WERROR}>:-Werror> ${without_mistakes})
target_compile_definitions(kith_own INTERFACE KITH_DATA_DIR="${PROJECT_SOURCE_DIR}/build/data/meshes") # see ./check
if(OpenMP_FOUND)
    target_link_libraries(kith_own INTERFACE OpenMP::OpenMP_CXX)
endif()
# Without optimisation, too, g++ needs no function for std::move and the like.
set(is_gnu_12 $<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,12>>)
target_compile_options(kith_own INTERFACE $<${is_gnu_12}:-ffold-simple-inlines>)
# g++ spends a sixth of its time on tidying its memory up. Up to 2 GB it need not, if there are 4 GB for each compiler.
cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
cmake_host_system_information(RESULT megabytes QUERY TOTAL_PHYSICAL_MEMORY)
math(EXPR megabytes_of_compiler "${megabytes} / (${processors} + 2)")
if(megabytes_of_compiler GREATER 4000)
    set(untidy $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=2000000>)
    target_compile_options(kith_own INTERFACE ${untidy})
    target_compile_options(kith_compiled_schemes PRIVATE ${untidy})
endif()

# What those link, beside, whose own loops need not be fast: the schemes that they use are compiled apart.
add_library(kith_compile_fast INTERFACE)
target_compile_options(kith_compile_fast INTERFACE $<$<CONFIG:Release>:-O1>)
target_compile_definitions(kith_compile_fast INTERFACE KITH_COMPILE_FAST)

add_library(kith_meshes INTERFACE)
target_link_libraries(kith_meshes INTERFACE kith_own)
add_library(kith_dialects INTERFACE)
target_link_libraries(kith_dialects INTERFACE kith_meshes)
foreach(library CGAL OpenMesh)
    if(${library}_FOUND)
        string(TOLOWER kith::compiled_${library} compiled)
        target_link_libraries(kith_meshes INTERFACE ${compiled}_meshes)
        target_link_libraries(kith_dialects INTERFACE ${compiled})
    endif()
endforeach()
