# Builds a target that must not compile, and compares the first error with a regular expression:
# cmake -D BUILD_DIR=... -D TARGET=... -D EXPECTED=... -P check_first_error.cmake

execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD_DIR}" --target "${TARGET}"
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "${TARGET} compiles")
endif()
string(REGEX MATCH "error: [^\n]*" first_error "${output}")
if(NOT first_error MATCHES "${EXPECTED}")
  message(FATAL_ERROR "The first error is \"${first_error}\", not one that matches \"${EXPECTED}\".\n${output}")
endif()
