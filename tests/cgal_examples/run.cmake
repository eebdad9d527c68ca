# run(COMMAND...): refuses to go on where it fails, with what it said.
function(run)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(failed)
        message(FATAL_ERROR "${ARGN}\n${said}")
    endif()
endfunction()

separate_arguments(FLAGS)
separate_arguments(LIBRARIES)
