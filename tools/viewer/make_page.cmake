# Writes PAGE_CPP, the page as a C++ string: page.html of SOURCES with its style, its scripts and the WebAssembly module.
file(READ ${SOURCES}/page.css STYLE)
set(SCRIPT)
foreach(name library camera renderer page)
    file(READ ${SOURCES}/${name}.js script)
    string(APPEND SCRIPT "${script}\n")
endforeach()
execute_process(COMMAND base64 -w 0 ${MODULE} OUTPUT_VARIABLE LIBRARY COMMAND_ERROR_IS_FATAL ANY)
set(CONTENT "@CONTENT@") # the program fills this in
configure_file(${SOURCES}/page.html ${PAGE_CPP}.html @ONLY)
file(READ ${PAGE_CPP}.html page)
file(WRITE ${PAGE_CPP} "#include \"viewer/page.hpp\"\n\nconst std::string_view kith::tool::viewer_page = R\"kith(${page})kith\";\n")
