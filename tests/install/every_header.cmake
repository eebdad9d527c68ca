# A header that is not listed in CMakeLists.txt works in the source tree and is missing once kith is installed.
file(GLOB written RELATIVE ${SOURCE} ${SOURCE}/include/kith/*.hpp ${SOURCE}/schemes/kith/*.hpp
    ${SOURCE}/adapters/kith/*.hpp ${SOURCE}/distributed/kith/*.hpp ${SOURCE}/io/kith/*.hpp)
foreach(header IN LISTS written)
    get_filename_component(name ${header} NAME)
    if(NOT EXISTS ${PREFIX}/include/kith/${name})
        message(SEND_ERROR "${header} is not installed; list it in CMakeLists.txt")
    endif()
endforeach()
