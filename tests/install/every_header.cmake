# A header that no pattern in CMakeLists.txt matches works in the source tree and is missing once kith is installed.
file(GLOB_RECURSE written RELATIVE ${SOURCE} ${SOURCE}/include/kith/*.hpp ${SOURCE}/schemes/kith/*.hpp
    ${SOURCE}/adapters/kith/*.hpp ${SOURCE}/distributed/kith/*.hpp ${SOURCE}/io/kith/*.hpp
    ${SOURCE}/picture/kith/*.hpp)
foreach(header IN LISTS written)
    string(REGEX MATCH "kith/.*" name ${header}) # without the root
    if(NOT EXISTS ${PREFIX}/include/${name})
        message(SEND_ERROR "${header} is not installed; the patterns in CMakeLists.txt leave it out")
    endif()
endforeach()
