# The page of `kith view`, in which the library runs as WebAssembly. clang compiles it where its WebAssembly packages are.
find_program(KITH_WASM_COMPILER NAMES clang++-19 clang++ DOC "A clang++ that compiles to wasm32-wasi, for kith view")
if(NOT DEFINED KITH_VIEWER)
    set(works 1)
    if(KITH_WASM_COMPILER)
        file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/viewer/probe.cpp "#include <string_view>\nint main() { return int(std::string_view().size()); }\n")
        execute_process(COMMAND ${KITH_WASM_COMPILER} --target=wasm32-wasi -std=c++20 -fignore-exceptions probe.cpp -o probe.wasm
            WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/viewer RESULT_VARIABLE works OUTPUT_QUIET ERROR_QUIET)
    endif()
    if(works EQUAL 0)
        set(KITH_VIEWER ON CACHE BOOL "Build the page of kith view")
    else()
        message(STATUS "kith: no clang for WebAssembly found, so there is no kith view")
    endif()
endif()

# Adds the page to a target, or an empty one.
function(kith_viewer_page target)
    set(sources ${PROJECT_SOURCE_DIR}/tools/viewer)
    set(built ${CMAKE_CURRENT_BINARY_DIR}/viewer)
    target_sources(${target} PRIVATE ${built}/page.cpp)
    set_source_files_properties(${built}/page.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS -Wno-overlength-strings)
    if(NOT KITH_VIEWER)
        file(CONFIGURE OUTPUT ${built}/page.cpp
            CONTENT "#include \"viewer/page.hpp\"\n\nconst std::string_view kith::tool::viewer_page;\n")
        return()
    endif()
    set(flags --target=wasm32-wasi -std=c++20 -O2 -DNDEBUG -ffp-contract=off -fignore-exceptions)
    foreach(root include schemes picture tools)
        list(APPEND flags -I${PROJECT_SOURCE_DIR}/${root})
    endforeach()
    set(objects)
    foreach(source ${sources}/module.cpp ${sources}/drawing.cpp ${PROJECT_SOURCE_DIR}/picture/color.cpp)
        cmake_path(GET source STEM name)
        set(object ${built}/${name}.o)
        add_custom_command(OUTPUT ${object} COMMAND ${CMAKE_COMMAND} -E make_directory ${built}
            COMMAND ${KITH_WASM_COMPILER} ${flags} -MD -MF ${object}.d -c ${source} -o ${object}
            DEPENDS ${source} DEPFILE ${object}.d VERBATIM COMMENT "Compiling ${name}.cpp to WebAssembly")
        list(APPEND objects ${object})
    endforeach()
    add_custom_command(OUTPUT ${built}/module.wasm
        COMMAND ${KITH_WASM_COMPILER} --target=wasm32-wasi -mexec-model=reactor -Wl,--strip-all ${objects} -o ${built}/module.wasm
        DEPENDS ${objects} VERBATIM)
    file(GLOB parts CONFIGURE_DEPENDS ${sources}/*.html ${sources}/*.css ${sources}/*.js)
    add_custom_command(OUTPUT ${built}/page.cpp
        COMMAND ${CMAKE_COMMAND} -DSOURCES=${sources} -DMODULE=${built}/module.wasm -DPAGE_CPP=${built}/page.cpp
            -P ${sources}/make_page.cmake
        DEPENDS ${built}/module.wasm ${parts} ${sources}/make_page.cmake VERBATIM)
endfunction()
