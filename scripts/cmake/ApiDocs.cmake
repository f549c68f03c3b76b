# cmake -DSOURCE=folder -DOUT=folder -DVERSION=x.y.z -P ApiDocs.cmake: builds the API documentation; warnings are errors.
find_program(DOXYGEN doxygen REQUIRED)
file(MAKE_DIRECTORY ${OUT})
set(ENV{ABSTAND_VERSION} ${VERSION})
set(ENV{ABSTAND_DOCS} ${OUT})
execute_process(COMMAND ${DOXYGEN} docs/Doxyfile WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE result ERROR_VARIABLE errors
  OUTPUT_QUIET)
if(NOT result EQUAL 0 OR NOT EXISTS ${OUT}/html/index.html)
  message(FATAL_ERROR "doxygen: ${result}\n${errors}")
endif()
message("${OUT}/html/index.html")
