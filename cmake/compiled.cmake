# The libraries that are compiled: files, pictures, all schemes on native meshes, the usual meshes of CGAL and OpenMesh.
foreach(part IO PICTURE COMPILED_SCHEMES COMPILED_MESHES)
    set(with_${part} FALSE)
    if(KITH_${part} OR KITH_TOOLS OR KITH_TESTS)
        set(with_${part} TRUE)
    endif()
endforeach()
find_package(OpenMP QUIET COMPONENTS CXX)

# What reads and writes files.
kith_compiled_library(io IS_BUILT ${with_IO} COMPONENT io ROOT io HEADERS io/kith/*.hpp SOURCES io/*.cpp)
target_link_libraries(kith_io PUBLIC kith::schemes kith::distributed)
find_package(ZLIB QUIET)
if(ZLIB_FOUND)
    target_link_libraries(kith_io PRIVATE ZLIB::ZLIB)
    target_compile_definitions(kith_io PRIVATE KITH_HAS_ZLIB)
elseif(with_IO)
    message(STATUS "kith: zlib not found, so compressed files of VTK are refused")
endif()

find_package(nlohmann_json 3 QUIET)
if(nlohmann_json_FOUND)
    target_include_directories(kith_io SYSTEM PRIVATE $<TARGET_PROPERTY:nlohmann_json::nlohmann_json,INTERFACE_INCLUDE_DIRECTORIES>)
    target_compile_definitions(kith_io PRIVATE KITH_HAS_JSON)
elseif(with_IO)
    message(STATUS "kith: nlohmann-json not found, so no .glb is written")
endif()

# What draws pictures.
kith_compiled_library(picture IS_BUILT ${with_PICTURE} COMPONENT picture ROOT picture HEADERS picture/kith/*.hpp
    SOURCES picture/*.cpp)
target_link_libraries(kith_picture PUBLIC kith::kith)
find_package(PNG QUIET)
if(PNG_FOUND)
    target_link_libraries(kith_picture PRIVATE PNG::PNG)
    target_compile_definitions(kith_picture PRIVATE KITH_HAS_PNG)
elseif(with_PICTURE)
    message(STATUS "kith: libpng not found, so pictures are written as SVG only")
endif()

# All schemes on native meshes, which would else be compiled in every program that uses them.
kith_compiled_library(compiled_schemes IS_BUILT ${with_COMPILED_SCHEMES} COMPONENT compiled_schemes
    SOURCES schemes/compiled/*.cpp)
# And a file for each scheme of the registry.
set(registry ${CMAKE_CURRENT_SOURCE_DIR}/schemes/kith/registry.hpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${registry})
file(READ ${registry} lines)
string(REGEX MATCHALL "    line.[a-z0-9_]+, [a-z0-9_]+, [a-z]+" lines "${lines}")
foreach(line IN LISTS lines)
    string(REGEX MATCH "line.([a-z0-9_]+), ([a-z0-9_]+), ([a-z]+)" line "${line}")
    set(source ${CMAKE_CURRENT_BINARY_DIR}/compiled/${CMAKE_MATCH_1}.cpp)
    set(numbers)
    if(CMAKE_MATCH_3 STREQUAL doubles)
        set(numbers "#define KITH_SCHEME_OF_DOUBLES")
    endif()
    file(CONFIGURE OUTPUT ${source} CONTENT "#include <kith/${CMAKE_MATCH_2}.hpp>
#include <kith/limits/limit_surface.hpp>
#define KITH_COMPILE_HERE
#define KITH_SCHEME ${CMAKE_MATCH_1}
${numbers}
#include <kith/schemes/compiled/in_library.hpp>

namespace kith {

KITH_LIMITS(template, ${CMAKE_MATCH_1})

} // namespace kith
")
    target_sources(kith_compiled_schemes PRIVATE ${source})
endforeach()
target_link_libraries(kith_compiled_schemes PUBLIC kith::schemes)
target_compile_definitions(kith_compiled_schemes PUBLIC KITH_COMPILED_SCHEMES)
# Loops that fit the caches take up to an eighth longer where they begin in the middle of a line of the cache.
target_compile_options(kith_compiled_schemes PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-falign-functions=64>)
# In a shared library the code stays as it is in a program.
set_target_properties(kith_compiled_schemes PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
# g++ ceases to inline when a file has grown by so much. Their masks and walks then are calls, which takes a fifth more time.
set_source_files_properties(
    ${CMAKE_CURRENT_BINARY_DIR}/compiled/butterfly.cpp ${CMAKE_CURRENT_BINARY_DIR}/compiled/four_eight.cpp
    PROPERTIES COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:--param=large-unit-insns=1000000>)

# What reads and makes the usual meshes of another library, and beside it what reads their properties and refines them
# in place, which else is compiled in every program. A project that includes kith has looked for that library before.
if(NOT with_COMPILED_SCHEMES)
    set(with_COMPILED_MESHES FALSE)
endif()
if(with_COMPILED_MESHES)
    find_package(CGAL 5.5 QUIET CONFIG)
    find_package(OpenMesh QUIET CONFIG) # 9 or newer; its package does not tell its version
endif()
function(kith_compiled_meshes name library) # sources...
    list(TRANSFORM ARGN PREPEND adapters/compiled/)
    kith_compiled_library(${name} IS_BUILT ${with_COMPILED_MESHES} COMPONENT compiled_meshes SOURCES ${ARGN})
    target_link_libraries(kith_${name} PUBLIC ${library} kith::compiled_schemes)
    string(TOUPPER KITH_${name} definition)
    target_compile_definitions(kith_${name} PUBLIC ${definition})
endfunction()
if(TARGET CGAL::CGAL OR TARGET OpenMeshCore)
    kith_compiled_meshes(compiled_dialects kith::schemes doubles_in_place.cpp floats_in_place.cpp)
    target_include_directories(kith_compiled_dialects PRIVATE adapters)
endif()
foreach(library cgal:CGAL::CGAL:CGAL openmesh:OpenMeshCore:OpenMesh)
    string(REGEX MATCH "^([a-z]+):(.+):([A-Za-z]+)$" library ${library})
    set(name compiled_${CMAKE_MATCH_1})
    if(TARGET ${CMAKE_MATCH_2})
        kith_compiled_meshes(${name}_meshes kith::${CMAKE_MATCH_1} ${CMAKE_MATCH_1}_meshes.cpp)
        kith_compiled_meshes(${name} kith::${name}_meshes ${CMAKE_MATCH_1}_properties.cpp)
        target_link_libraries(kith_${name} PUBLIC kith::compiled_dialects)
    elseif(NOT PROJECT_IS_TOP_LEVEL)
        add_library(kith_${name} INTERFACE)
        add_library(kith::${name} ALIAS kith_${name})
        target_link_libraries(kith_${name} INTERFACE kith::${name}_needs_find_package_${CMAKE_MATCH_3}_before_kith_is_added)
    endif()
endforeach()
