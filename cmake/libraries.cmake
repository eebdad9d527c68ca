# The functions that declare a target of kith. Files are found by patterns, so that a new one needs no line anywhere.

# kith_files(result patterns...): the files of the project that match.
function(kith_files result)
    list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS ${ARGN})
    set(${result} ${files} PARENT_SCOPE)
endfunction()

# kith_library(name root patterns...): headers below an include root.
function(kith_library name root)
    list(TRANSFORM ARGN PREPEND ${root}/kith/)
    kith_files(headers ${ARGN})
    add_library(kith_${name} INTERFACE)
    add_library(kith::${name} ALIAS kith_${name})
    target_sources(kith_${name} INTERFACE FILE_SET HEADERS BASE_DIRS ${root} FILES ${headers})
    set_target_properties(kith_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS kith_${name} EXPORT kith-${name} FILE_SET HEADERS COMPONENT library)
    install(EXPORT kith-${name} NAMESPACE kith:: DESTINATION ${package_dir} COMPONENT library)
endfunction()

# The same for a library that is compiled. Where IS_BUILT is true it is built with all else and installed, and else
# built for those who link it.
function(kith_compiled_library name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "IS_BUILT;COMPONENT;ROOT" "HEADERS;SOURCES")
    kith_files(sources ${arg_SOURCES})
    add_library(kith_${name} STATIC ${sources})
    add_library(kith::${name} ALIAS kith_${name})
    target_compile_options(kith_${name} PRIVATE -Wall -Wextra $<$<BOOL:${KITH_WERROR}>:-Werror> ${without_mistakes})
    target_compile_definitions(kith_${name} PRIVATE KITH_COMPILED_PART) # its OpenMP gives no threads to programs without
    if(OpenMP_FOUND)
        target_link_libraries(kith_${name} PRIVATE OpenMP::OpenMP_CXX)
    endif()
    # Shared libraries, such as the Python module, are made of it, too.
    set_target_properties(kith_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
    set(install_headers)
    if(arg_HEADERS)
        kith_files(headers ${arg_HEADERS})
        target_sources(kith_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${arg_ROOT} FILES ${headers})
        set(install_headers FILE_SET HEADERS COMPONENT ${arg_COMPONENT})
    endif()
    if(arg_IS_BUILT)
        install(TARGETS kith_${name} EXPORT kith-${name} ARCHIVE COMPONENT ${arg_COMPONENT} ${install_headers})
        install(EXPORT kith-${name} NAMESPACE kith:: DESTINATION ${package_dir} COMPONENT ${arg_COMPONENT})
    else()
        set_target_properties(kith_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
endfunction()

# Links a target of another package. In a project that has not looked for that package CMake ends with a name that says
# so.
function(kith_links name target package)
    target_link_libraries(kith_${name} INTERFACE
        $<IF:$<TARGET_EXISTS:${target}>,${target},kith::${name}_needs_find_package_${package}_before_it_is_linked>)
endfunction()
