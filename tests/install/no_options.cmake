# cmake -D COMMANDS=<compile_commands.json> -P no_options.cmake: no command has an option for code that kith asks for.
file(READ ${COMMANDS} commands)
if(commands MATCHES " -f[^ ]+")
    message(FATAL_ERROR "a target that wants no options of kith has${CMAKE_MATCH_0}")
endif()
